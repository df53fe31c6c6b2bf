#include "mirrorball/light_edit/map_lamp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula/color.h"

namespace mirrorball {

float MapLamp::illuminance() const { return formula::luminance(irradiance); }

float MapLamp::solidAngle_sr() const {
  // Ω = 2π (1 − cos r) = 4π sin²(r/2), which keeps its digits where r is small.
  const float sine = std::sin(angular_size_rad / 4.0f);
  return 4.0f * std::numbers::pi_v<float> * sine * sine;
}

glm::vec3 MapLamp::radiance() const { return irradiance / solidAngle_sr(); }

float MapLamp::reach_rad() const {
  double reach = 0.0;
  for (const glm::vec3& corner : outline) reach = std::max(reach, angleBetween(direction, corner));
  return static_cast<float>(reach);
}

MapLamp turned(MapLamp lamp, const glm::mat3& turn) {
  lamp.direction = glm::normalize(turn * lamp.direction);
  for (glm::vec3& corner : lamp.outline) corner = glm::normalize(turn * corner);
  return lamp;
}

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b)); }

}  // namespace mirrorball
