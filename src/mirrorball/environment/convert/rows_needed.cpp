#include "mirrorball/environment/convert/rows_needed.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formula/constants.h"

namespace mirrorball {
namespace {

/// Directions are taken on a grid: at every fourth corner of texels, and in five places across the smallest strip. What
/// lies between is no farther from one of them than they are from each other.
constexpr int kTexelsPerStep = 4;
constexpr int kMinSteps = 4;

/// Rows that an interpolation reads beside a direction's own, and what single precision may be off by.
constexpr int kMargin = 4;

/// A place on a disc: itself, or the rim's nearest point.
glm::vec2 ontoDisc(glm::vec2 uv) {
  constexpr float kJustInside = 0.5f - 1e-6f;
  const glm::vec2 from_center = uv - 0.5f;
  const float radius = glm::length(from_center);
  return radius > kJustInside ? 0.5f + from_center * (kJustInside / radius) : uv;
}

std::vector<float> gridLines(int begin, int end) {
  const int steps = std::max(kMinSteps, (end - begin + kTexelsPerStep - 1) / kTexelsPerStep);
  std::vector<float> lines;
  for (int step = 0; step <= steps; ++step)
    lines.push_back(glm::mix(static_cast<float>(begin), static_cast<float>(end),
                             static_cast<float>(step) / static_cast<float>(steps)));
  return lines;
}

float angleBetween(glm::vec3 a, glm::vec3 b) { return 2.0f * std::asin(std::min(glm::length(a - b) / 2.0f, 1.0f)); }

}  // namespace

RowRange rowsNeeded(const Conversion& conversion, const Strip& strip, int height) {
  const std::vector<float> columns = gridLines(strip.begin.x, strip.end.x);
  const bool has_disc = hasDisc(conversion.to());
  std::vector<glm::vec3> above;
  float min = formula::kPi;
  float max = 0.0f;
  float spacing = 0.0f;
  for (const float y : gridLines(strip.begin.y, strip.end.y)) {
    std::vector<glm::vec3> line;
    for (const float x : columns) {
      const glm::vec2 uv = glm::vec2(x, y) / glm::vec2(conversion.extent());
      const glm::vec3 direction =
          conversion.sourceFromTarget() * directionAt(conversion.to(), {strip.face, has_disc ? ontoDisc(uv) : uv});
      const float polar = std::acos(glm::clamp(direction.y, -1.0f, 1.0f));
      min = std::min(min, polar);
      max = std::max(max, polar);
      if (!line.empty()) spacing = std::max(spacing, angleBetween(line.back(), direction));
      if (!above.empty()) spacing = std::max(spacing, angleBetween(above[line.size()], direction));
      line.push_back(direction);
    }
    above = std::move(line);
  }
  const float rows_per_radian = static_cast<float>(height) / formula::kPi;
  const int begin = static_cast<int>((min - spacing) * rows_per_radian) - kMargin;
  const int end = static_cast<int>((max + spacing) * rows_per_radian) + 1 + kMargin;
  return {std::clamp(begin, 0, height), std::clamp(end, 0, height)};
}

}  // namespace mirrorball
