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
/// bytes      all of the file or, of a long one, what its headers have room in; begin with OpenEXR's magic number
/// file_size  in bytes
/// errors     bad_file (the byte is named); too_large
/// from       the OpenEXR file layout, "Header" and "Predefined attribute types"
Result<void> checkExrSizes(std::span<const std::uint8_t> bytes, std::uint64_t file_size);

}  // namespace mirrorball
