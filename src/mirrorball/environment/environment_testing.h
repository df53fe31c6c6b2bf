#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"

namespace mirrorball::testing {

/// Every projection, a photographed ball also from close by.
inline constexpr std::array<Projection, 11> kEveryProjection{
    Projection::equirect,       Projection::sphere,         Projection::angular,    Projection::cube,
    Projection::ball,           Projection::ballFrom(1.5f), Projection::paraboloid, Projection::octahedral,
    Projection::hemioctahedral, Projection::equal_area,     Projection::eac};

/// A projection as a part of a test's name, which may hold letters, digits and '_'.
inline std::string testName(Projection projection) {
  std::string name = textOf(projection);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::string_view(":=.-").find(c) != std::string_view::npos; }, '_');
  return name;
}

/// Directions spread evenly over the sphere (Fibonacci lattice).
inline std::vector<glm::vec3> manyDirections(int count = 2000) {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float angle = 2.39996323f * static_cast<float>(i);
    const float radius = std::sqrt(1.0f - y * y);
    directions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return directions;
}

/// A face of a cube each of whose texels holds its own unit direction.
inline Image directionsOfFace(int face, int side) {
  Image image(side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::vec3 d = directionAt(Projection::cube, {face, (glm::vec2(x, y) + 0.5f) / static_cast<float>(side)});
      std::copy_n(&d.x, 3, image.texel(x, y));
    }
  return image;
}

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
  for (const glm::vec3 d : manyDirections(60000)) {
    if (!counts(d)) continue;
    const glm::vec3 difference = a.radiance(d) - b.radiance(d);
    sum += double(glm::dot(difference, difference)) / 3.0;
    ++count;
  }
  return -10.0 * std::log10(sum / count);
}

}  // namespace mirrorball::testing
