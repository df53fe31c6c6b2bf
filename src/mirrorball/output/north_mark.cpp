#include "mirrorball/output/north_mark.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/glm.hpp>

#include "formula/color.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

/// A stroke from one point to another; x goes to the right and y up, in degrees from north on the horizon.
struct Stroke {
  glm::vec2 begin;
  glm::vec2 end;
};

constexpr std::array<Stroke, 4> kStrokes{{{{0.0f, -8.0f}, {0.0f, 5.0f}},
                                          {{-2.6f, 7.0f}, {-2.6f, 15.0f}},
                                          {{-2.6f, 15.0f}, {2.6f, 7.0f}},
                                          {{2.6f, 7.0f}, {2.6f, 15.0f}}}};
constexpr float kHalfWidth_deg = 0.4f;
constexpr float kEdge_deg = 0.3f;    // of the dark edge
constexpr float kReach_deg = 18.0f;  // of the whole mark
constexpr float kTexel_deg = 0.35f;  // that the mark is drawn for; larger texels have a larger mark
constexpr float kLargest = 6.0f;     // times as large
constexpr float kTimesTheMean = 4.0f;

float distanceTo(const Stroke& stroke, glm::vec2 point) {
  const glm::vec2 along = stroke.end - stroke.begin;
  const float share = glm::clamp(glm::dot(point - stroke.begin, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::distance(point, stroke.begin + share * along);
}

/// The plane in which the mark is drawn: each direction is as many degrees to the right of north and above the horizon.
class MarkPlane {
 public:
  MarkPlane(const CompassAxes& axes, float scale)
      : axes_(axes), right_(glm::cross(axes.north, axes.up)), scale_(scale) {}

  glm::vec2 project(glm::vec3 direction) const {
    const float x = std::atan2(glm::dot(direction, right_), glm::dot(direction, axes_.north));
    const float y = std::asin(glm::clamp(glm::dot(direction, axes_.up), -1.0f, 1.0f));
    return glm::degrees(glm::vec2(x, y)) / scale_;
  }

 private:
  CompassAxes axes_;
  glm::vec3 right_;
  float scale_;
};

/// How much of a texel lies within a distance.
float cover(float distance, float within, float texel) {
  return glm::clamp((within - distance) / texel + 0.5f, 0.0f, 1.0f);
}

}  // namespace

void drawNorth(const CompassAxes& axes, EnvironmentMap& panorama) {
  assert(panorama.projection() == Projection::equirect);
  const glm::ivec2 extent = panorama.extent();
  const float texel_deg = 180.0f / float(extent.y);
  const float scale = glm::clamp(texel_deg / kTexel_deg, 1.0f, kLargest);
  const float texel = texel_deg / scale;
  const MarkPlane plane(axes, scale);
  Image& image = panorama.face(0);
  const auto forTexelsOfMark = [&](const auto& visit) {
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(extent);
        const glm::vec2 place = plane.project(directionAt(Projection::equirect, {0, uv}));
        if (glm::dot(place, place) < kReach_deg * kReach_deg) visit(x, y, place);
      }
  };
  double sum = 0.0;
  std::size_t count = 0;
  forTexelsOfMark([&](int x, int y, glm::vec2) {
    const float light = formula::luminance(rgbAt(image, x, y));
    if (!std::isfinite(light)) return;
    sum += double(std::max(light, 0.0f));
    ++count;
  });
  const float white = std::max(kTimesTheMean * float(sum / double(std::max(count, std::size_t(1)))), 1.0f);
  forTexelsOfMark([&](int x, int y, glm::vec2 place) {
    float distance = kReach_deg;
    for (const Stroke& stroke : kStrokes) distance = std::min(distance, distanceTo(stroke, place));
    const float dark = cover(distance, kHalfWidth_deg + kEdge_deg, texel);
    if (dark <= 0.0f) return;
    const float bright = cover(distance, kHalfWidth_deg, texel);
    for (int c = 0; c < std::min(image.channels(), 3); ++c) {
      float& light = image.texel(x, y)[c];
      light = (1.0f - dark) * light + bright * white;
    }
  });
}

}  // namespace mirrorball
