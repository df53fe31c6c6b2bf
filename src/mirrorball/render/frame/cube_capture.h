#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where light is captured, and how.
struct CaptureSettings {
  glm::vec3 position{0.0f};          ///< world; finite
  Projection to = Projection::cube;  ///< of the map
  int size = 256;                    ///< of the map [texels], at least 1: the side of a face, or as imagesFor has it
  /// The distance of the near plane [world units]; without it, depthsAround chooses one.
  std::optional<float> nearest = {};
  FrameSettings frame = {};  ///< all other settings; its size, camera, exposure and tone map are not used
};

/// Draws the light that arrives at a point of a scene: the six faces of a cube, each a square frame with an angle of
/// view of 90°.
///
/// Between the faces there is no seam: a frame's samples lie within its pixels, and so within its face; what each shows
/// depends on its direction alone. Only `Mapping::sphere`, which is right for one viewing direction, breaks this rule.
///
/// progress  is called after each sample of each face's pixels, and while they are converted
/// returns   the map, three channels of linear radiance: a cube, or what is converted from one that has all the detail
///           that the other projection will show. Black where the background is transparent
/// errors    as Renderer::draw's; too_large
/// cost      six frames
Result<EnvironmentMap> captureEnvironment(Renderer& renderer, const CaptureSettings& settings,
                                          const ProgressFunction& progress = {});

/// What is doubtful about a place at which light is captured, in one line: that the scene is far away, since a model's
/// unit is often another than one thinks.
///
/// scene    bounds of it
std::optional<std::string> doubtOfPlace(glm::vec3 position, const BoundingSphere& scene);

}  // namespace mirrorball
