#pragma once

#include <array>
#include <cstddef>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A triangle where an instance puts it.
struct PlacedTriangle {
  std::array<glm::vec3, 3> corners;  ///< world
  std::array<glm::vec3, 3> normals;  ///< world, smooth, of any length
  glm::vec3 geometric_normal{0.0f};  ///< unit: facingOutwards
  float longest_edge = 0.0f;

  /// The point with those barycentric weights.
  glm::vec3 at(glm::vec3 weights) const;
  glm::vec3 normalAt(glm::vec3 weights) const;
  /// The same as it is from behind.
  PlacedTriangle turnedOver() const;
};

/// mesh   the instance's, or what it has become
PlacedTriangle placedTriangle(const Mesh& mesh, const Instance& instance, std::size_t triangle);

/// What the scene hides of the sky from a place of a triangle, by 32 rays that are the same from each place, so that
/// what differs is the place.
///
/// weights   of the triangle's corners, at most places none of which is 0: at edges, folds are seen from neither side
/// returns   the mean of the occluded directions, those that are open counting as 0; the open share
glm::vec4 seenFrom(const Scene& scene, const Geometry& geometry, const PlacedTriangle& placed, glm::vec3 weights);

/// Whether the backs of an instance's triangles are drawn and may be seen: those of a closed body are not. Of at most
/// 16 triangles the middles are asked.
bool showsBacks(const Scene& scene, const Geometry& geometry, const Instance& instance);

/// Whether some place sees less than nine tenths of an even sky: of a thousand triangles, evenly chosen by their
/// number, the middles.
///
/// errors   as Geometry::make's
/// cost     that of Geometry::make, and up to 20 ms
Result<bool> hidesItself(const Scene& scene);

}  // namespace mirrorball
