#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Where a ray meets a scene.
struct Hit {
  float distance = 0.0f;
  std::uint32_t instance = 0;        ///< index into Scene::instances
  std::uint32_t triangle = 0;        ///< of its mesh
  glm::vec2 barycentric{0.0f};       ///< of the triangle's second and third corner
  glm::vec3 geometric_normal{0.0f};  ///< world, unit, on the counter-clockwise side
  /// Of a place of the relief below the triangle; nothing: of the triangle itself.
  struct Relief {
    glm::vec3 position{0.0f};  ///< world, on the surface, to which the ray may have bent a little
    glm::vec3 up{0.0f};        ///< world: from the bottom of the relief to its top
  };
  std::optional<Relief> relief = {};
};

/// What of a scene rays meet.
enum class Surfaces {
  triangles,  ///< alone
  reliefs,    ///< below triangles whose material has heights, in their place
};

/// What finds the surfaces that rays meet. Both find the same but for rounding.
enum class RayTracer {
  embree,  ///< Intel's Embree 3, which is faster; where it does not run, the other
  own,     ///< a tree as the shaders have it (ray_tree.h)
};

/// Embree, if it is in this build.
RayTracer fastestRayTracer();

/// The triangles of a scene and the reliefs below them, sorted for rays.
class Geometry {
 public:
  /// scene    positions that are not finite are left out with their triangles
  ///          instances do not mirror (Scene)
  /// errors   too_large; unsupported (Embree cannot sort it)
  /// cost     Embree: 0.6 µs a triangle on two cores, and at most 130 bytes; measured on grids of up to 8 million
  ///          triangles. Our own: O(n log n), 170 bytes a triangle
  static Result<Geometry> make(const Scene& scene, RayTracer tracer = fastestRayTracer());

  /// Adds the reliefs, once: without it rays meet triangles in their place.
  ///
  /// scene    the same, which must outlive this and stay where it is
  /// errors   as make's
  /// cost     500 bytes a triangle with heights
  Result<void> makeReliefs(const Scene& scene);

  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) noexcept;
  ~Geometry();

  RayTracer tracer() const;

  /// The nearest surface along a ray.
  ///
  /// direction  unit; a ray that is not finite meets nothing
  /// nearest    distance from which on surfaces count
  std::optional<Hit> hit(glm::vec3 origin, glm::vec3 direction, float nearest,
                         Surfaces surfaces = Surfaces::triangles) const;

 private:
  struct State;
  explicit Geometry(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mirrorball
