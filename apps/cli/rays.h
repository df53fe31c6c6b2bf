#pragma once

#include <optional>
#include <string>

#include "cli/surface_maps.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::cli {

/// What commands ask of the rooms that trace rays, beside those that are about nothing else (study_command.cpp,
/// render_reference.h and the like). A build without Embree has none of those rooms: rays_absent.cpp stands for all of
/// these files, and fails by one line.

bool tracesRays();

/// Finds what a scene's vertices see of the sky, or takes it from the cache.
///
/// finds_looks   also what is seen in all directions, of --self-reflection
/// errors        as findOcclusionOnce's; unsupported: !tracesRays()
Result<void> findSceneOcclusion(Scene& scene, bool finds_looks, const std::optional<CacheFolder>& cache);

/// A normal map of a model in the other space; one of tangents has green up or down.
///
/// input    its name
/// errors   as loadModel's and normalsInSpace's; unsupported: !tracesRays()
Result<MadeMap> normalsOfModel(Image normals, const std::string& input, const SurfaceOptions& options);

}  // namespace mirrorball::cli
