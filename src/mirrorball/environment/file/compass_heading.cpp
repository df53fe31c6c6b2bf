#include "mirrorball/environment/file/compass_heading.h"

#include <cmath>

#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {

CompassAxes compassAxes(const CompassHeading& heading, SignedAxis centre) {
  // The world has x to the right of the heading, y up and z along the heading.
  const double h = glm::radians(heading.heading_deg);
  const double p = glm::radians(heading.pitch_deg);
  const double r = glm::radians(heading.roll_deg);
  const glm::dvec3 north(-std::sin(h), 0.0, std::cos(h));
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const glm::dvec3 middle(0.0, std::sin(p), std::cos(p));
  const glm::dvec3 level_right(1.0, 0.0, 0.0);
  const glm::dvec3 level_top(0.0, std::cos(p), -std::sin(p));
  const glm::dvec3 right = std::cos(r) * level_right - std::sin(r) * level_top;
  const glm::dvec3 top = std::cos(r) * level_top + std::sin(r) * level_right;
  // A panorama has +Z in its middle, and −X to the right of that.
  const auto inMap = [&](glm::dvec3 d) {
    const glm::dvec3 in_picture(-glm::dot(d, right), glm::dot(d, top), glm::dot(d, middle));
    return glm::normalize(centredOn(vectorOf(centre)) * glm::vec3(in_picture));
  };
  return {inMap(north), inMap(up)};
}

}  // namespace mirrorball
