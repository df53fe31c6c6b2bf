#include "mirrorball/metric/picture/heat_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/metric/picture/color_ramp.h"

namespace mirrorball {
namespace {

template <typename Color>
Image8 coloredBy(const Image& numbers, const Color& colorOf) {
  assert(numbers.channels() == 1);
  constexpr std::size_t kRowsPerPiece = 16;
  Image8 map = Image8::withoutValues(numbers.width(), numbers.height(), 3);
  parallelFor(std::size_t(numbers.height()), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < numbers.width(); ++x) {
        const glm::vec3 color = colorOf(*numbers.texel(x, y));
        for (int channel = 0; channel < 3; ++channel)
          map.texel(x, y)[channel] = static_cast<std::uint8_t>(color[channel] * 255.0f + 0.5f);
      }
  });
  return map;
}

std::vector<float> magnitudesFrom(float min, const Image& difference) {
  std::vector<float> magnitudes;
  for (const float number : difference.samples())
    if (std::abs(number) >= min) magnitudes.push_back(std::abs(number));
  return magnitudes;
}

/// The least of 1, 2 and 5 times a power of ten that is not below `number`, as far as there are floats.
float roundedUp(float number) {
  constexpr auto kLargest = double(std::numeric_limits<float>::max());
  const double power = std::pow(10.0, std::floor(std::log10(double(number))));
  for (const double digit : {1.0, 2.0, 5.0})
    if (const auto rounded = static_cast<float>(std::min(digit * power, kLargest)); rounded >= number) return rounded;
  return static_cast<float>(std::min(10.0 * power, kLargest));
}

}  // namespace

Image8 signedHeatMap(const Image& difference, float scale) {
  return coloredBy(difference, [scale](float number) { return divergingColor(number / scale); });
}

float usualScale(const Image& difference) {
  constexpr double kShown = 0.99;
  // Differences that are no more than rounding may be in every pixel, and those that count in few.
  std::vector<float> magnitudes = magnitudesFrom(1.0f / 255.0f, difference);
  if (magnitudes.empty()) magnitudes = magnitudesFrom(std::numeric_limits<float>::denorm_min(), difference);
  if (magnitudes.empty()) return 1.0f;
  const auto rank = std::ptrdiff_t(kShown * static_cast<double>(magnitudes.size() - 1));
  std::nth_element(magnitudes.begin(), magnitudes.begin() + rank, magnitudes.end());
  return roundedUp(std::max(magnitudes[std::size_t(rank)], 1e-30f));
}

Image8 flipHeatMap(const Image& flip) { return coloredBy(flip, sequentialColor); }

}  // namespace mirrorball
