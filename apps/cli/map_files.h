#pragma once

#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/cube_layout.h"

namespace mirrorball::cli {

/// Writes a map: one picture, or the six files of a cube whose layout is `faces`. Its projection and layout are kept in
/// the file's metadata.
///
/// half     16-bit floats in .exr
/// errors   as writeImage's
Result<void> writeMap(const EnvironmentMap& map, CubeLayout layout, bool half, const std::string& output);

}  // namespace mirrorball::cli
