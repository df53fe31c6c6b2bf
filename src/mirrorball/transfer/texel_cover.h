#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Where a triangle's corners are in a texture: glTF's, (0, 0) is the top left.
using UvTriangle = std::array<glm::vec2, 3>;

/// What lies at a sample of a texel.
struct CoverSample {
  static constexpr std::uint32_t kNothing = ~0u;
  std::uint32_t triangle = kNothing;
  glm::vec2 barycentric{0.0f};  ///< of the triangle's second and third corner
  bool is_shared = false;       ///< lies well inside of another triangle too
};

/// Which triangles lie at the texels of a map. Coordinates beyond [0, 1] are wrapped, as a texture that repeats does.
class TexelCover {
 public:
  /// triangles  those without an area cover nothing
  /// size       of the map, at least 1×1
  /// side       side² samples a texel, in rows and columns; at least 1
  /// errors     out_of_range: a triangle reaches over more than 16 repetitions of the map
  /// cost       O(triangles + rows that they touch)
  static Result<TexelCover> make(std::vector<UvTriangle> triangles, glm::ivec2 size, int side);

  std::size_t samplesPerTexel() const { return std::size_t(side_) * std::size_t(side_); }

  /// Sets the samples of a row of texels, texel by texel. Where triangles overlap it is the first.
  ///
  /// samples  width · side²
  /// returns  how many samples are well inside more than one triangle
  std::size_t coverRow(int y, std::span<CoverSample> samples) const;

 private:
  /// A triangle in a row of texels, that of the map or a repetition of it.
  struct Entry {
    std::uint32_t triangle;
    int row;
  };

  TexelCover(std::vector<UvTriangle> triangles, glm::ivec2 size, int side)
      : triangles_(std::move(triangles)), size_(size), side_(side) {}
  Result<void> sortIntoRows();
  std::size_t coverBy(const Entry& entry, std::span<CoverSample> samples) const;

  std::vector<UvTriangle> triangles_;
  glm::ivec2 size_;
  int side_;
  std::vector<Entry> entries_;      ///< row by row, in the order of the triangles
  std::vector<std::size_t> begin_;  ///< of each row's entries, and their end
};

}  // namespace mirrorball
