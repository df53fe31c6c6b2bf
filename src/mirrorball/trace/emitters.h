#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/rays/emissive_triangles.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// The surfaces that shine by themselves, as lights that paths choose: a small lamp is else met by one path in many,
/// which is then a bright pixel. Left to those paths are reliefs, whose surface is elsewhere than its triangles, and
/// what shines below a clear coat or cloth, which let a share through that only a path finds.
class Emitters {
 public:
  /// scene, world_from_normal   as EmissiveTriangles has them; they must outlive this
  /// mean_luminance             of the environment, as it is shown
  /// cost                       that of EmissiveTriangles
  Emitters(const Scene& scene, const std::vector<glm::mat3>& world_from_normal, float mean_luminance,
           const TraceSettings& settings);

  /// How many of the light samples at a place look for an emitter, in place of the environment: by the light that both
  /// would send there if nothing were in the way. 0 where none is to be found: none shines, or nothing hides light.
  float share(glm::vec3 place) const;

  struct Choice {
    LightSample sample = {};  ///< seen from the place
    std::uint32_t instance = 0;
    std::uint32_t triangle = 0;  ///< of its mesh
    glm::vec3 position{0.0f};    ///< world
    bool is_emitter = false;     ///< else it is of the environment
  };
  /// A place that shines, by brightness and area.
  ///
  /// numbers   uniform
  Choice chosen(glm::vec3 place, glm::vec3 numbers) const;

  /// The density [1/sr] with which `chosen` returns the direction in which a ray has met a triangle; 0: never.
  float pdf(const Hit& hit, glm::vec3 direction) const;

 private:
  EmissiveTriangles triangles_;
  float irradiance_of_environment_;
};

}  // namespace mirrorball
