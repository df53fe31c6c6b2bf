#include "mirrorball/scene/animation/rig.h"

#include <cmath>

namespace mirrorball {

glm::dmat4 parentFromNode(const NodePlace& place) {
  glm::dmat4 matrix = glm::mat4_cast(place.rotation);
  for (int axis = 0; axis < 3; ++axis) {
    matrix[axis] *= place.scale[axis];
    matrix[3][axis] = place.translation[axis];
  }
  return place.matrix * matrix;
}

bool isWithinFloats(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      // Within the range of float, with which the renderer goes on.
      if (!(std::abs(matrix[column][row]) < 1e30)) return false;
  return true;
}

std::optional<glm::mat4> rigidPart(const glm::dmat4& world_from_node) {
  const glm::dvec3 back = glm::normalize(glm::dvec3(world_from_node[2]));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(world_from_node[1]), back));
  const glm::dmat4 rigid(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(back, right), 0.0), glm::dvec4(back, 0.0),
                         world_from_node[3]);
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(glm::length(rigid[axis]) - 1.0) < 1e-6)) return std::nullopt;  // NaN too
  return glm::mat4(rigid);
}

std::vector<glm::dmat4> worldFromNodes(const glm::dmat4& world_from_roots, std::span<const RigNode> nodes) {
  std::vector<glm::dmat4> worlds;
  worlds.reserve(nodes.size());
  for (const RigNode& node : nodes) {
    const glm::dmat4& parent = node.parent < 0 ? world_from_roots : worlds[std::size_t(node.parent)];
    worlds.push_back(parent * parentFromNode(node.place));
  }
  return worlds;
}

}  // namespace mirrorball
