#include "mirrorball/light_edit/lamp_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

constexpr std::size_t kSectors = 128;
constexpr float kSmoothed = 0.01f;  // of the reach

/// The plane around a middle: each direction is as far from the origin as it is from the middle [rad].
class PlaneAround {
 public:
  explicit PlaneAround(glm::vec3 middle) : world_from_plane_(centredOn(middle)) {}

  glm::vec2 placeOf(glm::vec3 direction) const {
    const glm::vec3 d = glm::transpose(world_from_plane_) * direction;
    const float sine = std::hypot(d.x, d.y);
    return sine > 0.0f ? glm::vec2(d.x, d.y) * (std::atan2(sine, d.z) / sine) : glm::vec2(0.0f);
  }

  glm::vec3 directionAt(glm::vec2 place) const {
    const float angle = glm::length(place);
    const glm::vec2 across = angle > 0.0f ? place * (std::sin(angle) / angle) : glm::vec2(0.0f);
    return glm::normalize(world_from_plane_ * glm::vec3(across, std::cos(angle)));
  }

 private:
  glm::mat3 world_from_plane_;
};

/// Above 0 where c lies on the left of the line from a to b: by how much, times the line's length.
float onTheLeft(glm::vec2 a, glm::vec2 b, glm::vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The corners of the convex hull, counter-clockwise (Andrew 1979: the lower chain, then the upper one). A corner that
/// stands out from its neighbours' line by less than `least` is left out.
std::vector<glm::vec2> hullOf(std::vector<glm::vec2> points, float least) {
  std::sort(points.begin(), points.end(), [](glm::vec2 a, glm::vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<glm::vec2> hull;
  const auto addChain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= first + 2) {
        const glm::vec2 before = hull[hull.size() - 2];
        if (onTheLeft(before, hull.back(), *point) > least * glm::length(*point - before)) break;
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();  // the next chain begins with it
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

/// Of each sector around the origin the farthest.
std::vector<glm::vec2> farthestOf(const PlaneAround& plane, std::span<const glm::vec3> points) {
  std::array<glm::vec2, kSectors> farthest{};
  for (const glm::vec3& point : points) {
    const glm::vec2 place = plane.placeOf(point);
    const float turn = std::atan2(place.y, place.x) / (2.0f * std::numbers::pi_v<float>)+0.5f;
    glm::vec2& in_sector = farthest[std::min(static_cast<std::size_t>(turn * kSectors), kSectors - 1)];
    if (glm::dot(place, place) > glm::dot(in_sector, in_sector)) in_sector = place;
  }
  std::vector<glm::vec2> places;
  for (const glm::vec2 place : farthest)
    if (place != glm::vec2(0.0f)) places.push_back(place);
  return places;
}

}  // namespace

std::vector<glm::vec3> outlineAround(glm::vec3 middle, std::span<const glm::vec3> points) {
  const PlaneAround plane(middle);
  std::vector<glm::vec2> places = farthestOf(plane, points);
  float reach = 0.0f;
  for (const glm::vec2 place : places) reach = std::max(reach, glm::length(place));
  std::vector<glm::vec3> outline;
  if (places.empty()) return outline;
  for (const glm::vec2 corner : hullOf(std::move(places), kSmoothed * reach))
    outline.push_back(plane.directionAt(corner));
  return outline;
}

}  // namespace mirrorball
