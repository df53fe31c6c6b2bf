#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {

/// Ten texels in a triangle: `first` + `step` · (i, j) with i + j ≤ 3, and where among them a position lies, counted in
/// steps.
struct CubicStencil {
  glm::ivec2 first;
  glm::ivec2 step;  ///< 1 or −1 each
  glm::vec2 inside;
};

/// A part of a map on which directions change without a kink, so that a cubic may run across its texels: a face of a
/// cube, a disc of a paraboloid map, one of the eight triangles in which an octahedral map shows an octahedron's faces.
///
/// Positions are in texels from the image's top left corner.
class SmoothRegion {
 public:
  /// The region on which a place lies; of a projection with `hasSmoothRegions`.
  SmoothRegion(Projection projection, int side, MapPosition place);

  int face() const { return face_; }

  /// Whether a position of its image lies on it; its border does.
  bool holds(glm::vec2 position) const;

  /// Where the map shows the direction that the region, continued a few texels beyond its border, would show there.
  /// Beyond the edge of a map of one half it is the position itself.
  MapPosition placeOf(glm::vec2 position) const;

  /// Texels of this region alone around one of its positions, for the cubic polynomial in two variables through them;
  /// none if it is too small.
  std::optional<CubicStencil> cubicStencil(glm::vec2 position) const;

 private:
  enum class Shape { square, disc, triangle };

  void standOnTriangle(glm::vec2 from_middle);
  MapPosition onOctahedron(glm::vec2 position) const;
  MapPosition onEqualArea(glm::vec2 position) const;
  void moveOntoDisc(glm::vec2 first_center, glm::ivec2& index) const;

  Projection projection_;
  Shape shape_;
  int face_;
  float side_;
  glm::vec2 corner_;   ///< from which its texels are counted: of a triangle the right angle
  glm::vec2 towards_;  ///< 1 or −1 each: the way from there into the region
};

/// Whether a projection's images are cut into smooth regions. A panorama goes on without an edge; a disc that shows all
/// directions ends in a rim beyond which there are none.
bool hasSmoothRegions(Projection projection);

}  // namespace mirrorball
