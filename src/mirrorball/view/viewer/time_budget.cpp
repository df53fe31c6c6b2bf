#include "mirrorball/view/viewer/time_budget.h"

#include <algorithm>
#include <array>

namespace mirrorball {
namespace {

constexpr std::array<float, 5> kScales{1.0f, 0.75f, 0.5f, 0.375f, 0.25f};
constexpr double kLeastPixels = 640.0 * 360.0;

double pixelsOf(glm::ivec2 size_px) { return double(size_px.x) * double(size_px.y); }

glm::ivec2 scaled(glm::ivec2 window_px, float scale) {
  return glm::max(glm::ivec2(glm::round(glm::vec2(window_px) * scale)), glm::ivec2(1));
}

}  // namespace

glm::ivec2 TimeBudget::sizeFor(glm::ivec2 window_px) const {
  glm::ivec2 size_px = scaled(window_px, 1.0f);
  for (const float scale : kScales) {
    const glm::ivec2 smaller_px = scaled(window_px, scale);
    if (scale < 1.0f && pixelsOf(smaller_px) < kLeastPixels) break;
    size_px = smaller_px;
    if (pixelsOf(size_px) * seconds_per_pixel_ <= frame_s_) break;
  }
  return size_px;
}

void TimeBudget::drew(glm::ivec2 size_px, double seconds) {
  if (!(seconds > 0.0)) return;
  const double now = seconds / std::max(pixelsOf(size_px), 1.0);
  // A picture that something else delayed counts for little; what becomes slower for good is known after some.
  constexpr double kShareOfLast = 0.3;
  seconds_per_pixel_ = seconds_per_pixel_ > 0.0 ? seconds_per_pixel_ + kShareOfLast * (now - seconds_per_pixel_) : now;
}

}  // namespace mirrorball
