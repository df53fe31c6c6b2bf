#pragma once

#include <memory>

#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What rays on the CPU meet of a stage's scene.
struct SceneRays {
  std::shared_ptr<const Scene> scene;  ///< which the geometry reads
  Geometry geometry;

  /// With the reliefs below triangles where they can be searched.
  ///
  /// errors   as Geometry::make's
  /// cost     as its and makeReliefs'
  static Result<SceneRays> make(std::shared_ptr<const Scene> scene);
};

}  // namespace mirrorball
