#include "mirrorball/environment/cube/cube_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/cube/cube_arrangement.h"

namespace mirrorball {
namespace {

/// Where a face lies in a layout.
struct Cell {
  int column;
  int row;
  int quarters = 0;  ///< how often it is turned clockwise by 90°
};

/// A layout: its size in faces, and the cell of each face in the order +X −X +Y −Y +Z −Z.
struct LayoutTable {
  std::string_view name;
  glm::ivec2 cells;
  std::array<Cell, 6> faces;
};

constexpr std::array<LayoutTable, 7> kLayouts{{
    {"faces", {1, 1}, {{{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}}}},
    {"hcross", {4, 3}, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
    // Below −Y the cube is unrolled on to −Z, which therefore stands on its head.
    {"vcross", {3, 4}, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, 2}}}},
    {"hstrip", {6, 1}, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
    {"vstrip", {1, 6}, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
    {"3x2", {3, 2}, {{{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}}},
    // The horizontal cross turned clockwise, so that +Y lies right of +Z, with ±X folded out from +Y instead of +Z.
    {"lecture", {4, 3}, {{{2, 2}, {2, 0, 2}, {2, 1, 1}, {0, 1, 1}, {1, 1, 1}, {3, 1, 3}}}},
}};

constexpr auto kNames = [] {
  std::array<std::string_view, kLayouts.size()> names;
  for (std::size_t index = 0; index < names.size(); ++index) names[index] = kLayouts[index].name;
  return names;
}();

const LayoutTable& tableOf(CubeLayout layout) { return kLayouts[static_cast<std::size_t>(layout)]; }

/// Calls visit(texel of the face, texel of the picture) for every texel of a face.
template <typename Visit>
void forEachTexel(const Cell& cell, int side, Visit&& visit) {
  const SquareSymmetry turn = turnedClockwise(cell.quarters);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      visit(turn.from({x, y}, side), glm::ivec2(cell.column, cell.row) * side + glm::ivec2(x, y));
}

}  // namespace

std::span<const std::string_view> cubeLayoutNames() { return kNames; }

std::string_view nameOf(CubeLayout layout) { return tableOf(layout).name; }

Result<CubeLayout> cubeLayoutNamed(std::string_view name) {
  constexpr std::string_view kFormerNameOfLecture = "seed";
  const auto found = indexOfName(name == kFormerNameOfLecture ? nameOf(CubeLayout::lecture) : name, kNames);
  if (!found) return tl::unexpected<Error>(unknownName("cube layout", name, kNames));
  return static_cast<CubeLayout>(*found);
}

glm::ivec2 cellsOf(CubeLayout layout) { return tableOf(layout).cells; }

glm::ivec2 cellOf(CubeLayout layout, int face) {
  const Cell& cell = tableOf(layout).faces[static_cast<std::size_t>(face)];
  return {cell.column, cell.row};
}

std::string_view cubeFaceName(int face) {
  constexpr std::array<std::string_view, 6> kFaceNames{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return kFaceNames[static_cast<std::size_t>(face)];
}

std::optional<CubeLayout> layoutOfShape(int width, int height) {
  for (std::size_t index = 1; index < kLayouts.size(); ++index) {
    const glm::ivec2 cells = kLayouts[index].cells;
    if (width % cells.x == 0 && height % cells.y == 0 && width / cells.x == height / cells.y)
      return static_cast<CubeLayout>(index);
  }
  return std::nullopt;
}

glm::vec2 placeInLayout(const MapPosition& place, CubeLayout layout) {
  const LayoutTable& table = tableOf(layout);
  const Cell& cell = table.faces[static_cast<std::size_t>(place.face)];
  glm::vec2 uv = place.uv;
  for (int quarter = 0; quarter < cell.quarters; ++quarter) uv = {1.0f - uv.y, uv.x};
  return (glm::vec2(cell.column, cell.row) + uv) / glm::vec2(table.cells);
}

Image composeLayout(const ImageSet& faces, CubeLayout layout) {
  assert(faces.faces() == 6 && layout != CubeLayout::faces);
  const LayoutTable& table = tableOf(layout);
  const int side = faces.at(0, 0).width();
  Image picture(table.cells.x * side, table.cells.y * side, faces.at(0, 0).channels());
  for (int face = 0; face < 6; ++face)
    forEachTexel(table.faces[static_cast<std::size_t>(face)], side, [&](glm::ivec2 from, glm::ivec2 to) {
      std::copy_n(faces.at(0, face).texel(from.x, from.y), picture.channels(), picture.texel(to.x, to.y));
    });
  return picture;
}

Result<ImageSet> splitLayout(const Image& picture, CubeLayout layout) {
  const LayoutTable& table = tableOf(layout);
  const int side = picture.width() / table.cells.x;
  if (side == 0 || picture.width() != side * table.cells.x || picture.height() != side * table.cells.y)
    return fail(ErrorCode::bad_shape, sizeText({picture.width(), picture.height()}) + " is not " +
                                          std::to_string(table.cells.x) + ":" + std::to_string(table.cells.y) +
                                          ", as the cube layout " + std::string(table.name) + " is");
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) {
    Image& image = faces.at(0, face) = Image(side, side, picture.channels());
    forEachTexel(table.faces[static_cast<std::size_t>(face)], side, [&](glm::ivec2 to, glm::ivec2 from) {
      std::copy_n(picture.texel(from.x, from.y), picture.channels(), image.texel(to.x, to.y));
    });
  }
  return faces;
}

}  // namespace mirrorball
