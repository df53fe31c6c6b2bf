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
/// returns  corners.size() − 2 triangles of indices into `corners`, wound as the polygon is
/// cost     O(n · k) for k corners that bend inwards, besides n² steps of a few instructions; a polygon of more than
///          1000 corners simply becomes a fan
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::vec3> corners);

}  // namespace mirrorball
