#include "mirrorball/bake/light_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
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

/// The light of a row's texels, of those that count.
std::vector<glm::vec3> lightOfRow(const Image& image, int y, const std::vector<bool>& is_left_out) {
  std::vector<glm::vec3> light(std::size_t(image.width()), glm::vec3(0.0f));
  for (std::size_t x = 0; x < light.size(); ++x)
    if (is_left_out.empty() || !is_left_out[x]) light[x] = rgbAt(image, static_cast<int>(x), y);
  return light;
}

RowSums sumsOfRow(std::span<const glm::vec3> above, std::span<const glm::vec3> row, std::span<const glm::vec3> below) {
  RowSums sums;
  const std::size_t width = row.size();
  glm::vec3 squares(0.0f);
  for (std::size_t x = 0; x < width; ++x) {
    const glm::vec3 beside = row[x > 0 ? x - 1 : width - 1] + row[x + 1 < width ? x + 1 : 0];
    const glm::vec3 difference = row[x] - 0.25f * (beside + above[x] + below[x]);
    squares += difference * difference;
    sums.parts[x * kPartsAcross / width] += row[x];
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
  const auto lightOf = [&](std::size_t y) { return lightOfRow(image, static_cast<int>(y), left_out[y]); };
  parallelFor(height, 16, [&](std::size_t begin, std::size_t end) {
    std::vector<glm::vec3> above = lightOf(begin > 0 ? begin - 1 : begin);
    std::vector<glm::vec3> here = lightOf(begin);
    for (std::size_t y = begin; y < end; ++y) {
      std::vector<glm::vec3> below = y + 1 < height ? lightOf(y + 1) : here;
      rows[y] = sumsOfRow(above, here, below);
      above = std::move(here);
      here = std::move(below);
    }
  });

  glm::dvec3 power(0.0);
  std::array<std::array<glm::vec3, kPartsAcross>, kPartsDown> parts{};
  for (std::size_t y = 0; y < height; ++y) {
    const auto weight =
        static_cast<double>(texelSolidAngle(Projection::equirect, panorama.extent(), {0, static_cast<int>(y)}));
    power += rows[y].squares * (weight * weight * 4.0 / 5.0);
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
