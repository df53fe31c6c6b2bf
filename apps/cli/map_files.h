#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/cube_layout.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball::cli {

/// The files that a map is written to: one picture, or the six of a cube whose layout is `faces`.
std::vector<std::string> mapPaths(const std::string& output, Projection projection, CubeLayout layout);

/// Writes a map to its files. Its projection and layout are kept in their metadata.
///
/// half     16-bit floats in .exr
/// errors   as writeImage's
Result<void> writeMap(const EnvironmentMap& map, CubeLayout layout, bool half, const std::string& output);

}  // namespace mirrorball::cli
