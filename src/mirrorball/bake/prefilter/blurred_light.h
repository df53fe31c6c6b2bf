#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/harmonic_transform.h"
#include "mirrorball/bake/harmonics/sphere_grid.h"
#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/bake/prefilter/lobe.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/convert/point_batch.h"
#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// An environment that is blurred by one lobe: for each direction, the mean of the light around it, weighted by the
/// lobe.
class BlurredLight {
 public:
  /// The means around all points of a batch: reads x, y and z, writes u and v.
  ///
  /// values   at least as many as the batch has points; the fourth component is undefined
  void sample(PointBatch& points, glm::vec4* values) const;

 private:
  friend class LightHarmonics;
  BlurredLight(Lobe lobe, SphereGrid grid, std::shared_ptr<const BrightLights> bright)
      : lobe_(std::move(lobe)), grid_(std::move(grid)), bright_(std::move(bright)) {}

  Lobe lobe_;
  SphereGrid grid_;  // without the bright texels
  std::shared_ptr<const BrightLights> bright_;
};

/// The light of an environment in two parts: a few points that outshine the rest, and the rest in spherical harmonics,
/// where a blur is one product per band.
///
/// Errors: the sum over all texels is exact except for the bands that a lobe makes almost 0, the interpolation between
/// the points of a grid, and the rounding of floats: together 1e-5 to 1e-4 of the light around (docs/prefiltering.md).
class LightHarmonics {
 public:
  /// environment   finite
  /// lobes         that it will be blurred by
  /// errors        too_large; interrupted (when `progress` says so)
  /// cost          a Fourier transform of each row of texels, and rows · bands² / 4 steps of about 1.2 ns on one core
  static Result<LightHarmonics> make(const Environment& environment, const std::vector<Lobe>& lobes,
                                     const ProgressFunction& progress = {});

  /// The maximum memory [bytes]: how many bands a map needs is known only when it is analysed.
  struct Memory {
    std::uint64_t peak;  ///< while it is made, beside the environment
    std::uint64_t kept;
  };
  static Memory memoryFor(const Environment& environment, const std::vector<Lobe>& lobes);

  /// lobe     one of those
  /// errors   interrupted (when `progress` says so)
  Result<BlurredLight> blurred(const Lobe& lobe, const ProgressFunction& progress = {}) const;

  /// GGX's long tail covers small errors far from a lamp, and leaves little of high bands; other lobes have neither.
  static GridDensity gridDensityFor(const Lobe& lobe);

  const HarmonicCoefficients& coefficients() const { return coefficients_; }
  /// What the coefficients lack.
  const BrightLights& bright() const { return *bright_; }

 private:
  LightHarmonics(float tolerance, HarmonicCoefficients coefficients, BrightLights bright)
      : tolerance_(tolerance),
        coefficients_(std::move(coefficients)),
        bright_(std::make_shared<const BrightLights>(std::move(bright))) {}

  float tolerance_;  // of Lobe::bandsFor
  HarmonicCoefficients coefficients_;
  std::shared_ptr<const BrightLights> bright_;
};

}  // namespace mirrorball
