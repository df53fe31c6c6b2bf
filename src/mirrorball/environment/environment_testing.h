#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball::testing {

/// Every projection, a photographed ball also from close by.
inline constexpr std::array<Projection, 11> kEveryProjection{
    Projection::equirect,       Projection::sphere,         Projection::angular,    Projection::cube,
    Projection::ball,           Projection::ballFrom(1.5f), Projection::paraboloid, Projection::octahedral,
    Projection::hemioctahedral, Projection::equal_area,     Projection::eac};
static_assert(kEveryProjection.size() == Projection::kKinds + 1, "every kind, and a ball seen from nearby");

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

/// Waves of many directions, no shorter than 2π / 60 rad, with a root mean square of 0.25 about 1.25: light, which is
/// nowhere negative.
inline glm::vec3 waves(glm::vec3 d) {
  float sum = 0.0f;
  for (int i = 0; i < 12; ++i) {
    const float y = 1.0f - (static_cast<float>(i) + 0.5f) / 6.0f;
    const float angle = 2.39996323f * static_cast<float>(i);
    const glm::vec3 along(std::sqrt(1.0f - y * y) * std::cos(angle), y, std::sqrt(1.0f - y * y) * std::sin(angle));
    sum += std::cos(60.0f * glm::dot(along, d) + angle);
  }
  return glm::vec3(1.25f + 0.1f * sum);
}

/// ∫ L dω.
inline double fluxOf(const EnvironmentMap& map) {
  double flux = 0.0;
  const glm::ivec2 extent = map.extent();
  for (int face = 0; face < map.faces(); ++face)
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x)
        if (const float light = rgbAt(map.face(face), x, y).x; light != 0.0f)
          flux += double(light) * double(texelSolidAngle(map.projection(), extent, {x, y}));
  return flux;
}

/// Whether a map of small images ends there without a neighbour: near the edge of a map of one half, and straight
/// behind on a disc that shows everything, where every point of the rim is the same direction, but texels are not.
inline bool isEnd(Projection projection, glm::vec3 d) {
  switch (projection) {
    case Projection::angular:
      return d.z < -0.995f;
    case Projection::hemioctahedral:
      return d.z < 0.001f;
    case Projection::sphere:
      return d.z < -0.8f;
    case Projection::ball:
      return d.z < (projection.ball_distance < 2.0f ? -0.5f : -0.8f);
    default:
      return false;
  }
}

/// The largest change of a map's light over a step of a third of a milliradian along circles that cross every seam,
/// edge, corner and pole. Steps from or to a direction for which `counts` does not hold are left out.
template <typename Counts>
float largestStep(const EnvironmentMap& map, Counts&& counts) {
  const float diagonal = std::sqrt(0.5f);
  const std::array<glm::mat2x3, 5> circles{{{{1, 0, 0}, {0, 1, 0}},
                                            {{1, 0, 0}, {0, 0, 1}},
                                            {{0, 1, 0}, {0, 0, 1}},
                                            {{1, 0, 0}, {0, diagonal, diagonal}},
                                            {{diagonal, diagonal, 0}, {0, 0, 1}}}};
  constexpr int kSteps = 20000;
  float largest = 0.0f;
  for (const glm::mat2x3& circle : circles) {
    glm::vec3 before = map.radiance(circle[0]);
    bool before_counts = counts(circle[0]);
    for (int step = 1; step <= kSteps; ++step) {
      const float angle = 6.2831853f * static_cast<float>(step) / kSteps;
      const glm::vec3 direction = circle * glm::vec2(std::cos(angle), std::sin(angle));
      const glm::vec3 here = map.radiance(direction);
      const bool here_counts = counts(direction);
      if (before_counts && here_counts) largest = std::max(largest, glm::length(here - before));
      before = here;
      before_counts = here_counts;
    }
  }
  return largest;
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
