#pragma once

#include <optional>
#include <string>

#include "cli/surface_maps.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::cli {

// What several commands ask of the rooms that trace rays.

/// Finds what a scene's vertices see of the sky, or takes it from the cache.
///
/// scene     cut where its triangles are too large to tell, unless they themselves are what is shown
/// errors    as findOcclusionOnce's
Result<void> findSceneOcclusion(Scene& scene, const FrameSettings& look, const std::optional<CacheFolder>& cache);

/// A normal map of a model in the other space; one of tangents has green up or down.
///
/// input    its name
/// errors   as loadModel's and normalsInSpace's
Result<MadeMap> normalsOfModel(Image normals, const std::string& input, const SurfaceOptions& options);

}  // namespace mirrorball::cli
