#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A drinking glass, one closed surface: outer wall, rounded rim, inner wall and a thick bottom. It stands upright on
/// +Y, with its bounding sphere about the origin and radius 1.
Mesh tumblerMesh();

/// The same of glass, filled with water to six tenths of its height. The water is a body of its own that reaches into
/// the middle of the glass's wall, so that there is no gap of air between them; the glass has the greater priority and
/// fills the wall (Schmidt & Budge 2002). The water's surface is flat.
Scene tumblerWaterScene();

}  // namespace mirrorball
