#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/legendre.h"
#include "mirrorball/bake/harmonics/sphere_grid.h"
#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The density of a grid, between whose points a function is interpolated.
enum class GridDensity {
  sparse,  ///< 9/8 rings and 2 columns per band: for weights that are almost 0 in the upper half of the bands
  dense,   ///< 2 rings and 4 columns per band
};

/// A function on the sphere as coefficients of spherical harmonics about +Y: those of red, green and blue, and those of
/// a white map of the same texels, of which only order 0 is kept.
class HarmonicCoefficients {
 public:
  /// One band of one order: Σ texels · Y*_lm.
  struct Value {
    glm::vec4 real;       ///< red, green, blue, white
    glm::vec4 imaginary;  ///< red, green, blue, 0
  };

  /// All 0.
  explicit HarmonicCoefficients(int bands);

  int bands() const { return bands_; }
  /// The values for l = m, m + 1, … to bands(), rounded up to a whole kLegendreStretch; orders m ≥ 0,
  /// since light is real.
  std::vector<Value>& order(int m) { return orders_[std::size_t(m)]; }
  const std::vector<Value>& order(int m) const { return orders_[std::size_t(m)]; }
  const LegendreOrder& legendre(int m) const { return legendre_[std::size_t(m)]; }

 private:
  int bands_;
  std::vector<std::vector<Value>> orders_;
  std::vector<LegendreOrder> legendre_;
};

/// The memory of coefficients with `bands` bands [bytes].
std::uint64_t harmonicBytes(int bands);

/// The memory that analyse takes beside the coefficients, and synthesize with the grid that it returns [bytes].
std::uint64_t analysisBytes(int bands);
std::uint64_t synthesisBytes(int bands, GridDensity density);

/// The harmonics of a panorama's texels, each a point of light at its centre with the flux of its area,
/// (cos θ₀ − cos θ₁) 2π / width. So there is no quadrature error: the coefficients are exactly those of the sum over
/// all texels.
///
/// panorama   equirect, of any width and height
/// without    texels whose excess is left out (bright_lights.h)
/// bands      l < bands
/// errors     interrupted (when `progress` says so)
/// cost       height/2 · bands²/2 steps of a recurrence and its eight products, about 1.2 ns each on one core; and a
///            Fourier transform of each row
Result<HarmonicCoefficients> analyse(const EnvironmentMap& panorama, const BrightLights& without, int bands,
                                     const ProgressFunction& progress = {});

/// Evaluates the function on a grid, with each band l weighted by `weights[l]`, and divides it by the value of the
/// white map there. With the weights of a lobe, this is the weighted mean of all texels.
///
/// weights    at most coefficients.bands() count
/// returns    colour and, as the fourth channel, one over white
/// errors     interrupted (when `progress` says so)
/// cost       half of a ring for each m and l, and a Fourier transform of each ring
Result<SphereGrid> synthesize(const HarmonicCoefficients& coefficients, const std::vector<float>& weights,
                              GridDensity density, const ProgressFunction& progress = {});

}  // namespace mirrorball
