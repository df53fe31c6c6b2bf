#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// A patch of the surface between four texel centres (maximum_pyramid.h), and in which copy of a tiled map.
struct SurfacePatch {
  glm::ivec2 place{0};  ///< in [0, width) × [0, height)
  glm::ivec2 shift{0};  ///< of the copy, in texels
};

/// Searches for the steepest way from a relaxed cone's tip to a part of the surface that the cone must not contain: one
/// where a ray from above the tip leaves the surface again, since the tangent plane lies, over the tip, higher than the
/// ray's beginning.
///
/// A node of the pyramid is passed over where even its highest point, as near as any of its points, is not above the
/// steepest way that is known, and where none of its tangent planes can be so high.
class RelaxedConeSearch {
 public:
  /// heights  must outlive it
  /// maxima   of maximumPyramid; must outlive it
  RelaxedConeSearch(const Image& heights, const ImageSet& maxima, MapEdges edges);

  /// For each texel of a row the square of the slope [height / texel] of the steepest way.
  ///
  /// min_square  the least answer
  /// squares     a number for each texel
  void writeSteepestWays(int y, float min_square, float* squares) const;

 private:
  /// The cells of a level; of a node the search asks often.
  struct Level {
    glm::ivec2 cells;
    const float* maxima;
    const float* slopes;
  };
  struct Node {
    int level;
    glm::ivec2 cell;
    glm::ivec2 shift;
    float squared_rise;      ///< of its highest point above the tip
    float squared_distance;  ///< of its nearest point
  };
  /// A tip, and the best that is known of it.
  struct Search {
    glm::ivec2 tip;
    float height;
    float top;  ///< where rays begin, above the tip
    float best;
    SurfacePatch where;
  };
  struct Corners {
    float near, right, below, far;  ///< heights above the tip, at (0, 0), (1, 0), (0, 1) and (1, 1)
  };

  /// A bilinear patch, or a part of one: its first corner and its sides, seen from the tip [texels].
  struct Piece {
    glm::vec2 begin;
    float side;
    Corners heights;
  };

  void boundSlopes();
  float squaredSlope(glm::ivec2 tip, float min_square, SurfacePatch& nearby) const;
  Corners cornersOf(const Search& search, glm::ivec2 place) const;
  bool boundNode(const Search& search, int level, int x, int y, glm::ivec2 shift, Node& node) const;
  static bool mayFaceAway(const float* slopes, glm::vec2 first, glm::vec2 last, float lowest_plane);
  void tryPatch(Search& search, const SurfacePatch& patch) const;
  static float steepestOf(const Piece& piece, float best);
  static float steepestFacingAway(const Piece& piece, float top, float best, int parts);
  int pushChildren(const Search& search, const Node& node, Node* stack) const;

  const Image& heights_;
  const ImageSet& maxima_;
  ImageSet slopes_;  ///< the least and greatest ∂h/∂x, and ∂h/∂y, of each cell, per texel
  MapEdges edges_;
  float highest_;
  std::vector<Level> levels_ = {};
};

}  // namespace mirrorball
