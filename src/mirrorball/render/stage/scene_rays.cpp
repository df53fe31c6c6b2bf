#include "mirrorball/render/stage/scene_rays.h"

#include <algorithm>
#include <utility>

namespace mirrorball {

Result<SceneRays> SceneRays::make(std::shared_ptr<const Scene> scene) {
  MIRRORBALL_TRY(geometry, Geometry::make(*scene));
  const auto can_be_searched = [](const HeightTexture& each) { return !each.picture.empty(); };
  const auto& heights = scene->height_textures;
  if (std::all_of(heights.begin(), heights.end(), can_be_searched)) MIRRORBALL_TRY_VOID(geometry.makeReliefs(*scene));
  return Result<SceneRays>(SceneRays{std::move(scene), std::move(geometry)});
}

}  // namespace mirrorball
