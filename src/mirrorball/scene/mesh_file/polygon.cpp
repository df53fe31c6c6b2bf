#include "mirrorball/scene/mesh_file/polygon.h"

#include <cstddef>
#include <numeric>

#include <glm/glm.hpp>

namespace mirrorball {
namespace {

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

/// Whether `point` lies in the triangle or on its edge, seen along `normal`.
bool contains(dvec3 a, dvec3 b, dvec3 c, dvec3 point, dvec3 normal) {
  const auto left_of = [&](dvec3 from, dvec3 to) {
    return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0;
  };
  return left_of(a, b) && left_of(b, c) && left_of(c, a);
}

/// Whether the corner at `i` of what remains can be cut off: it bends outwards and no other corner lies inside.
bool isEar(std::span<const glm::vec3> corners, const std::vector<std::uint32_t>& remaining, std::size_t i,
           dvec3 normal) {
  const std::size_t count = remaining.size();
  const dvec3 a(corners[remaining[(i + count - 1) % count]]);
  const dvec3 b(corners[remaining[i]]);
  const dvec3 c(corners[remaining[(i + 1) % count]]);
  if (glm::dot(glm::cross(b - a, c - b), normal) <= 0.0) return false;
  for (std::size_t k = 2; k + 1 < count; ++k) {
    const dvec3 other(corners[remaining[(i + k) % count]]);
    if (other != a && other != b && other != c && contains(a, b, c, other, normal)) return false;
  }
  return true;
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const glm::vec3> corners) {
  std::vector<std::uint32_t> remaining(corners.size());
  std::iota(remaining.begin(), remaining.end(), 0u);
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() - 2);

  if (corners.size() > 3 && corners.size() <= kLargestClipped) {
    const dvec3 normal = areaVector(corners);
    // Starting at the second corner makes a convex polygon a fan about the first.
    std::size_t i = 1;
    std::size_t refused = 0;
    while (remaining.size() > 3 && refused < remaining.size()) {
      const std::size_t count = remaining.size();
      i %= count;
      if (!isEar(corners, remaining, i, normal)) {
        ++refused;
        ++i;
        continue;
      }
      triangles.push_back({remaining[(i + count - 1) % count], remaining[i], remaining[(i + 1) % count]});
      remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(i));
      refused = 0;
    }
  }
  // The last triangle; for a polygon without ears (crossing itself, without area) a fan of what is left.
  for (std::size_t i = 1; i + 1 < remaining.size(); ++i)
    triangles.push_back({remaining[0], remaining[i], remaining[i + 1]});
  return triangles;
}

}  // namespace mirrorball
