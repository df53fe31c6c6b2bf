#pragma once

#include <glm/glm.hpp>

#include "mirrorball/trace/bsdf.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// What a path from the eye has found, and what it carries of the light that it still finds.
struct CarriedLight {
  glm::vec3 sum{0.0f};
  glm::vec3 throughput{1.0f};
  float pdf = 0.0f;  ///< of the ray's direction [1/sr]; 0: nothing else could have chosen it
  /// Of the light samples where the path has left: how many have looked for an emitter, in place of the environment.
  float emitter_share = 0.0f;

  /// How much a light counts where the path has found it: what of it was chosen directly counts there.
  float weightBeside(float pdf_of_light, LightStrategy strategy) const {
    if (pdf <= 0.0f || strategy == LightStrategy::surface) return 1.0f;
    return strategy == LightStrategy::both ? balanceHeuristic(pdf, pdf_of_light) : 0.0f;
  }
};

}  // namespace mirrorball
