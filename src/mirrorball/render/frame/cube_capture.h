#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/render/frame/renderer.h"

namespace mirrorball {

/// Where light is captured, and how.
struct CaptureSettings {
  glm::vec3 position{0.0f};  ///< world; finite
  int size = 256;            ///< side of a face [texels], at least 1
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
/// progress  is called after each sample of each face's pixels
/// returns   a cube of 6 × size × size, three channels of linear radiance. Black where the background is transparent
/// errors    as Renderer::draw's; too_large
/// cost      six frames
Result<EnvironmentMap> captureEnvironment(Renderer& renderer, const CaptureSettings& settings,
                                          const ProgressFunction& progress = {});

}  // namespace mirrorball
