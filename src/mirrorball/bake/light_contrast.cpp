#include "mirrorball/bake/light_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kPartsAcross = 32;
constexpr int kPartsDown = 16;

struct RowSums {
  glm::dvec3 squares{0.0};  // of the differences
  std::array<glm::vec3, kPartsAcross> parts{};
};

RowSums sumsOfRow(const Image& image, int y, const std::vector<bool>& is_left_out) {
  RowSums sums;
  const int width = image.width();
  const auto at = [&](int x) {
    const bool is_out = !is_left_out.empty() && is_left_out[std::size_t(x)];
    return is_out ? glm::vec3(0.0f) : rgbAt(image, x, y);
  };
  glm::vec3 squares(0.0f);
  glm::vec3 left = at(width - 1);
  glm::vec3 here = at(0);
  for (int x = 0; x < width; ++x) {
    const glm::vec3 right = at(x + 1 < width ? x + 1 : 0);
    const glm::vec3 difference = here - 0.5f * (left + right);
    squares += difference * difference;
    sums.parts[std::size_t(x) * kPartsAcross / std::size_t(width)] += here;
    left = here;
    here = right;
  }
  sums.squares = glm::dvec3(squares);
  return sums;
}

}  // namespace

float lightContrast(const EnvironmentMap& panorama, const BrightLights& without) {
  const Image& image = panorama.face(0);
  const auto height = static_cast<std::size_t>(image.height());
  std::vector<std::vector<bool>> left_out(height);
  for (const Excess& bright : without.texels) {
    std::vector<bool>& row = left_out[std::size_t(bright.texel.y)];
    row.resize(std::size_t(image.width()));
    row[std::size_t(bright.texel.x)] = true;
  }
  std::vector<RowSums> rows(height);
  parallelFor(height, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) rows[y] = sumsOfRow(image, static_cast<int>(y), left_out[y]);
  });

  glm::dvec3 power(0.0);
  std::array<std::array<glm::vec3, kPartsAcross>, kPartsDown> parts{};
  for (std::size_t y = 0; y < height; ++y) {
    const double weight = 2.0 * std::numbers::pi / image.width() *
                          (std::cos(std::numbers::pi * double(y) / double(height)) -
                           std::cos(std::numbers::pi * double(y + 1) / double(height)));
    power += rows[y].squares * (weight * weight * 2.0 / 3.0);
    for (std::size_t x = 0; x < kPartsAcross; ++x) parts[y * kPartsDown / height][x] += rows[y].parts[x];
  }
  const float texels_of_part = static_cast<float>(image.texelCount()) / (kPartsAcross * kPartsDown);
  float contrast = 0.0f;
  for (int c = 0; c < 3; ++c) {
    float darkest = std::numeric_limits<float>::infinity();
    for (const auto& row : parts)
      for (const glm::vec3& part : row) darkest = std::min(darkest, part[c] / texels_of_part);
    const auto noise = static_cast<float>(std::sqrt(power[c]));
    if (noise > 0.0f)
      contrast = std::max(contrast, darkest > 0.0f ? noise / darkest : std::numeric_limits<float>::infinity());
  }
  return contrast;
}

}  // namespace mirrorball
