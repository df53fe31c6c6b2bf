#include "mirrorball/output/north_mark.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
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

/// The texels of a panorama that the mark may reach, row by row.
class MarkTexels {
 public:
  MarkTexels(const CompassAxes& axes, glm::ivec2 extent)
      : extent_(extent),
        scale_(glm::clamp(180.0f / float(extent.y) / kTexel_deg, 1.0f, kLargest)),
        north_(axes.north),
        plane_(axes, scale_),
        least_cosine_(std::cos(glm::radians(kReach_deg * scale_)) - kRounding) {}

  /// A texel's height in the units of the mark [degrees].
  float texelSize() const { return 180.0f / float(extent_.y) / scale_; }

  /// Calls `visit(x, y, place)` for each that lies within the mark's reach: on all cores, each row on one of them.
  void forEach(const std::function<void(int x, int y, glm::vec2 place)>& visit) const {
    constexpr std::size_t kRows = 8;
    parallelFor(std::size_t(extent_.y), kRows, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y) visitRow(int(y), visit);
    });
  }

 private:
  static constexpr float kRounding = 1e-3f;  // of cosines near the poles

  glm::vec3 texelDirection(int x, int y) const {
    return directionAt(Projection::equirect, {0, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent_)});
  }

  // The sphere bulges: a direction is never farther from north than its place in the plane is from the plane's origin.
  // So a cosine rejects most directions without an inverse function, and most rows whole: by the difference of the
  // latitudes, which is less still.
  void visitRow(int y, const std::function<void(int x, int y, glm::vec2 place)>& visit) const {
    const float sine = texelDirection(0, y).y;
    const float nearest =
        sine * north_.y + std::sqrt(std::max((1.0f - sine * sine) * (1.0f - north_.y * north_.y), 0.0f));
    if (nearest < least_cosine_) return;
    for (int x = 0; x < extent_.x; ++x) {
      const glm::vec3 direction = texelDirection(x, y);
      if (glm::dot(direction, north_) < least_cosine_) continue;
      const glm::vec2 place = plane_.project(direction);
      if (glm::dot(place, place) < kReach_deg * kReach_deg) visit(x, y, place);
    }
  }

  glm::ivec2 extent_;
  float scale_;
  glm::vec3 north_;
  MarkPlane plane_;
  float least_cosine_;
};

/// The mean light of the texels around the mark. Each row has a sum of its own, so that the number of threads does not
/// change it.
float meanLight(const Image& image, const MarkTexels& texels) {
  struct Row {
    double sum = 0.0;
    std::size_t count = 0;
  };
  std::vector<Row> rows(std::size_t(image.height()));
  texels.forEach([&](int x, int y, glm::vec2) {
    const float light = formula::luminance(rgbAt(image, x, y));
    if (!std::isfinite(light)) return;
    rows[std::size_t(y)].sum += double(std::max(light, 0.0f));
    ++rows[std::size_t(y)].count;
  });
  Row all;
  for (const Row& row : rows) {
    all.sum += row.sum;
    all.count += row.count;
  }
  return float(all.sum / double(std::max(all.count, std::size_t(1))));
}

}  // namespace

void drawNorth(const CompassAxes& axes, EnvironmentMap& panorama) {
  assert(panorama.projection() == Projection::equirect);
  const MarkTexels texels(axes, panorama.extent());
  const float texel = texels.texelSize();
  Image& image = panorama.face(0);
  const float white = std::max(kTimesTheMean * meanLight(image, texels), 1.0f);
  texels.forEach([&](int x, int y, glm::vec2 place) {
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
