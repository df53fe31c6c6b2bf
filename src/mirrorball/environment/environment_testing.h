#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"

namespace mirrorball::testing {

/// Smooth light of all directions, between about 0.2 and 1.8: no two projections may disagree on it by much.
inline glm::vec3 smoothRadiance(glm::vec3 d) {
  return {1.0f + 0.5f * d.x + 0.3f * d.y * d.z, 1.0f + 0.6f * d.y - 0.2f * d.x * d.z,
          1.0f + 0.7f * d.z * d.z - 0.3f * d.x};
}

/// Peak signal-to-noise ratio in dB over the directions of a dense lattice for which `counts` holds, for a peak of 1.
template <typename Counts>
double psnr(const Environment& a, const Environment& b, Counts&& counts) {
  double sum = 0.0;
  int count = 0;
  constexpr int kDirections = 60000;
  for (int i = 0; i < kDirections; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / kDirections;
    const float angle = 2.39996323f * static_cast<float>(i);
    const float radius = std::sqrt(1.0f - y * y);
    const glm::vec3 d(radius * std::cos(angle), y, radius * std::sin(angle));
    if (!counts(d)) continue;
    const glm::vec3 difference = a.radiance(d) - b.radiance(d);
    sum += double(glm::dot(difference, difference)) / 3.0;
    ++count;
  }
  return -10.0 * std::log10(sum / count);
}

}  // namespace mirrorball::testing
