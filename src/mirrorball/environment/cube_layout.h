#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// How the six faces of a cube lie in files: six files, or one picture.
enum class CubeLayout { faces, hcross, vcross, hstrip, vstrip, tiles };

/// "faces", "hcross", "vcross", "hstrip", "vstrip", "3x2": the enumeration's order.
std::span<const std::string_view> cubeLayoutNames();
std::string_view nameOf(CubeLayout layout);
/// errors   usage: lists the names
Result<CubeLayout> cubeLayoutNamed(std::string_view name);

/// Columns and rows of faces in the one picture of a layout; (1, 1) for separate faces.
glm::ivec2 cellsOf(CubeLayout layout);

/// The one-picture layout whose columns : rows are width : height.
std::optional<CubeLayout> layoutOfShape(int width, int height);

/// The six faces of a cube as one picture. Cells without a face are black.
///
/// cube     a map of projection cube or eac
/// layout   any but `faces`
Image composeLayout(const EnvironmentMap& cube, CubeLayout layout);

/// The cube in one picture.
///
/// projection   cube or eac
/// errors       bad_shape: the picture's sides are not in the layout's proportion
Result<EnvironmentMap> splitLayout(const Image& picture, CubeLayout layout, Projection projection = Projection::cube);

/// What the six files of a cube are called: "px" of "room_px.hdr", in the order of the faces.
inline constexpr std::array<std::string_view, 6> kFaceSuffixes{"px", "nx", "py", "ny", "pz", "nz"};

}  // namespace mirrorball
