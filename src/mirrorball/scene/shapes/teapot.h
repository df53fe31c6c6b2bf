#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// Sixteen control points of a bicubic Bézier patch, [row][column], rows downwards and columns to the right as seen
/// from outside.
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// The 32 patches of the Utah teapot in the coordinates of the published data, but +Y up: it stands on y = 0 and is
/// 3.15 high. The lid's eight come first, then the body's sixteen, the handle's four and the spout's four.
///
/// from     Martin Newell 1975, as published in F. Crow, "The Origins of the Teapot", IEEE CG&A 7(1), 1987: Newell's 28
///          patches in Blinn's proportions, and the four of the bottom that were added later
std::vector<BezierPatch> teapotPatches();

/// The Utah teapot, standing upright on +Y, its spout towards +X, its bounding sphere the unit sphere.
///
/// divisions  of each patch's sides, at least 2
/// returns    analytic normals and tangents; the lid is widened by 1.4/1.3 to meet the rim, where the data leave a gap
Mesh teapotMesh(int divisions = 24);

}  // namespace mirrorball
