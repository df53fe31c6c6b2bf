#include "mirrorball/metric/flip/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/metric/flip/flip_color.h"
#include "mirrorball/metric/flip/flip_filters.h"
#include "mirrorball/metric/flip/flip_tile.h"

namespace mirrorball {
namespace {

using flip::Tile;

/// What an image's texel shows on the display that the observer looks at.
using Shown = std::function<glm::vec3(glm::vec3 light)>;

// Andersson et al. 2020, table 1.
constexpr float kColorExponent = 0.7f;
constexpr float kFeatureExponent = 0.5f;
constexpr float kLargeDistance =
    0.4f;                             ///< share of the greatest distance of colours from which on they differ strongly
constexpr float kLargeError = 0.95f;  ///< the error there

/// Green against blue: the greatest distance that two colours of a display have, to the power that distances get.
float maxDistance() {
  static const float max =
      std::pow(flip::distance(flip::huntLab({0.0f, 1.0f, 0.0f}), flip::huntLab({0.0f, 0.0f, 1.0f})), kColorExponent);
  return max;
}

/// Section 4.1.3: distances that are not large take nearly all of [0, 1].
float colorError(glm::vec3 lab_a, glm::vec3 lab_b) {
  const float max = maxDistance();
  const float large = kLargeDistance * max;
  const float distance = std::pow(flip::distance(lab_a, lab_b), kColorExponent);
  if (distance < large) return distance * (kLargeError / large);
  return kLargeError + (distance - large) / (max - large) * (1.0f - kLargeError);
}

/// Sections 4.2 and 4.3: a difference of edges or points makes one of colours count for more.
float pixelError(const flip::SeenPixel& a, const flip::SeenPixel& b) {
  const float difference = std::max(std::abs(a.edge - b.edge), std::abs(a.point - b.point));
  const float feature = std::pow(difference / std::sqrt(2.0f), kFeatureExponent);
  return std::clamp(std::pow(colorError(a.lab, b.lab), 1.0f - feature), 0.0f, 1.0f);
}

/// Compares two images tile by tile, at each way to show them, and keeps the greatest error of each pixel.
Result<Image> maxError(const Image& a, const Image& b, const std::vector<Shown>& ways, float pixels_per_degree,
                       const ProgressFunction& progress) {
  assert(a.width() == b.width() && a.height() == b.height() && pixels_per_degree >= kMinPixelsPerDegree);
  const flip::Filters filters = flip::filtersFor(pixels_per_degree);
  const std::vector<Tile> tiles = flip::tilesOf(a.width(), a.height());
  Image error(a.width(), a.height(), 1);
  ProgressCounter counter(progress, tiles.size() * ways.size());
  parallelFor(tiles.size(), 1, [&](std::size_t begin, std::size_t) {
    const Tile& tile = tiles[begin];
    for (const Shown& shown : ways) {
      if (counter.stopped()) return;
      const std::vector<flip::SeenPixel> seen_a = flip::seenThrough(filters, tile, a, shown);
      const std::vector<flip::SeenPixel> seen_b = flip::seenThrough(filters, tile, b, shown);
      for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
          const std::size_t pixel = std::size_t(y) * std::size_t(tile.width) + std::size_t(x);
          float& max = *error.texel(tile.left + x, tile.top + y);
          max = std::max(max, pixelError(seen_a[pixel], seen_b[pixel]));
        }
      counter.advance();
    }
  });
  MIRRORBALL_TRY_VOID(counter.result());
  return error;
}

}  // namespace

Result<Image> ldrFlip(const Image& a, const Image& b, float pixels_per_degree, const ProgressFunction& progress) {
  return maxError(a, b, {[](glm::vec3 light) { return glm::clamp(light, 0.0f, 1.0f); }}, pixels_per_degree, progress);
}

float ExposureRange::at(int index) const {
  return count > 1 ? start_ev + static_cast<float>(index) * ((stop_ev - start_ev) / static_cast<float>(count - 1))
                   : start_ev;
}

ExposureRange exposureRangeOf(const Image& reference) {
  std::vector<float> luminances;
  luminances.reserve(reference.texelCount());
  for (int y = 0; y < reference.height(); ++y)
    for (int x = 0; x < reference.width(); ++x) luminances.push_back(formula::luminance(rgbAt(reference, x, y)));
  const auto medianOf = [](std::vector<float>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  float median = medianOf(luminances);
  if (median <= 0.0f) {
    std::erase_if(luminances, [](float luminance) { return luminance <= 0.0f; });
    if (luminances.empty()) return {};
    median = medianOf(luminances);
  }
  const float brightest = *std::max_element(luminances.begin(), luminances.end());
  const auto exposureFor = [](float luminance) {
    constexpr float kLargestStops = 126.0f;  // whose factors are floats
    return std::clamp(std::log2(flip::lightShownAs(0.85f)) - std::log2(luminance), -kLargestStops, kLargestStops);
  };
  ExposureRange range{exposureFor(brightest), exposureFor(median)};
  range.count = std::max(2, static_cast<int>(std::ceil(range.stop_ev - range.start_ev)));
  return range;
}

Result<Image> hdrFlip(const Image& test, const Image& reference, const ExposureRange& exposures,
                      float pixels_per_degree, const ProgressFunction& progress) {
  std::vector<Shown> ways;
  for (int i = 0; i < exposures.count; ++i)
    ways.emplace_back(
        [factor = std::exp2(exposures.at(i))](glm::vec3 light) { return flip::toneMapped(light * factor); });
  return maxError(test, reference, ways, pixels_per_degree, progress);
}

}  // namespace mirrorball
