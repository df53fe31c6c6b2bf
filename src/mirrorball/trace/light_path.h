#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/ray.h"
#include "mirrorball/trace/surroundings.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// All that paths go through.
struct World {
  Scene scene;
  Environment environment;
  LightSampler lights;
  Geometry geometry;
  std::vector<glm::mat3> world_from_normal;  ///< of each instance: normalMatrices
};

/// What one path has found.
struct PathLight {
  glm::vec4 radiance{0.0f};  ///< linear; alpha 0 where nothing is
  // Of the first surface, for denoisers; 0 where there is none:
  glm::vec3 albedo{0.0f};  ///< its base colour, or a metal's reflectance at normal incidence
  glm::vec3 normal{0.0f};  ///< world, with bumps, on the eye's side
};

/// Follows light backwards, from the eye from surface to surface into the environment.
///
/// surroundings   of the world's environment, with these settings
/// cost     docs/performance/paths.md has paths a second
PathLight lightAlong(const World& world, const Surroundings& surroundings, const TraceSettings& settings, Ray ray,
                     SampleSequence& samples);

/// The bodies that a point lies in: those that at least two of three rays from there leave and have not entered.
formula::Media mediaAt(const World& world, glm::vec3 point, ReliefKind relief);

}  // namespace mirrorball
