#include "mirrorball/environment/builtin/studio.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/direction_angles.h"

namespace mirrorball {
namespace {

constexpr float kWidestEdge = 0.105f;  ///< of a soft box's image in the floor [tangent]

/// How a soft box stands and shines. It is on a far sphere and faces the origin.
struct Lamp {
  float azimuth_deg;
  float elevation_deg;
  glm::vec2 half_extent;  ///< tangents of the half angles, across and up
  glm::vec3 radiance;     ///< in its middle
  float fall_off;  ///< the share of it that is lost towards its corners: a soft box is brightest where its lamp is
};

/// The same, as directions.
class SoftBox {
 public:
  explicit SoftBox(const Lamp& lamp) : lamp_(lamp), forward_(directionAtAngles(lamp.azimuth_deg, lamp.elevation_deg)) {
    right_ = glm::normalize(glm::cross(glm::vec3(0, 1, 0), forward_));
    up_ = glm::cross(forward_, right_);
    const glm::vec2 corner = lamp.half_extent + kWidestEdge;
    least_cosine2_ = 0.999f / (1.0f + glm::dot(corner, corner));
  }

  /// Lays the box over the light that is behind it along d, which has any length.
  /// Its edges are `edge` wide to either side [tangent, at most kWidestEdge].
  void layOver(glm::vec3& light, glm::vec3 d, float edge) const {
    const float depth = glm::dot(d, forward_);
    // Most directions are farther from the middle than a corner: they need no division.
    if (depth <= 0.0f || depth * depth < least_cosine2_ * glm::dot(d, d)) return;
    const glm::vec2 place = glm::abs(glm::vec2(glm::dot(d, right_), glm::dot(d, up_)) / depth);
    const glm::vec2 beyond = place - lamp_.half_extent;
    if (beyond.x >= edge || beyond.y >= edge) return;
    const float covered =
        (1.0f - glm::smoothstep(-edge, edge, beyond.x)) * (1.0f - glm::smoothstep(-edge, edge, beyond.y));
    const float from_middle = 0.7f * glm::length(place / lamp_.half_extent);
    const glm::vec3 radiance = lamp_.radiance * (1.0f - lamp_.fall_off * glm::smoothstep(0.0f, 1.0f, from_middle));
    light = glm::mix(light, radiance, covered);
  }

 private:
  Lamp lamp_;
  glm::vec3 forward_;
  glm::vec3 right_;
  glm::vec3 up_;
  float least_cosine2_;  ///< the square of the cosine between the middle and a corner, and a little less
};

const std::array<SoftBox, 5>& softBoxes() {
  static const std::array<SoftBox, 5> boxes{{
      // The key light, large, warm and high on the viewer's left; the fill on his right.
      SoftBox({-40.0f, 33.0f, {0.36f, 0.38f}, {7.2f, 7.0f, 6.65f}, 0.35f}),
      SoftBox({76.0f, 12.0f, {0.26f, 0.46f}, {0.71f, 0.75f, 0.80f}, 0.25f}),
      // Two standing strips behind the model, which draw its edges, and a box above it, which tells its top.
      SoftBox({157.0f, 18.0f, {0.085f, 0.46f}, {6.65f, 7.0f, 7.4f}, 0.2f}),
      SoftBox({-98.0f, 15.0f, {0.08f, 0.40f}, {5.0f, 5.0f, 5.0f}, 0.2f}),
      SoftBox({208.0f, 72.0f, {0.34f, 0.20f}, {2.6f, 2.6f, 2.6f}, 0.3f}),
  }};
  return boxes;
}

/// Walls that darken upwards and away from the fill light, a floor that is lit by the key light around the model and
/// shaded under it, and the light on the backdrop. Floor and walls meet in a sweep.
glm::vec3 roomRadiance(glm::vec3 d) {
  static const glm::vec3 to_key = directionAtAngles(-40.0f, 0.0f);
  static const glm::vec3 to_fill = directionAtAngles(76.0f, 0.0f);
  static const glm::vec3 to_backdrop = directionAtAngles(210.0f, 3.0f);
  const glm::vec3 from_backdrop = d - to_backdrop;
  const float backdrop = 0.40f * std::exp(-4.5f * glm::dot(from_backdrop, from_backdrop));
  const float above = glm::smoothstep(-0.16f, 0.02f, d.y);
  float light = backdrop * glm::mix(0.12f, 1.0f, above);
  if (above > 0.0f) {
    const float wall = glm::mix(0.10f, 0.03f, glm::smoothstep(0.0f, 0.85f, d.y));
    light += above * wall * (1.0f + 0.6f * glm::dot(d, to_fill));
  }
  if (above < 1.0f) {
    // Where the ray meets the floor: the distance from under the model, squared, in heights of the model.
    const float distance2 = 1.0f / std::max(d.y * d.y, 1e-6f) - 1.0f;
    const float floor = 0.04f + 0.12f / (1.0f + distance2 / 7.0f) * (1.0f - 0.75f * std::exp(-distance2 / 0.7f));
    light += (1.0f - above) * floor * (1.0f + 0.6f * glm::dot(d, to_key));
  }
  return glm::vec3(1.015f, 1.0f, 0.975f) * light;
}

/// What the satin floor shows of the soft boxes along d (d.y < 0): blurred, the more the flatter one looks, after
/// Schlick. An image in a floor lies as deep below it as the box is above it,
/// which shifts it down by 2 / distance [tangent].
glm::vec3 floorReflection(glm::vec3 d) {
  const float grazing = 1.0f + d.y;
  const float grazing2 = grazing * grazing;
  const float reflectance = 0.032f + 0.768f * grazing2 * grazing2 * grazing;
  const float across = std::sqrt(std::max(1.0f - d.y * d.y, 0.0f));
  const glm::vec3 mirrored(d.x, -d.y - 0.13f * across, d.z);
  glm::vec3 light(0.0f);
  for (const SoftBox& box : softBoxes()) box.layOver(light, mirrored, kWidestEdge);
  return light * (reflectance * glm::smoothstep(0.0f, 0.12f, -d.y));
}

}  // namespace

glm::vec3 studioRadiance(glm::vec3 d) {
  glm::vec3 light = roomRadiance(d);
  if (d.y < 0.0f) light += floorReflection(d);
  for (const SoftBox& box : softBoxes()) box.layOver(light, d, 0.04f);
  return light;
}

}  // namespace mirrorball
