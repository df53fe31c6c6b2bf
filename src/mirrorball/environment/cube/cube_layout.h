#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// How the six faces of a cube are stored: in six files, or in one picture.
enum class CubeLayout { faces, hcross, vcross, hstrip, vstrip, tiles, lecture };

/// "faces", "hcross", "vcross", "hstrip", "vstrip", "3x2", "lecture": the enumeration's order.
std::span<const std::string_view> cubeLayoutNames();
std::string_view nameOf(CubeLayout layout);
/// errors   usage: lists the names
Result<CubeLayout> cubeLayoutNamed(std::string_view name);

/// Columns and rows of faces in the one picture of a layout; (1, 1) for separate faces.
glm::ivec2 cellsOf(CubeLayout layout);

/// The column and the row of a face in the one picture of a layout. There it may be turned: −Z of vcross, and those of
/// `lecture`.
///
/// face     0 … 5: +X −X +Y −Y +Z −Z
glm::ivec2 cellOf(CubeLayout layout, int face);

/// "+X", "-X", "+Y", "-Y", "+Z", "-Z"
std::string_view cubeFaceName(int face);

/// The one-picture layout whose columns : rows are width : height; of the two that are 4:3, hcross.
std::optional<CubeLayout> layoutOfShape(int width, int height);

/// Where a place of a cube lies in the one picture of a layout.
///
/// place    of a face, 0 … 5
/// layout   any but `faces`
/// returns  shares of the picture's width and height, from its top left corner
glm::vec2 placeInLayout(const MapPosition& place, CubeLayout layout);

/// Six images of one size as one picture. Cells without a face are black.
///
/// faces    one level of six squares
/// layout   any but `faces`
Image composeLayout(const ImageSet& faces, CubeLayout layout);

/// The six images in one picture.
///
/// layout   any but `faces`
/// errors   bad_shape: the picture's sides are not in the layout's proportion
Result<ImageSet> splitLayout(const Image& picture, CubeLayout layout);

}  // namespace mirrorball
