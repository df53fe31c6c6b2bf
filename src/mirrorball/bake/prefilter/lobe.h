#pragma once

#include <vector>

namespace mirrorball {

/// Which microfacet distribution a rough surface has (formula/bsdf/reflection_lobe.glsl).
enum class Distribution { ggx, phong, blinn, charlie };

/// Which of the formulas of reflection_lobe.glsl a lobe is, before it is scaled.
struct LobeShape {
  Distribution distribution;
  float parameter;  ///< ggx and charlie: alpha; phong and blinn: the exponent

  /// In a direction with sin²(θ/2) = s: at most about 1.
  float at(float s) const;
};

/// A blur that is the same in all directions around its middle: a function on the sphere that depends only on the angle
/// θ from there, vanishes beyond 90° and has the integral 1.
class Lobe {
 public:
  /// What a surface reflects towards an eye that looks along its normal.
  ///
  /// perceptual_roughness  such that alpha is at least kMinAlpha
  static Lobe reflection(Distribution distribution, float perceptual_roughness);

  /// (n·l)₊ / π: the mean of the light around a diffuse surface, irradiance / π.
  static Lobe cosine();

  /// Its value [1/sr] in a direction with sin²(θ/2) = s.
  float at(float s) const { return scale_ * shape_.at(s); }

  const LobeShape& shape() const { return shape_; }
  /// [1/sr] One over the shape's integral.
  float scale() const { return scale_; }

  /// The factors of the bands l of spherical harmonics (Funk and Hecke): 1 for l = 0. All bands after the last are less
  /// than kMinBand, or from kCheapBands on less than kMinFurtherBand.
  const std::vector<float>& bands() const { return bands_; }

  /// How many of these bands are needed so that the omitted ones hold at most `tolerance` of noise with power 1 in
  /// every harmonic. At least the first kCheapBands, since light has more power than noise in low bands; and every band
  /// above kMaxLeftOut, since a pattern that repeats every few texels may have all its light in one band.
  ///
  /// tolerance   root mean square over the sphere
  int bandsFor(float tolerance) const;

  /// [rad] of its finest detail: alpha.
  float width() const { return width_rad_; }

  /// Narrower lobes, less than a quarter of a degree wide, have too many bands.
  static constexpr float kMinAlpha = 0.002f;

  static constexpr int kCheapBands = 256;
  static constexpr float kMaxLeftOut = 1e-3f;
  static constexpr float kMinBand = 1e-5f;
  /// 2 α l K₁(2 α l), GGX's bands for small α, fall below it at l = 5.5 / α. More bands gain nothing: the rounding of
  /// floats is as much.
  static constexpr float kMinFurtherBand = 7e-5f;

 private:
  Lobe(const LobeShape& shape, float width_rad);

  LobeShape shape_;
  float width_rad_;
  float scale_ = 1.0f;
  std::vector<float> bands_;
};

}  // namespace mirrorball
