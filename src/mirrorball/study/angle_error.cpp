#include "mirrorball/study/angle_error.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/metric/image_error.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

constexpr std::size_t kFewestPixels = 16;

/// From the eye through the middle of a pixel, unit.
glm::vec3 rayThrough(const Camera& camera, const glm::mat4& world_from_clip, glm::ivec2 pixel, glm::ivec2 size) {
  if (camera.orthographic) return camera.forward;
  const glm::vec2 share = (glm::vec2(pixel) + 0.5f) / glm::vec2(size);
  const glm::vec4 place = world_from_clip * glm::vec4(2.0f * share.x - 1.0f, 1.0f - 2.0f * share.y, 0.0f, 1.0f);
  return glm::normalize(glm::vec3(place) / place.w - camera.position);
}

}  // namespace

Environment environmentOfDirections() {
  return Environment([](glm::vec3 direction) { return 0.5f * direction + 0.5f; }, 64);
}

Result<Image> cosinesOf(Renderer& renderer, Scene scene, const FrameSettings& frame) {
  MIRRORBALL_TRY_VOID(changeMaterials(scene, {.material = "mirror"}));
  scene.lights.clear();
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(scene)));
  const FrameSettings of_normals{.size = frame.size,
                                 .camera = frame.camera,
                                 .background = BackgroundKind::transparent,
                                 .samples = 16,
                                 .mapping = Mapping::normal};
  MIRRORBALL_TRY(normals, renderer.renderRadiance(of_normals));
  MIRRORBALL_TRY(camera, framedCamera(renderer.scene(), renderer.bounds(), frame.camera, frame.size));
  const glm::mat4 world_from_clip = glm::inverse(camera.clip_from_view * camera.view_from_world);
  Image cosines(frame.size.x, frame.size.y, 1, -1.0f);
  for (int y = 0; y < frame.size.y; ++y)
    for (int x = 0; x < frame.size.x; ++x) {
      if (normals.texel(x, y)[3] < 0.999f) continue;
      const glm::vec3 normal = glm::normalize(2.0f * rgbAt(normals, x, y) - 1.0f);
      const glm::vec3 ray = rayThrough(camera, world_from_clip, {x, y}, frame.size);
      *cosines.texel(x, y) = std::clamp(-glm::dot(ray, normal), 0.0f, 1.0f);
    }
  return cosines;
}

ErrorByAngle errorByAngle(const Image& test, const Image& reference, const Image& cosines) {
  std::array<double, kAngleSteps> sums{};
  std::array<std::size_t, kAngleSteps> counts{};
  for (int y = 0; y < cosines.height(); ++y)
    for (int x = 0; x < cosines.width(); ++x) {
      const float cosine = *cosines.texel(x, y);
      if (cosine < 0.0f) continue;
      const auto step = std::min(static_cast<std::size_t>(cosine * float{kAngleSteps}), kAngleSteps - 1);
      const glm::dvec3 right(rgbAt(reference, x, y));
      const glm::dvec3 difference = glm::dvec3(rgbAt(test, x, y)) - right;
      const glm::dvec3 relative = difference * difference / (right * right + kRelativeEpsilon);
      sums[step] += (relative.x + relative.y + relative.z) / 3.0;
      ++counts[step];
    }
  ErrorByAngle errors;
  for (std::size_t step = 0; step < kAngleSteps; ++step)
    if (counts[step] >= kFewestPixels) errors[step] = std::sqrt(sums[step] / static_cast<double>(counts[step]));
  return errors;
}

}  // namespace mirrorball
