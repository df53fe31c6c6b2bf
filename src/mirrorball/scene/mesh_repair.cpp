#include "mirrorball/scene/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

template <typename Vector>
bool isOfNumbers(const Vector& vector) {
  for (int i = 0; i < Vector::length(); ++i)
    if (!std::isfinite(vector[i])) return false;
  return true;
}

bool hasDirection(const glm::vec3& normal) { return isOfNumbers(normal) && normal != glm::vec3(0.0f); }

/// Keeps the triangles whose corners are somewhere.
void leaveOutTriangles(Mesh& mesh, MeshRepair& repair) {
  const std::size_t whole = mesh.indices.size() - mesh.indices.size() % 3;
  std::size_t kept = 0;
  for (std::size_t first = 0; first < whole; first += 3) {
    const std::span<const std::uint32_t> corners = std::span(mesh.indices).subspan(first, 3);
    const auto isThere = [&](std::uint32_t corner) { return corner < mesh.vertices.size(); };
    const auto isSomewhere = [&](std::uint32_t corner) { return isOfNumbers(mesh.vertices[corner].position); };
    if (!std::all_of(corners.begin(), corners.end(), isThere)) {
      ++repair.triangles_of_no_vertex;
    } else if (!std::all_of(corners.begin(), corners.end(), isSomewhere)) {
      ++repair.triangles_of_no_place;
    } else {
      std::copy(corners.begin(), corners.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
      kept += 3;
    }
  }
  mesh.indices.resize(kept);
}

/// Gives the vertices that are nowhere, which no triangle has any more, the place of one that some triangle has.
void placeVertices(Mesh& mesh) {
  const glm::vec3 place = mesh.indices.empty() ? glm::vec3(0.0f) : mesh.vertices[mesh.indices[0]].position;
  for (Vertex& vertex : mesh.vertices)
    if (!isOfNumbers(vertex.position)) vertex.position = place;
}

std::size_t makeNormals(Mesh& mesh) {
  const auto lacking = std::count_if(mesh.vertices.begin(), mesh.vertices.end(),
                                     [](const Vertex& vertex) { return !hasDirection(vertex.normal); });
  if (lacking == 0) return 0;
  std::vector<glm::vec3> own;
  own.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) own.push_back(vertex.normal);
  computeNormals(mesh);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (hasDirection(own[i])) mesh.vertices[i].normal = own[i];
  return static_cast<std::size_t>(lacking);
}

}  // namespace

MeshRepair& MeshRepair::operator+=(const MeshRepair& other) {
  triangles_of_no_vertex += other.triangles_of_no_vertex;
  triangles_of_no_place += other.triangles_of_no_place;
  faces_fanned += other.faces_fanned;
  normals_made += other.normals_made;
  coordinates_zeroed += other.coordinates_zeroed;
  colors_whitened += other.colors_whitened;
  return *this;
}

MeshRepair repairMesh(Mesh& mesh) {
  MeshRepair repair;
  leaveOutTriangles(mesh, repair);
  placeVertices(mesh);
  repair.normals_made = makeNormals(mesh);
  for (Vertex& vertex : mesh.vertices) {
    if (!isOfNumbers(vertex.uv[0]) || !isOfNumbers(vertex.uv[1])) {
      ++repair.coordinates_zeroed;
      for (glm::vec2& uv : vertex.uv)
        if (!isOfNumbers(uv)) uv = glm::vec2(0.0f);
    }
    if (!isOfNumbers(vertex.color)) {
      ++repair.colors_whitened;
      vertex.color = glm::vec4(1.0f);
    }
  }
  return repair;
}

std::string remarkOn(const MeshRepair& repair) {
  std::vector<std::string> parts;
  const auto tell = [&](std::size_t count, const char* thing, const char* one, const char* many) {
    if (count > 0) parts.push_back(counted(count, thing) + " " + (count == 1 ? one : many));
  };
  tell(repair.triangles_of_no_vertex, "triangle", "names a vertex that is not there and is left out",
       "name vertices that are not there and are left out");
  tell(repair.triangles_of_no_place, "triangle", "reaches NaN or infinity and is left out",
       "reach NaN or infinity and are left out");
  tell(repair.faces_fanned, "face", "has too many corners for its shape, and may be drawn beyond its border",
       "have too many corners for their shapes, and may be drawn beyond their borders");
  tell(repair.normals_made, "normal", "has no direction and is made from the triangles around",
       "have no direction and are made from the triangles around");
  tell(repair.coordinates_zeroed, "texture coordinate", "holds NaN or infinity and is read as 0",
       "hold NaN or infinity and are read as 0");
  tell(repair.colors_whitened, "vertex colour", "holds NaN or infinity and is read as white",
       "hold NaN or infinity and are read as white");
  return join(std::span<const std::string>(parts), "; ");
}

}  // namespace mirrorball
