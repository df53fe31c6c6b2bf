#pragma once

#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// Under this key Filament's KTX files hold the harmonics of their irradiance (bake/harmonics/filament_harmonics.h).
inline constexpr const char* kFilamentHarmonicsKey = "sh";

/// Whether `key` is one of ours: "envmap", "sh", or "mirrorball:" and a word. All others in a file are left unread.
bool isMetadataKey(std::string_view key);

/// Refuses metadata that not every format can hold: foreign keys, an unknown envmap, texts beyond
/// printable ASCII.
///
/// errors   usage
Result<void> checkMetadata(const Metadata& metadata);

/// "key=value": how one entry stands in a comment of a Radiance or JPEG file.
std::string metadataLine(const std::string& key, const std::string& value);

/// Takes up a comment if it is such a line with a key of ours; other comments are left alone.
void readMetadataLine(std::string_view line, Metadata& metadata);

}  // namespace mirrorball
