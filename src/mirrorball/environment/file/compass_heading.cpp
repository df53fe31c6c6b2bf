#include "mirrorball/environment/file/compass_heading.h"

#include <cmath>
#include <utility>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {

glm::mat3 pictureFromLevel(double pitch_deg, double roll_deg) {
  // The world has x to the right of the heading, y up and z along the heading.
  const double p = glm::radians(pitch_deg);
  const double r = glm::radians(roll_deg);
  const glm::dvec3 middle(0.0, std::sin(p), std::cos(p));
  const glm::dvec3 level_right(1.0, 0.0, 0.0);
  const glm::dvec3 level_top(0.0, std::cos(p), -std::sin(p));
  const glm::dvec3 right = std::cos(r) * level_right - std::sin(r) * level_top;
  const glm::dvec3 top = std::cos(r) * level_top + std::sin(r) * level_right;
  // A panorama has +Z in its middle, and −X to the right of that.
  const auto inPicture = [&](glm::dvec3 d) {
    return glm::vec3(-glm::dot(d, right), glm::dot(d, top), glm::dot(d, middle));
  };
  return {inPicture({-1.0, 0.0, 0.0}), inPicture({0.0, 1.0, 0.0}), inPicture({0.0, 0.0, 1.0})};
}

CompassAxes compassAxes(const CompassHeading& heading, SignedAxis centre) {
  const double h = glm::radians(heading.heading_deg);
  const glm::mat3 map_from_level = centredOn(vectorOf(centre)) * pictureFromLevel(heading.pitch_deg, heading.roll_deg);
  const glm::vec3 north(std::sin(h), 0.0, std::cos(h));
  return {glm::normalize(map_from_level * north), glm::normalize(map_from_level * glm::vec3(0.0f, 1.0f, 0.0f))};
}

Result<EnvironmentMap> levelled(EnvironmentMap panorama, double pitch_deg, double roll_deg, SignedAxis centre) {
  const int size = panorama.size();
  const glm::mat3 map_from_picture = centredOn(vectorOf(centre));
  const Resampling turned{.source_from_target = map_from_picture * pictureFromLevel(pitch_deg, roll_deg) *
                                                glm::transpose(map_from_picture)};
  return convert(Environment(std::move(panorama)), Projection::equirect, size, turned);
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
  CompassHeading as_loaded = heading;
  if (loaded.is_levelled) as_loaded.pitch_deg = as_loaded.roll_deg = 0.0;
  const CompassAxes axes = compassAxes(as_loaded, centre);
  const glm::vec3 in_picture = glm::transpose(centredOn(vectorOf(centre))) * axes.north;
  const float u = positionOf(Projection::equirect, in_picture).uv.x;
  const int columns = loaded.window ? loaded.window->whole.x : loaded.file_size.x;
  return NorthInfo{heading, axes, u * float(columns), columns};
}

}  // namespace mirrorball
