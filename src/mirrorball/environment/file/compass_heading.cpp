#include "mirrorball/environment/file/compass_heading.h"

#include <cmath>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/projection/projection.h"

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

Result<void> checkTakesHeading(const LoadedEnvironment& loaded) {
  if (loaded.recognition && loaded.recognition->form.projection == Projection::equirect) return {};
  return fail(ErrorCode::bad_shape,
              "a compass heading is that of a panorama's middle, and this map is " +
                  (loaded.recognition ? textOf(loaded.recognition->form) : std::string("a function of the direction")));
}

Result<NorthInfo> findNorth(const CompassHeading& heading, const LoadedEnvironment& loaded) {
  MIRRORBALL_TRY_VOID(checkTakesHeading(loaded));
  const SignedAxis centre = loaded.recognition->form.centre;
  const CompassAxes axes = compassAxes(heading, centre);
  const glm::vec3 in_picture = glm::transpose(centredOn(vectorOf(centre))) * axes.north;
  const float u = positionOf(Projection::equirect, in_picture).uv.x;
  return NorthInfo{heading, axes, u * float(loaded.file_size.x)};
}

}  // namespace mirrorball
