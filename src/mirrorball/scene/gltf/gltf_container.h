#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"

namespace mirrorball::gltf {

/// The two parts of a glTF file.
struct Container {
  std::string_view json;                      ///< without a byte-order mark before it and zeros behind
  std::span<const std::uint8_t> binary = {};  ///< of a .glb with a second chunk
};

/// Finds the parts of a .glb or .gltf, which its first bytes show, whatever its name is.
///
/// bytes    must live as long as the result, which points into them
/// remarks  reports where lengths are not those of the file; what a file lacks at its end is missing in the binary part
/// errors   bad_file (no JSON, or not all of it); unsupported (another version)
Result<Container> takeApart(std::span<const std::uint8_t> bytes, Remarks& remarks);

}  // namespace mirrorball::gltf
