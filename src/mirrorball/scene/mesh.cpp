#include "mirrorball/scene/mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "mirrorball/scene/mesh_file/corner_angle.h"

namespace mirrorball {
namespace {

using glm::dvec3;

struct MeshCorner {
  std::size_t vertex;
  dvec3 position;
  double angle;
};

/// The corners of the triangle that begins at `first` in the indices.
std::array<MeshCorner, 3> cornersOf(const Mesh& mesh, std::size_t first) {
  std::array<MeshCorner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i].vertex = mesh.indices[first + i];
    corners[i].position = mesh.vertices[corners[i].vertex].position;
  }
  for (std::size_t i = 0; i < 3; ++i)
    corners[i].angle = angleAt(corners[i].position, corners[(i + 1) % 3].position, corners[(i + 2) % 3].position);
  return corners;
}

}  // namespace

bool hasTextureCoordinates(const Mesh& mesh) {
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Vertex& vertex) { return vertex.uv[0] != glm::vec2(0.0f); });
}

void computeNormals(Mesh& mesh) {
  std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0.0));
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const std::array<MeshCorner, 3> corners = cornersOf(mesh, first);
    const dvec3 normal = unitOr(
        glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position), dvec3(0.0));
    for (const MeshCorner& corner : corners) sums[corner.vertex] += corner.angle * normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) mesh.vertices[i].normal = glm::vec3(unitOr(sums[i], dvec3(0, 0, 1)));
}

}  // namespace mirrorball
