#pragma once

#include <cstddef>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A model's shape with fewer triangles.
struct Simplified {
  Mesh mesh;           ///< world; vertices at one place are one, normals smooth; without texture coordinates or colours
  float error = 0.0f;  ///< how far about the surface has moved, in shares of the model's greatest side
};

/// Joins all instances of a scene into one mesh of at most that many triangles, by collapsing edges in the order of
/// their quadric errors (Garland & Heckbert 1997; meshoptimizer). Where the surface's connections allow no more
/// collapses there are more triangles than asked for.
///
/// triangles  at least 1
/// errors     bad_shape: the scene has no triangle with an area, or all vanish
/// cost       1 µs a triangle of the scene
Result<Simplified> simplified(const Scene& scene, std::size_t triangles);

}  // namespace mirrorball
