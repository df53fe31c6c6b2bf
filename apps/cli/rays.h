#pragma once

#include <string>

#include "cli/surface_maps.h"

namespace mirrorball::cli {

/// A normal map of a model in the other space; one of tangents has green up or down.
///
/// input    its name
/// errors   as loadModel's and normalsInSpace's
Result<MadeMap> normalsOfModel(Image normals, const std::string& input, const SurfaceOptions& options);

}  // namespace mirrorball::cli
