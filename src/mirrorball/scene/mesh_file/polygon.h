#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace mirrorball {

/// How much work is done for a polygon of so many corners, in steps: to look at one other corner, or at one row of a
/// grid of them. All polygons of up to a thousand corners are done with less, and larger ones whose corners do not all
/// lie in each other's way.
constexpr std::uint64_t mostSteps(std::size_t corners) { return std::uint64_t{6000} * corners; }

/// What it took to cut a polygon into triangles.
struct TriangulationWork {
  std::uint64_t steps = 0;  ///< the last look goes to its end: up to two a corner more than mostSteps()
  /// So many corners bend inwards and lie in each other's way that the work was ended: the triangles of the rest are a
  /// fan, which may leave the polygon.
  bool gave_up = false;
};

/// Cuts a polygon into triangles by clipping ears, so that concave ones come out right too.
///
/// corners  in order, at least 3; nearly in one plane
/// work     gets what it took
/// returns  corners.size() − 2 triangles of indices into `corners`, wound as the polygon is
/// cost     O(n √k) for k corners that bend inwards, of polygons as they are found; at most mostSteps(),
///          some 20 µs a corner, of 300,000 that all lie in one cell; 100 bytes a corner, the triangles included
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::vec3> corners,
                                                      TriangulationWork* work = nullptr);

}  // namespace mirrorball
