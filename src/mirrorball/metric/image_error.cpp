#include "mirrorball/metric/image_error.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerSum = 16;

[[maybe_unused]] bool areAlike(const Image& a, const Image& b) {
  return a.width() == b.width() && a.height() == b.height() && a.channels() == b.channels() && !a.empty();
}

/// Sums over one row; `worst` is its pixel, and of the means there are the sums only.
ImageError sumsOfRow(const Image& a, const Image& b, int y) {
  const std::span<const float> row_a = a.row(y);
  const std::span<const float> row_b = b.row(y);
  const auto channels = std::size_t(a.channels());
  ImageError sums;
  sums.worst = {0, y};
  for (std::size_t pixel = 0; pixel < std::size_t(a.width()); ++pixel) {
    float max = 0.0f;
    for (std::size_t i = pixel * channels; i < (pixel + 1) * channels; ++i) {
      const double difference = double(row_a[i]) - double(row_b[i]);
      const double square = difference * difference;
      sums.mean_square += square;
      sums.relative_mean_square += square / (double(row_b[i]) * double(row_b[i]) + kRelativeEpsilon);
      max = std::max(max, std::abs(row_a[i] - row_b[i]));
    }
    sums.mean_of_worst += double(max);
    if (max <= sums.max) continue;
    sums.max = max;
    sums.worst.x = static_cast<int>(pixel);
  }
  return sums;
}

}  // namespace

ImageError imageError(const Image& a, const Image& b) {
  assert(areAlike(a, b));
  // Rows are summed by themselves and then in their order, so that nothing depends on who summed them.
  std::vector<ImageError> rows(std::size_t(a.height()));
  parallelFor(rows.size(), kRowsPerSum, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) rows[y] = sumsOfRow(a, b, static_cast<int>(y));
  });
  ImageError error;
  for (const ImageError& row : rows) {
    error.mean_square += row.mean_square;
    error.relative_mean_square += row.relative_mean_square;
    error.mean_of_worst += row.mean_of_worst;
    if (row.max <= error.max) continue;
    error.max = row.max;
    error.worst = row.worst;
  }
  error.mean_square /= static_cast<double>(a.samples().size());
  error.relative_mean_square /= static_cast<double>(a.samples().size());
  error.mean_of_worst /= static_cast<double>(a.texelCount());
  return error;
}

double peakSignalToNoise_db(double mean_square) {
  return mean_square > 0.0 ? -10.0 * std::log10(mean_square) : std::numeric_limits<double>::infinity();
}

Image signedDifference(const Image& a, const Image& b) {
  assert(areAlike(a, b));
  Image differences = Image::withoutValues(a.width(), a.height(), 1);
  parallelFor(std::size_t(a.height()), kRowsPerSum, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < a.width(); ++x) {
        float farthest = 0.0f;
        for (int channel = 0; channel < a.channels(); ++channel) {
          const float difference = a.texel(x, y)[channel] - b.texel(x, y)[channel];
          if (std::abs(difference) > std::abs(farthest)) farthest = difference;
        }
        *differences.texel(x, y) = farthest;
      }
  });
  return differences;
}

}  // namespace mirrorball
