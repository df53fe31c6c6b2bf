#pragma once

#include <cstddef>
#include <span>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Calls `visit` with the place of every vertex of an instance but for those of reliefs,
/// in double precision so that huge coordinates do not overflow.
///
/// to_from_world   turns places of the world into those that are visited
template <typename Visit>
void forEachPosition(const Scene& scene, const Instance& instance, const glm::dmat4& to_from_world, Visit&& visit) {
  const glm::dmat4 to_from_object = to_from_world * glm::dmat4(instance.world_from_object);
  const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
  const std::size_t count = mesh.first_of_relief > 0 ? mesh.first_of_relief : mesh.vertices.size();
  for (const Vertex& vertex : std::span(mesh.vertices).first(count))
    visit(glm::dvec3(to_from_object * glm::dvec4(glm::dvec3(vertex.position), 1.0)));
}

/// The same of all instances.
template <typename Visit>
void forEachPosition(const Scene& scene, const glm::dmat4& to_from_world, Visit&& visit) {
  for (const Instance& instance : scene.instances) forEachPosition(scene, instance, to_from_world, visit);
}

}  // namespace mirrorball
