#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace mirrorball {

/// What a face without normals says about its edges: a number above 0 is a group, within which all edges are smooth and
/// between which none is.
inline constexpr int kSmoothByAngle = -1;  ///< smooth where two faces turn by less than 45°
inline constexpr int kFlat = 0;            ///< no edge is smooth

/// A face as a file has it, before it is cut into triangles.
struct PolygonFace {
  std::span<const std::uint32_t> corners;  ///< indices of positions, counter-clockwise from outside; 3 at least
  int smoothing = kSmoothByAngle;
};

struct CornerNormals {
  std::vector<glm::vec3> normals;        ///< unit
  std::vector<std::uint32_t> of_corner;  ///< index of the normal of each corner, face after face
};

/// Normals for faces that have none. Corners at one position share a normal if one gets from face to face across smooth
/// edges: the mean of the faces' normals, weighted by angle (Thürmer & Wüthrich 1998). Where more than two faces meet
/// at an edge, those are neighbours that have it in opposite directions.
///
/// positions   those that are equal but have indices of their own are not joined
/// cost        O(n log n)
CornerNormals cornerNormals(std::span<const glm::vec3> positions, std::span<const PolygonFace> faces);

}  // namespace mirrorball
