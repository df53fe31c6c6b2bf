#pragma once

#include <array>
#include <vector>

namespace mirrorball {

inline constexpr int kLegendreStretch = 32;  ///< bands that are computed together
inline constexpr int kLegendreBlock = 32;    ///< rings that are computed together

/// log₂ of P̄_mm / sin^m θ for m < orders.
std::vector<double> legendreSeeds(int orders);

/// The associated Legendre functions P̄_lm of one order m, normalised so that P̄_lm(cos θ) e^(imφ) are orthonormal on
/// the sphere, as a recurrence of two operations a step: with P̄_lm = scale · Q_l,
///   Q_{l+1} = step · cos θ · Q_l − Q_{l−1}.
///
/// from     Reinecke & Seljebotn 2013, "Libsharp – spherical harmonic transforms revisited", for the form
struct LegendreOrder {
  /// bands    for m ≤ l < bands, rounded up to whole stretches
  /// seed     legendreSeeds(…)[order]
  LegendreOrder(int order, int bands, double seed);
  LegendreOrder() = default;

  int m = 0;
  std::vector<double> step;   ///< [l − m]
  std::vector<double> scale;  ///< [l − m]
  double log2_seed = 0.0;
};

/// Q_l on up to kLegendreBlock rings. sin^m θ leaves the range of a double far from the equator; such values have an
/// exponent of their own. They count as 0 until they have grown to 2^−64.
struct LegendreBlock {
  /// Begins at l = m.
  ///
  /// count    rings from there on that are used; the values on the others are 0
  LegendreBlock(const LegendreOrder& order, const double* cosines, const double* log2_sines, int count);

  template <typename Value>
  using Rings = std::array<Value, kLegendreBlock>;

  alignas(64) Rings<double> cosine{};
  alignas(64) Rings<double> before{};    ///< Q_{l−1}
  alignas(64) Rings<double> here{};      ///< Q_l
  alignas(64) Rings<double> exponent{};  ///< of 2^960; 0 or less
};

/// Q_l of the next kLegendreStretch bands.
///
/// first    l − m of the first of them
/// values   [band][ring], aligned to 64 bytes
/// cost     about 0.6 ns a value
void advance(const LegendreOrder& order, int first, LegendreBlock& block, float* values);

/// Whether P̄_lm is less than 1e-8 of its greatest value for all l < bands on a ring with that sine: beyond the turning
/// point m = l sin θ it falls faster than exponentially.
bool vanishes(int order, int bands, double sine);

}  // namespace mirrorball
