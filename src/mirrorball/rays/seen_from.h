#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

/// What a place sees of a scene in place of the sky.
struct SeenScene {
  glm::vec3 occluded{0.0f};  ///< the mean of the occluded directions, those that are open counting as 0
  float open = 0.0f;         ///< the share of the sky
  float nearness = 0.0f;     ///< the mean of 1 over the distance of what is met, where nothing is met 0 [1/world unit]
};

/// What the scene hides of the sky from a place of a triangle, by 32 rays that are the same from each place, so that
/// what differs is the place.
///
/// weights   of the triangle's corners, at most places none of which is 0: at edges, folds are seen from neither side
SeenScene seenFrom(const Scene& scene, const Geometry& geometry, const PlacedTriangle& placed, glm::vec3 weights);

/// Whether the backs of an instance's triangles are drawn and may be seen: those of a closed body are not. Of at most
/// 16 triangles the middles are asked.
bool showsBacks(const Scene& scene, const Geometry& geometry, const Instance& instance);

/// showsBacks of each.
std::vector<std::uint8_t> instancesWithBacks(const Scene& scene, const Geometry& geometry);

/// Whether some place may see less than nine tenths of an even sky. Most models are found out at the middles of a
/// thousand triangles, evenly chosen by their number; those that do not hide themselves there, by hidesLittleSurely.
///
/// errors   as Geometry::make's
/// cost     that of Geometry::make, and up to 20 ms; where nothing hides the sky at those places, hidesLittleSurely's
Result<bool> hidesItself(const Scene& scene);

}  // namespace mirrorball
