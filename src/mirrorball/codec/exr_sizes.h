#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Walks over the headers of an OpenEXR file and checks every size in them against the file's own,
/// since OpenEXR takes memory by what they say: the attributes' sizes, the data windows, the tiles,
/// the counts of chunks.
///
/// bytes    begin with OpenEXR's magic number
/// errors   bad_file (the byte is named); too_large
/// from     the OpenEXR file layout, "Header" and "Predefined attribute types"
Result<void> checkExrSizes(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace mirrorball
