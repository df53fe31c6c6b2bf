#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/rays/emissive_triangles.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// The surfaces that shine by themselves, as lights that paths choose: a small lamp is else met by one path in many,
/// which is then a bright pixel.
class Emitters {
 public:
  /// triangles         of the scene; both must outlive this
  /// mean_luminance    of the environment, as it is shown
  Emitters(const Scene& scene, const EmissiveTriangles& triangles, float mean_luminance, const TraceSettings& settings);

  /// How many of the light samples at a place look for an emitter, in place of the environment: by the light that both
  /// would send there if nothing were in the way. 0 where none is to be found: none shines, or nothing hides light.
  float share(glm::vec3 place) const;

  struct Choice {
    LightSample sample = {};  ///< towards it, seen from the place
    std::uint32_t instance = 0;
    std::uint32_t triangle = 0;  ///< of its mesh
    float distance = 0.0f;
  };
  /// A place that shines, by brightness and area.
  ///
  /// numbers   uniform
  /// returns   with a density of 0 if what was chosen is not looked for in this way
  Choice chosen(glm::vec3 place, glm::vec3 numbers) const;

  /// The density [1/sr] with which `chosen` returns the direction in which a ray has met a triangle; 0: never.
  float pdf(const Hit& hit, glm::vec3 direction) const;

 private:
  bool isChosen(std::uint32_t instance) const;

  const Scene& scene_;
  const EmissiveTriangles& triangles_;
  float irradiance_of_environment_;
  bool is_used_;
  bool moves_surface_;
};

}  // namespace mirrorball
