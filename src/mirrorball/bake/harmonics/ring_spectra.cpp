#include "mirrorball/bake/harmonics/ring_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

using Complex = std::complex<float>;

/// Coefficient m of two real functions, from the transform of north + i south.
struct NorthSouth {
  Complex north;
  Complex south;
};
NorthSouth parted(const std::vector<Complex>& transform, int m) {
  const int length = static_cast<int>(transform.size());
  const Complex positive = transform[static_cast<std::size_t>(m % length)];
  const Complex negative = std::conj(transform[static_cast<std::size_t>((length - m % length) % length)]);
  const Complex difference = positive - negative;
  return {(positive + negative) * 0.5f, Complex(difference.imag(), -difference.real()) * 0.5f};
}

Complex timesI(Complex z) { return {-z.imag(), z.real()}; }

/// The Fourier transform of a cubic B-spline at the frequency 2 x.
float splineTransform(double x) {
  const double ratio = x == 0.0 ? 1.0 : std::sin(x) / x;
  return static_cast<float>(ratio * ratio * ratio * ratio);
}

}  // namespace

/// A northern ring and i times a southern one, or their transform; each channel by itself.
struct RingColumns {
  std::array<std::vector<Complex>, 3> channel;
};

RowTransform::RowTransform(const EnvironmentMap& panorama, const BrightLights& without, int orders)
    : image_(panorama.face(0)), without_(without), transform_(image_.width(), false) {
  for (int m = 0; m < orders; ++m) turns_.push_back(Complex(std::polar(1.0, -std::numbers::pi * m / image_.width())));
}

void RowTransform::run(int first, RingSpectra& spectra) const {
  const int pairs = (image_.height() + 1) / 2;
  parallelFor(RingSpectra::kPairs, 4, [&](std::size_t begin, std::size_t end) {
    RingColumns columns;
    RingColumns transforms;
    for (std::vector<Complex>& transform : transforms.channel) transform.resize(std::size_t(image_.width()));
    for (std::size_t place = begin; place < end; ++place) {
      const int pair = first + static_cast<int>(place);
      if (pair < pairs) {
        transformPair(pair, columns, transforms, spectra, place);
      } else {
        for (int m = 0; m < spectra.orders(); ++m) spectra.order(m)[place] = kNoLight;
      }
    }
  });
}

void RowTransform::load(int y, float weight, bool is_south, RingColumns& columns) const {
  const auto width = static_cast<std::size_t>(image_.width());
  const auto stride = static_cast<std::size_t>(image_.channels());
  for (std::size_t c = 0; c < 3; ++c) {
    const float* sample = image_.row(y).data() + (stride >= 3 ? c : 0);
    // A complex number is its real and its imaginary part (C++ standard, [complex.numbers]).
    float* part = reinterpret_cast<float*>(columns.channel[c].data()) + (is_south ? 1 : 0);
    for (std::size_t x = 0; x < width; ++x) part[2 * x] = weight * sample[x * stride];
  }
  const auto isBefore = [](const Excess& excess, int row) { return excess.texel.y < row; };
  const std::vector<Excess>& without = without_.texels;
  for (auto bright = std::lower_bound(without.begin(), without.end(), y, isBefore);
       bright != without.end() && bright->texel.y == y; ++bright)
    for (int c = 0; c < 3; ++c) {
      const Complex excess(weight * bright->radiance[c]);
      columns.channel[std::size_t(c)][std::size_t(bright->texel.x)] -= is_south ? timesI(excess) : excess;
    }
}

void RowTransform::transformPair(int pair, RingColumns& columns, RingColumns& transforms, RingSpectra& spectra,
                                 std::size_t place) const {
  const int height = image_.height();
  const int south = height - 1 - pair;  // the middle row of an odd number is north alone
  const float weight = texelSolidAngle(Projection::equirect, {image_.width(), height}, {0, pair});
  for (std::vector<Complex>& column : columns.channel) column.assign(std::size_t(image_.width()), Complex(0.0f));
  load(pair, weight, false, columns);
  if (south != pair) load(south, weight, true, columns);
  for (std::size_t c = 0; c < 3; ++c) transform_.run(columns.channel[c], transforms.channel[c]);
  for (int m = 0; m < spectra.orders(); ++m) {
    RingPair& value = spectra.order(m)[place];
    value = kNoLight;
    for (int c = 0; c < 3; ++c) {
      const NorthSouth parts = parted(transforms.channel[std::size_t(c)], m);
      const Complex even = (parts.north + parts.south) * turns_[std::size_t(m)];
      const Complex odd = (parts.north - parts.south) * turns_[std::size_t(m)];
      value.even.real[c] = even.real();
      value.even.imaginary[c] = even.imag();
      value.odd.real[c] = odd.real();
      value.odd.imaginary[c] = odd.imag();
    }
  }
  const float ring = weight * static_cast<float>(image_.width());
  RingPair& mean = spectra.order(0)[place];
  mean.even.real.w = south == pair ? ring : 2.0f * ring;
  mean.odd.real.w = south == pair ? ring : 0.0f;
}

struct GridTransform::Buffers {
  RingColumns series;
  std::vector<Complex> values;
};

GridTransform::GridTransform(SphereGrid& grid, int orders) : grid_(grid), transform_(grid.columns(), true) {
  for (int m = 0; m < orders; ++m) sharpen_.push_back(1.0f / splineTransform(std::numbers::pi * m / grid.columns()));
}

void GridTransform::run(int first, const RingSpectra& spectra) const {
  const int count = std::min(RingSpectra::kPairs, grid_.rings() / 2 - first);
  parallelFor(static_cast<std::size_t>(count), 4, [&](std::size_t begin, std::size_t end) {
    const auto columns = static_cast<std::size_t>(grid_.columns());
    Buffers buffers;
    buffers.values.resize(columns);
    for (std::size_t place = begin; place < end; ++place)
      setPair(first + static_cast<int>(place), spectra, place, buffers);
  });
}

void GridTransform::setPair(int pair, const RingSpectra& spectra, std::size_t place, Buffers& buffers) const {
  const auto columns = static_cast<std::size_t>(grid_.columns());
  glm::vec4* north = grid_.ring(pair);
  glm::vec4* south = grid_.ring(grid_.rings() - 1 - pair);
  const RingPair& mean = spectra.order(0)[place];
  const float north_white = 1.0f / (mean.even.real.w + mean.odd.real.w);
  const float south_white = 1.0f / (mean.even.real.w - mean.odd.real.w);
  for (std::vector<Complex>& series : buffers.series.channel) series.assign(columns, Complex(0.0f));
  for (int m = 0; m < spectra.orders(); ++m) {
    const auto at = static_cast<std::size_t>(m);
    const RingPair& value = spectra.order(m)[place];
    for (int c = 0; c < 3; ++c) {
      const Complex even(value.even.real[c], value.even.imaginary[c]);
      const Complex odd(value.odd.real[c], value.odd.imaginary[c]);
      const Complex of_north = (even + odd) * (sharpen_[at] * north_white);
      const Complex of_south = (even - odd) * (sharpen_[at] * south_white);
      std::vector<Complex>& series = buffers.series.channel[std::size_t(c)];
      series[at] = of_north + timesI(of_south);
      if (m > 0) series[columns - at] = std::conj(of_north) + timesI(std::conj(of_south));
    }
  }
  for (int c = 0; c < 3; ++c) {
    transform_.run(buffers.series.channel[std::size_t(c)], buffers.values);
    for (std::size_t i = 0; i < columns; ++i) {
      north[i][c] = buffers.values[i].real();
      south[i][c] = buffers.values[i].imag();
    }
  }
  for (std::size_t i = 0; i < columns; ++i) {
    north[i].w = north_white;
    south[i].w = south_white;
  }
}

}  // namespace mirrorball
