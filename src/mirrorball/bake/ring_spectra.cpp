#include "mirrorball/bake/ring_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <memory>
#include <numbers>

#include <kiss_fft.h>

#include "mirrorball/bake/legendre.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

using Complex = std::complex<float>;
static_assert(sizeof(Complex) == sizeof(kiss_fft_cpx));

/// A Fourier transform of one length, in either direction, unscaled; safe to use from many threads.
class FourierTransform {
 public:
  FourierTransform(int length, bool is_inverse) : plan_(kiss_fft_alloc(length, is_inverse, nullptr, nullptr)) {}

  void run(const std::vector<Complex>& in, std::vector<Complex>& out) const {
    kiss_fft(plan_.get(), reinterpret_cast<const kiss_fft_cpx*>(in.data()),
             reinterpret_cast<kiss_fft_cpx*>(out.data()));
  }

 private:
  struct Free {
    void operator()(kiss_fft_cfg plan) const { kiss_fft_free(plan); }
  };
  std::unique_ptr<kiss_fft_state, Free> plan_;
};

/// Three real functions on a northern and a southern ring, as three complex ones.
using ColumnsOfPair = std::array<std::vector<Complex>, 3>;

void addRow(const Image& row, int y, float weight, bool is_south, ColumnsOfPair& columns) {
  const auto width = static_cast<std::size_t>(row.width());
  const bool has_color = row.channels() >= 3;
  const auto stride = static_cast<std::size_t>(row.channels());
  const float* texels = row.row(y).data();
  for (std::size_t c = 0; c < 3; ++c) {
    const float* sample = texels + (has_color ? c : 0);
    // A complex number is its real and its imaginary part (C++ standard, complex.numbers).
    float* part = reinterpret_cast<float*>(columns[c].data()) + (is_south ? 1 : 0);
    for (std::size_t x = 0; x < width; ++x) part[2 * x] = weight * sample[x * stride];
  }
}

/// The bright texels of a panorama, row by row.
class ExcessOfRows {
 public:
  explicit ExcessOfRows(const BrightTexels& texels) : texels_(texels) {
    std::sort(texels_.begin(), texels_.end(),
              [](const BrightTexel& a, const BrightTexel& b) { return a.texel.y < b.texel.y; });
  }

  void subtract(int y, float weight, bool is_south, ColumnsOfPair& columns) const {
    const auto begin = std::lower_bound(texels_.begin(), texels_.end(), y,
                                        [](const BrightTexel& t, int row) { return t.texel.y < row; });
    for (auto texel = begin; texel != texels_.end() && texel->texel.y == y; ++texel)
      for (int c = 0; c < 3; ++c) {
        Complex& value = columns[static_cast<std::size_t>(c)][static_cast<std::size_t>(texel->texel.x)];
        const float excess = weight * texel->radiance[c];
        value -= is_south ? Complex(0.0f, excess) : Complex(excess, 0.0f);
      }
  }

 private:
  BrightTexels texels_;
};

/// Parts the transform of north + i south into north's and south's coefficient m, since both are real.
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

/// The transform of a cubic B-spline at ω = 2 x: what the spline's coefficients have to be divided by.
float splineTransform(double x) {
  const double ratio = x == 0.0 ? 1.0 : std::sin(x) / x;
  return static_cast<float>(ratio * ratio * ratio * ratio);
}

}  // namespace

RingSpectra::RingSpectra(int rings, int orders)
    : rings_(rings),
      pairs_((rings + 1) / 2),
      orders_(orders),
      stride_(std::size_t((pairs_ + kLegendreBlock - 1) / kLegendreBlock * kLegendreBlock)),
      values_(stride_ * std::size_t(orders)) {}

double RingSpectra::theta(int pair) const { return std::numbers::pi * (pair + 0.5) / rings_; }

RingSpectra spectraOfRows(const EnvironmentMap& panorama, const BrightTexels& without, int orders) {
  const Image& image = panorama.face(0);
  const int height = image.height();
  const auto width = static_cast<std::size_t>(image.width());
  RingSpectra spectra(height, orders);
  const ExcessOfRows excess(without);
  const FourierTransform transform(image.width(), false);
  // Texel centres lie half a texel from the seam.
  std::vector<Complex> turns(static_cast<std::size_t>(orders));
  for (std::size_t m = 0; m < turns.size(); ++m)
    turns[m] = Complex(std::polar(1.0, -std::numbers::pi * static_cast<double>(m) / image.width()));

  parallelFor(static_cast<std::size_t>(spectra.pairs()), 4, [&](std::size_t begin, std::size_t end) {
    ColumnsOfPair columns;
    ColumnsOfPair transforms;
    for (std::size_t c = 0; c < 3; ++c) transforms[c].resize(width);
    for (int pair = static_cast<int>(begin); pair < static_cast<int>(end); ++pair) {
      const int south = height - 1 - pair;
      const double ring =
          2.0 * std::numbers::pi *
          (std::cos(std::numbers::pi * pair / height) - std::cos(std::numbers::pi * (pair + 1) / height));
      const auto weight = static_cast<float>(ring / static_cast<double>(width));
      for (std::vector<Complex>& column : columns) column.assign(width, Complex(0.0f));
      addRow(image, pair, weight, false, columns);
      excess.subtract(pair, weight, false, columns);
      if (south != pair) {
        addRow(image, south, weight, true, columns);
        excess.subtract(south, weight, true, columns);
      }
      for (std::size_t c = 0; c < 3; ++c) transform.run(columns[c], transforms[c]);
      for (int m = 0; m < orders; ++m) {
        RingPair& value = spectra.order(m)[static_cast<std::size_t>(pair)];
        value = kNoLight;
        for (int c = 0; c < 3; ++c) {
          const NorthSouth parts = parted(transforms[static_cast<std::size_t>(c)], m);
          const Complex turn = turns[static_cast<std::size_t>(m)];
          const Complex even = (parts.north + parts.south) * turn;
          const Complex odd = (parts.north - parts.south) * turn;
          value.even.real[c] = even.real();
          value.even.imaginary[c] = even.imag();
          value.odd.real[c] = odd.real();
          value.odd.imaginary[c] = odd.imag();
        }
      }
      RingPair& mean = spectra.order(0)[static_cast<std::size_t>(pair)];
      mean.even.real.w = static_cast<float>(south == pair ? ring : 2.0 * ring);
      mean.odd.real.w = static_cast<float>(south == pair ? ring : 0.0);
    }
  });
  return spectra;
}

SphereGrid gridOf(const RingSpectra& spectra, int columns) {
  SphereGrid grid(spectra.rings(), columns);
  const FourierTransform transform(columns, true);
  const auto length = static_cast<std::size_t>(columns);
  std::vector<float> sharpen(static_cast<std::size_t>(spectra.orders()));
  for (std::size_t m = 0; m < sharpen.size(); ++m)
    sharpen[m] = 1.0f / splineTransform(std::numbers::pi * static_cast<double>(m) / columns);

  parallelFor(static_cast<std::size_t>(spectra.pairs()), 4, [&](std::size_t begin, std::size_t end) {
    std::vector<Complex> series(length);
    std::vector<Complex> values(length);
    for (int pair = static_cast<int>(begin); pair < static_cast<int>(end); ++pair) {
      glm::vec4* north = grid.ring(pair);
      glm::vec4* south = grid.ring(spectra.rings() - 1 - pair);
      const RingPair& mean = spectra.order(0)[static_cast<std::size_t>(pair)];
      const float north_white = 1.0f / (mean.even.real.w + mean.odd.real.w);
      const float south_white = 1.0f / (mean.even.real.w - mean.odd.real.w);
      for (int c = 0; c < 3; ++c) {
        std::fill(series.begin(), series.end(), Complex(0.0f));
        for (int m = 0; m < spectra.orders(); ++m) {
          const RingPair& value = spectra.order(m)[static_cast<std::size_t>(pair)];
          const Complex even(value.even.real[c], value.even.imaginary[c]);
          const Complex odd(value.odd.real[c], value.odd.imaginary[c]);
          const float factor = sharpen[static_cast<std::size_t>(m)];
          const Complex of_north = (even + odd) * (factor * north_white);
          const Complex of_south = (even - odd) * (factor * south_white);
          const Complex i_south(-of_south.imag(), of_south.real());
          series[static_cast<std::size_t>(m)] = of_north + i_south;
          if (m > 0)
            series[length - static_cast<std::size_t>(m)] =
                std::conj(of_north) + Complex(of_south.imag(), of_south.real());
        }
        transform.run(series, values);
        for (std::size_t i = 0; i < length; ++i) {
          north[i][c] = values[i].real();
          south[i][c] = values[i].imag();
        }
      }
      for (std::size_t i = 0; i < length; ++i) {
        north[i].w = north_white;
        south[i].w = south_white;
      }
    }
  });
  grid.close();
  return grid;
}

int quickLength(int least) {
  const auto isQuick = [](int length) {
    for (const int factor : {2, 3, 5})
      while (length % factor == 0) length /= factor;
    return length == 1;
  };
  int length = least + least % 2;
  while (!isQuick(length)) length += 2;
  return length;
}

}  // namespace mirrorball
