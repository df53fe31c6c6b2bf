#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Finds where alpha masks cut triangles away (Instance::holes), by the opacity in the middle of each cell.
///
/// Triangles on which a picture is repeated more than four times count as whole.
///
/// cost   a look-up in a texture for each cell of triangles whose material has a mask: at most 1024 cells a triangle,
///        of a texel or more
void findHoles(Scene& scene);

}  // namespace mirrorball
