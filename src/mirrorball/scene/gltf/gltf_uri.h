#pragma once

#include <string>
#include <string_view>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball::gltf {

/// Whether a uri has the bytes itself (RFC 2397): "data:image/png;base64,iVBO…".
bool isData(std::string_view uri);

/// The bytes of such a uri, whatever type it says they are: base64, of either alphabet of RFC 4648, with blanks and
/// lines as some programs break it; without the word base64 the bytes as they stand, of which some are percent-encoded.
///
/// key      what holds the uri, for messages
/// errors   bad_file
Result<Bytes> decodeData(const std::string& uri, const std::string& key);

/// Turns "%20" into a space (RFC 3986, section 2.1); a '%' without two digits stays.
std::string percentDecoded(std::string_view text);

}  // namespace mirrorball::gltf
