#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace mirrorball {

/// Cuts a polygon into triangles by clipping ears, so that concave ones come out right too.
///
/// corners  in order, at least 3; nearly in one plane
/// gave_up  whether so many corners bend inwards and lie in each other's way that the work was ended: the triangles of
///          the rest are a fan, which may leave the polygon
/// returns  corners.size() − 2 triangles of indices into `corners`, wound as the polygon is
/// cost     O(n √k) for k corners that bend inwards, of polygons as they are found; at most 30 µs a corner
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::vec3> corners, bool* gave_up = nullptr);

}  // namespace mirrorball
