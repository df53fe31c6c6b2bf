#include "mirrorball/scene/mesh_file/polygon.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <glm/glm.hpp>

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::size_t kLargestClipped = 1000;

/// Twice the polygon's area along its normal (Newell's method: exact for any plane polygon, sensible for a bent one).
dvec3 areaVector(std::span<const glm::vec3> corners) {
  dvec3 sum(0.0);
  const dvec3 origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += glm::cross(dvec3(corners[i]) - origin, dvec3(corners[(i + 1) % corners.size()]) - origin);
  return sum;
}

/// Corners as they are seen along the polygon's normal, from where it is wound counter-clockwise.
std::vector<dvec2> seenAlong(dvec3 normal, std::span<const glm::vec3> corners) {
  // The axis that the normal is farthest from makes the frame; of a polygon in a plane of axes it is of axes too.
  const dvec3 size = glm::abs(normal);
  const dvec3 axis = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                     : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                          : dvec3(0, 0, 1);
  const dvec3 across = glm::cross(axis, normal);
  const dvec3 up = glm::cross(normal, across);
  const double across_length = glm::length(across);
  const double up_length = glm::length(up);
  std::vector<dvec2> seen;
  for (const glm::vec3& corner : corners)
    seen.emplace_back(glm::dot(dvec3(corner), across) / across_length, glm::dot(dvec3(corner), up) / up_length);
  return seen;
}

/// Twice the area of a triangle; positive where it is wound counter-clockwise.
double turn(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x); }

/// Whether a point lies in a triangle that is wound counter-clockwise, or on its edge.
bool contains(dvec2 a, dvec2 b, dvec2 c, dvec2 point) {
  return turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
}

/// What is left of a polygon while ears are cut off.
///
/// Only corners that do not bend outwards can be the innermost of those within an ear, so only they are looked at; and
/// a cut changes nothing for corners but those beside it (Eberly, "Triangulation by Ear Clipping", 2002). So each
/// corner is compared with the inward ones three times, and not with all at each cut.
class Clipping {
 public:
  explicit Clipping(std::vector<dvec2> corners) : corners_(std::move(corners)), remaining_(corners_.size()) {
    std::iota(remaining_.begin(), remaining_.end(), 0u);
    is_ear_.resize(corners_.size());
    for (std::size_t i = 0; i < remaining_.size(); ++i)
      if (!bendsOutwards(i)) inward_.push_back(remaining_[i]);
    for (std::size_t i = 0; i < remaining_.size(); ++i) look(i);
  }

  const std::vector<std::uint32_t>& remaining() const { return remaining_; }
  bool isEar(std::size_t i) const { return is_ear_[remaining_[i]]; }

  /// Takes away the ear at `i`.
  Triangle cut(std::size_t i) {
    const Triangle ear{remaining_[before(i)], remaining_[i], remaining_[after(i)]};
    remaining_.erase(remaining_.begin() + static_cast<std::ptrdiff_t>(i));
    const std::size_t next = i % remaining_.size();
    for (const std::size_t beside : {before(next), next}) {
      if (bendsOutwards(beside)) std::erase(inward_, remaining_[beside]);
      look(beside);
    }
    return ear;
  }

 private:
  std::size_t before(std::size_t i) const { return (i == 0 ? remaining_.size() : i) - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == remaining_.size() ? 0 : i + 1; }
  dvec2 corner(std::size_t i) const { return corners_[remaining_[i]]; }

  bool bendsOutwards(std::size_t i) const { return turn(corner(before(i)), corner(i), corner(after(i))) > 0.0; }

  /// Finds out whether the corner at `i` can be cut off: it bends outwards, and no other corner lies inside.
  void look(std::size_t i) {
    const dvec2 a = corner(before(i)), b = corner(i), c = corner(after(i));
    const auto isInTheWay = [&](std::uint32_t index) {
      const dvec2 other = corners_[index];
      return other != a && other != b && other != c && contains(a, b, c, other);
    };
    is_ear_[remaining_[i]] = bendsOutwards(i) && std::none_of(inward_.begin(), inward_.end(), isInTheWay);
  }

  std::vector<dvec2> corners_;
  std::vector<std::uint32_t> remaining_;  // in order
  std::vector<std::uint32_t> inward_;     // of those, the corners that do not bend outwards; in any order
  std::vector<bool> is_ear_;              // by corner
};

}  // namespace

std::vector<Triangle> triangulate(std::span<const glm::vec3> corners) {
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() - 2);
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);

  const dvec3 normal = areaVector(corners);
  if (corners.size() > 3 && corners.size() <= kLargestClipped && normal != dvec3(0.0)) {
    Clipping clipping(seenAlong(normal, corners));
    // Starting at the second corner makes a convex polygon a fan about the first.
    std::size_t i = 1;
    std::size_t refused = 0;
    while (clipping.remaining().size() > 3 && refused < clipping.remaining().size()) {
      i %= clipping.remaining().size();
      if (!clipping.isEar(i)) {
        ++refused;
        ++i;
        continue;
      }
      triangles.push_back(clipping.cut(i));
      refused = 0;
    }
    left = clipping.remaining();
  }
  // The last triangle; for a polygon without ears (crossing itself, without area) a fan of what is left.
  for (std::size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
  return triangles;
}

}  // namespace mirrorball
