#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How many of a mesh's vertices say how large it is: those of reliefs, which are its last, do not.
inline std::size_t framedVertices(const Mesh& mesh) {
  return mesh.first_of_relief > 0 ? mesh.first_of_relief : mesh.vertices.size();
}

/// Calls `visit` with the place of every vertex of an instance but for those of reliefs,
/// in double precision so that huge coordinates do not overflow.
///
/// to_from_world   turns places of the world into those that are visited
template <typename Visit>
void forEachPosition(const Scene& scene, const Instance& instance, const glm::dmat4& to_from_world, Visit&& visit) {
  const glm::dmat4 to_from_object = to_from_world * glm::dmat4(instance.world_from_object);
  const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
  for (const Vertex& vertex : std::span(mesh.vertices).first(framedVertices(mesh)))
    visit(glm::dvec3(to_from_object * glm::dvec4(glm::dvec3(vertex.position), 1.0)));
}

/// Vertices that follow each other in a mesh, none of a relief, and the box around them.
struct PositionRun {
  std::size_t first;
  std::size_t count;
  Box box;  ///< object space
};

/// The vertices of each of a scene's meshes in runs: what looks for the farthest in a direction leaves out those whose
/// boxes end before it.
///
/// cost   a pass over all vertices
std::vector<std::vector<PositionRun>> positionRuns(const Scene& scene);

/// The same of all instances.
template <typename Visit>
void forEachPosition(const Scene& scene, const glm::dmat4& to_from_world, Visit&& visit) {
  for (const Instance& instance : scene.instances) forEachPosition(scene, instance, to_from_world, visit);
}

/// The box around all of them, which boundingBox() rounds.
DoubleBox boxOfPositions(const Scene& scene);

}  // namespace mirrorball
