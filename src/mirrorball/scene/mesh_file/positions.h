#pragma once

#include <cstddef>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Calls `visit` with the place of every vertex of a scene,
/// in double precision so that huge coordinates do not overflow.
///
/// to_from_world   turns places of the world into those that are visited
template <typename Visit>
void forEachPosition(const Scene& scene, const glm::dmat4& to_from_world, Visit&& visit) {
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 to_from_object = to_from_world * glm::dmat4(instance.world_from_object);
    for (const Vertex& vertex : scene.meshes[std::size_t(instance.mesh)].vertices)
      visit(glm::dvec3(to_from_object * glm::dvec4(glm::dvec3(vertex.position), 1.0)));
  }
}

}  // namespace mirrorball
