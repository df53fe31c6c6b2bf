#pragma once

#include <glm/glm.hpp>

#include "formula/surface.h"
#include "mirrorball/rays/frame.h"

namespace mirrorball {

/// A point of a surface as Phong's lights and a model's own are shown by it: the renderer's formulas, with bake/brdf's
/// tables where shaders read textures.
class LampSurface {
 public:
  /// material     its numbers at the point
  /// coat_normal  of a clear coat; unused where there is none
  /// ray          from the eye, unit
  LampSurface(const formula::Material& material, const Frame& frame, glm::vec3 coat_normal, glm::vec3 ray);

  /// The radiance that it shows of a lamp at whose light nothing stands in the way.
  ///
  /// place    world, of the point
  /// factor   on the lamp's light
  glm::vec3 shownOf(const formula::Lamp& lamp, glm::vec3 place, float factor) const;

 private:
  glm::vec3 ray_;
  formula::Surface surface_;
  formula::Surface coat_;
};

}  // namespace mirrorball
