#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/bright_texels.h"
#include "mirrorball/bake/sphere_grid.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/texel_allocator.h"

namespace mirrorball {

/// What Legendre functions meet on a pair of rings, one as far north as the other is south: P̄_lm is the same on both
/// where l + m is even, and the opposite where it is odd.
struct RingPair {
  /// Fourier coefficients of red, green, blue and white.
  struct Value {
    glm::vec4 real;
    glm::vec4 imaginary;
  };
  Value even;  ///< north + south when analysed; the share of even l + m when synthesized
  Value odd;   ///< north − south; the share of odd l + m
};

inline constexpr RingPair kNoLight{{glm::vec4(0.0f), glm::vec4(0.0f)}, {glm::vec4(0.0f), glm::vec4(0.0f)}};

/// The rings of a map, each as a Fourier series in φ: f(φ) = Re(F_0 + 2 Σ F_m e^(imφ)).
class RingSpectra {
 public:
  /// Without values yet.
  ///
  /// rings    equally spaced, half a space from the poles; of an odd number the middle one is its own pair
  RingSpectra(int rings, int orders);

  int rings() const { return rings_; }
  int pairs() const { return pairs_; }
  int orders() const { return orders_; }

  /// All pairs of one order, from the poles to the equator, and as many more as fill the last kLegendreBlock.
  std::span<RingPair> order(int m) { return {values_.data() + std::size_t(m) * stride_, stride_}; }
  std::span<const RingPair> order(int m) const { return {values_.data() + std::size_t(m) * stride_, stride_}; }

  /// Of a pair's northern ring.
  double theta(int pair) const;

 private:
  int rings_;
  int pairs_;
  int orders_;
  std::size_t stride_;
  std::vector<RingPair, TexelAllocator<RingPair>> values_;
};

/// The Fourier coefficients of a panorama's rows, each texel times its solid angle: Σ texels · e^(−imφ).
///
/// orders   any number: beyond the texels of a row they repeat themselves, as those of points of light do
RingSpectra spectraOfRows(const EnvironmentMap& panorama, const BrightTexels& without, int orders);

/// The functions of those spectra, each ring divided by its white one, which becomes the fourth channel's reciprocal.
SphereGrid gridOf(const RingSpectra& spectra, int columns);

/// The next number from `least` on that is even and a product of 2, 3 and 5, for which Fourier transforms are quick.
int quickLength(int least);

}  // namespace mirrorball
