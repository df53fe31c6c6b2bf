#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Finds where alpha masks cut triangles away (Instance::holes), by the opacity in the middle of each cell.
///
/// cost   a look-up in a texture for each cell of triangles whose material has a mask: at most 1024 cells, of about a
///        texel each
void findHoles(Scene& scene);

}  // namespace mirrorball
