#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What is shown of an input.
struct ContactCell {
  std::optional<Image8> picture = {};  ///< 3 channels, at most as large as the layout's; nothing: it could not be made
  std::string name = {};               ///< UTF-8; shortened where it is too long
  std::string facts = {};              ///< a line in smaller letters
};

/// Where the cells of a sheet lie, row by row [pixels].
struct ContactLayout {
  glm::ivec2 grid{1};        ///< columns and rows
  glm::ivec2 picture_px{0};  ///< of a cell's picture
  int name_scale = 1;        ///< of lettering.h
  int facts_scale = 1;

  int gap_px() const;
  glm::ivec2 cellSize() const;
  glm::ivec2 sheetSize() const;
  /// Upper left corner of a cell's picture.
  glm::ivec2 corner(std::size_t cell) const;
};

/// Lays out that many cells, at least one.
///
/// columns  0: those that bring the sheet's shape nearest to 16:10
/// errors   too_large: the sheet and the pictures on it do not fit into memoryLimit()
Result<ContactLayout> contactLayout(std::size_t cells, glm::ivec2 picture_px, int columns);

/// Draws the sheet: each picture in the middle of its cell, its name and its facts below. A cell without a picture says
/// that.
///
/// cells    as many as the layout is for
/// paper    what is beside them, sRGB's codes; letters are light on dark paper and dark on light one
/// returns  3 channels, encoded
Image8 drawContactSheet(std::span<const ContactCell> cells, const ContactLayout& layout,
                        glm::vec<3, std::uint8_t> paper);

}  // namespace mirrorball
