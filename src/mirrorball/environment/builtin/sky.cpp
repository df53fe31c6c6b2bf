#include "mirrorball/environment/builtin/sky.h"

#include <cmath>
#include <memory>

#include "formula/color.h"
#include "formula/constants.h"
#include "formula/sky.h"
#include "mirrorball/environment/builtin/sky_light.h"
#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

/// Rows of a panorama that shows the sun's disc and the ground's grains.
constexpr int kSkyHeight = 1024;

/// The sun is 0.533° across.
constexpr float kSunRadius_rad = 0.00465f;

/// The sun's disc as a share of its radiance. Its edge is as soft as the texels of a map that is sampled from it, with
/// the same flux as the sharp disc: a linear ramp over [r − w, r + w] has the area π (r² + w²/3).
float sunDisc(float angle_rad) {
  constexpr float kSoft_rad = 0.6f * kSunRadius_rad;
  constexpr float kGain =
      kSunRadius_rad * kSunRadius_rad / (kSunRadius_rad * kSunRadius_rad + kSoft_rad * kSoft_rad / 3.0f);
  return kGain * glm::clamp((kSunRadius_rad + kSoft_rad - angle_rad) / (2.0f * kSoft_rad), 0.0f, 1.0f);
}

/// The irradiance of a level surface by what is above it: the mean of 32 × 64 directions, even in area and cosine.
glm::vec3 irradianceFromAbove(const SkyLight& light) {
  constexpr int kRings = 32;
  constexpr int kPlaces = 64;
  glm::vec3 sum(0.0f);
  for (int ring = 0; ring < kRings; ++ring)
    for (int place = 0; place < kPlaces; ++place) {
      const float squared_sine = (static_cast<float>(ring) + 0.5f) / kRings;
      const float turn = formula::kTwoPi * (static_cast<float>(place) + 0.5f) / kPlaces;
      const float sine = std::sqrt(squared_sine);
      sum += light.radiance(glm::vec3(sine * std::cos(turn), std::sqrt(1.0f - squared_sine), sine * std::sin(turn)));
    }
  return sum * (formula::kPi / (kRings * kPlaces));
}

}  // namespace

Environment skyEnvironment(const SkyParameters& parameters) {
  const glm::vec3 sun = directionAtAngles(parameters.azimuth_deg, parameters.elevation_deg);
  const auto light = std::make_shared<const SkyLight>(sun, parameters.turbidity);
  const glm::vec3 sky_klx = irradianceFromAbove(*light);
  const glm::vec3 sun_klx = light->sunIrradiance() * sun.y;
  const float level_klx = formula::luminance(sky_klx + sun_klx);
  const float units_per_kcd = std::pow(70.0f / level_klx, parameters.adaptation) / 20.0f;

  const float sun_solid_angle = formula::kPi * kSunRadius_rad * kSunRadius_rad;
  const glm::vec3 sun_radiance = light->sunIrradiance() * (units_per_kcd * parameters.sun / sun_solid_angle);
  const glm::vec3 sun_irradiance = sun_klx * (units_per_kcd * parameters.sun);
  const glm::vec3 sky_irradiance = sky_klx * units_per_kcd;
  const auto radiance = [=](glm::vec3 d) {
    if (d.y >= 0.0f) return light->radiance(d) * units_per_kcd + sun_radiance * sunDisc(glm::length(d - sun));
    const glm::vec3 horizon = light->radiance(glm::vec3(d.x, 0.0f, d.z)) * units_per_kcd;
    return formula::groundRadiance(d, sun, sun_irradiance, sky_irradiance, horizon, formula::kPi / kSkyHeight);
  };
  return Environment(radiance, kSkyHeight);
}

}  // namespace mirrorball
