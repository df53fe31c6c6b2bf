#include "mirrorball/view/inspect/screen_lines.h"

#include <cmath>

namespace mirrorball {
namespace {

/// How far a point in clip space lies behind the near plane, where z = −w; at most 0: before it.
float behindNearPlane(glm::vec4 clip) { return -(clip.z + clip.w); }

glm::vec2 pixelOf(glm::vec4 clip, glm::ivec2 size) {
  const glm::vec2 ndc = glm::vec2(clip) / clip.w;
  return glm::vec2(1.0f + ndc.x, 1.0f - ndc.y) * 0.5f * glm::vec2(size);
}

}  // namespace

std::vector<ScreenLine> projected(const RayPath& path, const Camera& camera, glm::ivec2 size) {
  const glm::mat4 clip_from_world = camera.clip_from_view * camera.view_from_world;
  std::vector<ScreenLine> lines;
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    glm::vec4 from = clip_from_world * glm::vec4(path.segments[i].from, 1.0f);
    glm::vec4 to = clip_from_world * glm::vec4(path.segments[i].to, 1.0f);
    const float from_behind = behindNearPlane(from);
    const float to_behind = behindNearPlane(to);
    const bool is_before = from_behind < 0.0f || to_behind < 0.0f;
    if (!is_before || !std::isfinite(from_behind + to_behind)) continue;
    const glm::vec4 cut = from + from_behind / (from_behind - to_behind) * (to - from);
    if (from_behind > 0.0f) from = cut;
    if (to_behind > 0.0f) to = cut;
    lines.push_back({pixelOf(from, size), pixelOf(to, size), i});
  }
  return lines;
}

}  // namespace mirrorball
