#pragma once

#include <span>
#include <string>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// A .glb file: glTF's JSON and, unless it is empty, its one buffer.
///
/// errors   too_large (a length is no 32-bit number)
/// from     glTF 2.0, "GLB File Format Specification"
Result<Bytes> glbFile(std::string json, std::span<const std::uint8_t> buffer);

}  // namespace mirrorball
