#pragma once

#include <glm/glm.hpp>

#include "mirrorball/rays/ray.h"
#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/trace/emitters.h"
#include "mirrorball/trace/surroundings.h"
#include "mirrorball/trace/trace_settings.h"
#include "mirrorball/trace/world.h"

namespace mirrorball {

/// What one path has found.
struct PathLight {
  glm::vec4 radiance{0.0f};  ///< linear; alpha 0 where nothing is
  // Of the first surface, for denoisers; 0 where there is none:
  glm::vec3 albedo{0.0f};  ///< its base colour, or a metal's reflectance at normal incidence
  glm::vec3 normal{0.0f};  ///< world, with bumps, on the eye's side
};

/// Follows light backwards, from the eye from surface to surface to what shines.
///
/// surroundings, emitters   of the world, with these settings
/// cost     docs/performance/paths.md has paths a second
PathLight lightAlong(const World& world, const Surroundings& surroundings, const Emitters& emitters,
                     const TraceSettings& settings, Ray ray, SampleSequence& samples);

}  // namespace mirrorball
