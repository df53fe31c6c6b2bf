#include "mirrorball/metric/ssim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerWindow = 32;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

using Window = std::array<double, kSsimWindow>;

Window gaussianWindow() {
  constexpr double kSigma = 1.5;
  Window window{};
  double sum = 0.0;
  for (int i = 0; i < kSsimWindow; ++i) {
    const double distance = i - kSsimWindow / 2;
    window[std::size_t(i)] = std::exp(-distance * distance / (2.0 * kSigma * kSigma));
    sum += window[std::size_t(i)];
  }
  for (double& weight : window) weight /= sum;
  return window;
}

/// What SSIM needs to know of the pixels of a window: weighted means of a, b and their products.
struct Moments {
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;

  void add(double weight, const Moments& other) {
    a += weight * other.a;
    b += weight * other.b;
    aa += weight * other.aa;
    bb += weight * other.bb;
    ab += weight * other.ab;
  }
};

/// Eq. 13.
double similarityOf(const Moments& m) {
  const double variance_a = m.aa - m.a * m.a;
  const double variance_b = m.bb - m.b * m.b;
  const double covariance = m.ab - m.a * m.b;
  return (2.0 * m.a * m.b + kC1) * (2.0 * covariance + kC2) /
         ((m.a * m.a + m.b * m.b + kC1) * (variance_a + variance_b + kC2));
}

Moments pixelMoments(const Image& image_a, const Image& image_b, int x, int y) {
  const auto a = double(formula::luminance(rgbAt(image_a, x, y)));
  const auto b = double(formula::luminance(rgbAt(image_b, x, y)));
  return {a, b, a * a, b * b, a * b};
}

/// The moments of a row's windows, as far as they lie in that row.
void filterRow(const Image& a, const Image& b, int y, const Window& window, std::vector<Moments>& pixels,
               Moments* filtered) {
  for (int x = 0; x < a.width(); ++x) pixels[std::size_t(x)] = pixelMoments(a, b, x, y);
  for (std::size_t x = 0; x + kSsimWindow <= pixels.size(); ++x) {
    filtered[x] = {};
    for (std::size_t i = 0; i < kSsimWindow; ++i) filtered[x].add(window[i], pixels[x + i]);
  }
}

}  // namespace

Result<std::optional<double>> structuralSimilarity(const Image& a, const Image& b, const ProgressFunction& progress) {
  assert(a.width() == b.width() && a.height() == b.height());
  if (std::min(a.width(), a.height()) < kSsimWindow) return std::optional<double>();
  const Window window = gaussianWindow();
  const auto columns = std::size_t(a.width() - kSsimWindow + 1);
  std::vector<double> rows(std::size_t(a.height() - kSsimWindow + 1));
  ProgressCounter counter(progress, rows.size());
  parallelFor(rows.size(), kRowsPerWindow, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    const std::size_t needed = end - begin + kSsimWindow - 1;
    std::vector<Moments> pixels(std::size_t(a.width()));
    std::vector<Moments> filtered(needed * columns);
    for (std::size_t i = 0; i < needed; ++i)
      filterRow(a, b, static_cast<int>(begin + i), window, pixels, &filtered[i * columns]);
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x < columns; ++x) {
        Moments moments;
        for (std::size_t i = 0; i < kSsimWindow; ++i) moments.add(window[i], filtered[(y - begin + i) * columns + x]);
        rows[y] += similarityOf(moments);
      }
    counter.advance(end - begin);
  });
  MIRRORBALL_TRY_VOID(counter.result());
  double sum = 0.0;
  for (const double row : rows) sum += row;
  return std::optional(sum / static_cast<double>(rows.size() * columns));
}

}  // namespace mirrorball
