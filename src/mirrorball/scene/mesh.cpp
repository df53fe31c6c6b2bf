#include "mirrorball/scene/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "mirrorball/scene/mesh_file/corner_angle.h"

namespace mirrorball {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Some unit vector orthogonal to the unit vector `normal`.
dvec3 anyOrthogonal(dvec3 normal) {
  const dvec3 away = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(away, normal));
}

struct Corner {
  std::size_t vertex;
  dvec3 position;
  double angle;
};

/// The corners of the triangle that begins at `first` in the indices.
std::array<Corner, 3> cornersOf(const Mesh& mesh, std::size_t first) {
  std::array<Corner, 3> corners;
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
  return std::ranges::any_of(mesh.vertices, [](const Vertex& vertex) { return vertex.uv[0] != glm::vec2(0.0f); });
}

void computeNormals(Mesh& mesh) {
  std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0.0));
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const std::array<Corner, 3> corners = cornersOf(mesh, first);
    const dvec3 normal = unitOr(
        glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position), dvec3(0.0));
    for (const Corner& corner : corners) sums[corner.vertex] += corner.angle * normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) mesh.vertices[i].normal = glm::vec3(unitOr(sums[i], dvec3(0, 0, 1)));
}

void computeTangents(Mesh& mesh, int set) {
  std::vector<dvec3> sums(mesh.vertices.size(), dvec3(0.0));
  std::vector<double> handedness(mesh.vertices.size(), 0.0);
  for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const std::array<Corner, 3> corners = cornersOf(mesh, first);
    const auto uv = [&](std::size_t i) { return dvec2(mesh.vertices[corners[i].vertex].uv[set]); };
    const dvec3 edge1 = corners[1].position - corners[0].position;
    const dvec3 edge2 = corners[2].position - corners[0].position;
    const dvec2 step1 = uv(1) - uv(0);
    const dvec2 step2 = uv(2) - uv(0);

    // Solves edge = p_u · step.x + p_v · step.y for p_u; only its direction is kept (Lengyel 2001).
    const double determinant = step1.x * step2.y - step2.x * step1.y;
    if (determinant == 0.0) continue;
    const double side = determinant > 0.0 ? 1.0 : -1.0;
    const dvec3 growing_u = side * (edge1 * step2.y - edge2 * step1.y);

    for (const Corner& corner : corners) {
      const dvec3 normal = mesh.vertices[corner.vertex].normal;
      const dvec3 in_plane = growing_u - normal * glm::dot(normal, growing_u);
      sums[corner.vertex] += corner.angle * unitOr(in_plane, dvec3(0.0));
      // v grows downwards in a texture, so a picture that reads normally from outside has a negative determinant,
      // and its upwards direction is n × p_u.
      handedness[corner.vertex] -= corner.angle * side;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const dvec3 normal = mesh.vertices[i].normal;
    const dvec3 in_plane = sums[i] - normal * glm::dot(normal, sums[i]);
    const dvec3 tangent = unitOr(in_plane, anyOrthogonal(normal));
    mesh.vertices[i].tangent = glm::vec4(glm::vec3(tangent), handedness[i] < 0.0 ? -1.0f : 1.0f);
  }
}

}  // namespace mirrorball
