#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/convert/point_batch.h"
#include "mirrorball/image/texel_allocator.h"

namespace mirrorball {

/// Four smooth functions on the sphere, on rings at θ = (j + ½) π / rings and meridians at φ = i 2π / columns, where
/// (φ, θ) are a panorama's (u · 2π, v · π). Along a ring the values are those of cubic B-splines, along a meridian the
/// functions' own.
class SphereGrid {
 public:
  /// rings, columns   both even
  SphereGrid(int rings, int columns);

  int rings() const { return rings_; }
  int columns() const { return columns_; }

  glm::vec4* ring(int j) { return values_.data() + offset(j); }
  const glm::vec4* ring(int j) const { return values_.data() + offset(j); }

  /// Continues the grid over its seam and the poles, after all rings are set.
  void close();

  /// The functions at all points of a batch: reads u and v as a panorama's.
  ///
  /// cost     about 10 ns a point
  void sample(const PointBatch& points, glm::vec4* values) const;

 private:
  static constexpr int kRingsBeyond = 3;    // that six points along a meridian reach over a pole
  static constexpr int kColumnsBeyond = 2;  // that four points along a ring reach over the seam

  std::size_t offset(int j) const {
    return std::size_t(j + kRingsBeyond) * std::size_t(columns_ + 2 * kColumnsBeyond) + kColumnsBeyond;
  }

  int rings_;
  int columns_;
  std::vector<glm::vec4, TexelAllocator<glm::vec4>> values_;
};

}  // namespace mirrorball
