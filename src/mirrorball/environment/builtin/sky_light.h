#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// The light of a clear sky for one place of the sun: single scattering by molecules and haze in a round atmosphere
/// with ozone, in 12 wavelengths (formula/sky/sky.glsl), and all further scattering as isotropic (Hillaire 2020, "A
/// scalable and production ready sky and atmosphere rendering technique", section 5.5). What is left of the single
/// scattering without its phase function is smooth and is kept in a table.
///
/// Colours are linear Rec.709 with the white of daylight film, D55,
/// so that sun and sky together are about white at noon.
class SkyLight {
 public:
  /// sun        unit, y ≥ 0
  /// turbidity  2 very clear … 10 hazy
  /// cost       about 15 ms of one core
  SkyLight(glm::vec3 sun, float turbidity);

  /// The sky along d (unit, d.y ≥ 0), without the sun's disc, in kcd/m².
  glm::vec3 radiance(glm::vec3 d) const;

  /// By the sun alone, of a surface that faces it, in klx.
  glm::vec3 sunIrradiance() const { return sun_irradiance_; }

 private:
  /// What comes to the eye along one direction, in Rec.709: to be multiplied by the phase functions,
  /// and from all further scattering.
  struct Scattered {
    glm::vec3 by_molecules{0.0f};
    glm::vec3 by_haze{0.0f};
    glm::vec3 again{0.0f};
  };

  glm::vec3 sun_;
  glm::vec2 towards_sun_;  ///< on the level
  glm::vec3 sun_irradiance_{0.0f};
  std::vector<Scattered> table_;  ///< rows from the horizon to the zenith, columns from under the sun to opposite to it
};

}  // namespace mirrorball
