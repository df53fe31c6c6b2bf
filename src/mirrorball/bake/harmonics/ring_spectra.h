#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/sphere_grid.h"
#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/fourier_transform.h"
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

/// Some pairs of rings, each ring as a Fourier series in φ: f(φ) = Re(F_0 + 2 Σ F_m e^(imφ)). Pairs are numbered from
/// the poles to the equator; so few are held at a time that they stay in a processor's cache.
class RingSpectra {
 public:
  static constexpr int kPairs = 64;

  explicit RingSpectra(int orders) : orders_(orders), values_(offset(orders)) {}

  int orders() const { return orders_; }
  std::span<RingPair, kPairs> order(int m) { return std::span<RingPair, kPairs>(values_.data() + offset(m), kPairs); }
  std::span<const RingPair, kPairs> order(int m) const {
    return std::span<const RingPair, kPairs>(values_.data() + offset(m), kPairs);
  }

 private:
  // One pair more than there are: transforms go through all orders of a pair, which 4096 bytes apart would all want the
  // same few places of a cache.
  static std::size_t offset(int m) { return std::size_t(m) * (kPairs + 1); }

  int orders_;
  std::vector<RingPair, TexelAllocator<RingPair>> values_;
};

struct RingColumns;

/// Fourier coefficients of a panorama's rows, each texel times its solid angle: Σ texels · e^(−imφ).
class RowTransform {
 public:
  /// panorama, without   must outlive it; `without` is in the order of the texels
  /// orders    any number: beyond the texels of a row they repeat themselves, as those of points of light do
  RowTransform(const EnvironmentMap& panorama, const BrightLights& without, int orders);

  /// The pairs from `first` on; beyond the last one 0.
  void run(int first, RingSpectra& spectra) const;

 private:
  void load(int y, float weight, bool is_south, RingColumns& columns) const;
  void transformPair(int pair, RingColumns& columns, RingColumns& transforms, RingSpectra& spectra,
                     std::size_t place) const;

  const Image& image_;
  const BrightLights& without_;
  FourierTransform transform_;
  std::vector<std::complex<float>> turns_;  // texel centres lie half a texel from the seam
};

/// From Fourier coefficients back to the rings of a grid, each divided by its white one.
class GridTransform {
 public:
  /// grid      must outlive it
  GridTransform(SphereGrid& grid, int orders);

  /// Sets the rings of the pairs from `first` on.
  void run(int first, const RingSpectra& spectra) const;

 private:
  struct Buffers;
  void setPair(int pair, const RingSpectra& spectra, std::size_t place, Buffers& buffers) const;

  SphereGrid& grid_;
  FourierTransform transform_;
  std::vector<float> sharpen_;  // what makes values into coefficients of cubic B-splines
};

}  // namespace mirrorball
