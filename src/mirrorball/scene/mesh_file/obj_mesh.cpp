#include "mirrorball/scene/mesh_file/obj_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mirrorball/scene/mesh_file/polygon.h"
#include "mirrorball/scene/mesh_file/smoothing.h"
#include "mirrorball/scene/mesh_repair.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball {
namespace {

struct CornerHash {
  std::size_t operator()(const ObjCorner& corner) const {
    std::size_t hash = 0;
    for (const int index : {corner.position, corner.uv, corner.normal})
      hash = (hash ^ static_cast<std::size_t>(index)) * 0x9E3779B97F4A7C15u;  // Fibonacci hashing (Knuth, TAOCP 6.4)
    return hash ^ (hash >> 32);
  }
};

/// A direction, or nothing where it is NaN, infinite or of length 0: then the corner's normal is to be made.
bool hasDirection(glm::vec3 normal) {
  const double length = glm::length(glm::dvec3(normal));
  return length > 0.0 && std::isfinite(length);
}

/// Gives normals to corners that have none.
void addMissingNormals(ObjGeometry& geometry, std::span<const glm::vec3> places) {
  const auto lacks = [&](const ObjCorner& corner) {
    return corner.normal < 0 || !hasDirection(geometry.normals[std::size_t(corner.normal)]);
  };
  const auto someLack = [&](const ObjFace& face) {
    const auto corners = std::span(geometry.corners).subspan(face.first_corner, face.corner_count);
    return std::any_of(corners.begin(), corners.end(), lacks);
  };
  if (std::none_of(geometry.faces.begin(), geometry.faces.end(), someLack)) return;
  std::vector<std::uint32_t> positions;
  std::vector<PolygonFace> faces;
  positions.reserve(geometry.corners.size());
  for (const ObjCorner& corner : geometry.corners) positions.push_back(static_cast<std::uint32_t>(corner.position));
  for (const ObjFace& face : geometry.faces)
    faces.push_back({std::span(positions).subspan(face.first_corner, face.corner_count), face.smoothing});
  const CornerNormals made = cornerNormals(places, faces);

  const std::size_t first_made = geometry.normals.size();
  std::vector<bool> replaced(first_made);
  auto normal = made.of_corner.begin();
  for (const ObjFace& face : geometry.faces)
    for (std::size_t i = 0; i < face.corner_count; ++i, ++normal)
      if (ObjCorner& corner = geometry.corners[face.first_corner + i]; lacks(corner)) {
        if (corner.normal >= 0 && !replaced[std::size_t(corner.normal)]) {
          replaced[std::size_t(corner.normal)] = true;
          ++geometry.repair.normals_made;
        }
        corner.normal = static_cast<int>(first_made + *normal);
      }
  geometry.normals.insert(geometry.normals.end(), made.normals.begin(), made.normals.end());
}

/// Takes faces into meshes.
class ObjMeshBuilder {
 public:
  ObjMeshBuilder(const ObjGeometry& geometry, std::span<const glm::vec3> places)
      : geometry_(geometry), places_(places) {}

  void add(const ObjFace& face, int key) {
    Part& part = parts_[key];
    polygon_.clear();
    const auto corners = std::span(geometry_.corners).subspan(face.first_corner, face.corner_count);
    for (const ObjCorner& corner : corners) polygon_.push_back(places_[std::size_t(corner.position)]);
    TriangulationWork work;
    for (const auto& triangle : triangulate(polygon_, &work))
      for (const std::uint32_t corner : triangle) part.mesh.indices.push_back(takeVertex(corners[corner], part));
    faces_fanned_ += work.gave_up ? 1 : 0;
  }

  std::map<int, Mesh> finish(MeshRepair& repair) {
    std::map<int, Mesh> meshes;
    repair.faces_fanned += faces_fanned_;
    for (auto& [key, part] : parts_) {
      repair += repairMesh(part.mesh);
      if (part.mesh.indices.empty()) continue;
      computeTangents(part.mesh);
      meshes[key] = std::move(part.mesh);
    }
    return meshes;
  }

 private:
  struct Part {
    Mesh mesh;
    std::unordered_map<ObjCorner, std::uint32_t, CornerHash> vertices;
  };

  std::uint32_t takeVertex(const ObjCorner& corner, Part& part) {
    const auto [found, is_new] = part.vertices.emplace(corner, static_cast<std::uint32_t>(part.mesh.vertices.size()));
    if (!is_new) return found->second;
    const auto position = std::size_t(corner.position);
    Vertex& vertex = part.mesh.vertices.emplace_back();
    vertex.position = places_[position];
    if (corner.uv >= 0) vertex.uv[0] = vertex.uv[1] = geometry_.uvs[std::size_t(corner.uv)];
    vertex.normal = glm::vec3(glm::normalize(glm::dvec3(geometry_.normals[std::size_t(corner.normal)])));
    if (!geometry_.colors.empty()) vertex.color = glm::vec4(geometry_.colors[position], 1.0f);
    return found->second;
  }

  const ObjGeometry& geometry_;
  std::span<const glm::vec3> places_;
  std::map<int, Part> parts_;
  std::vector<glm::vec3> polygon_;
  std::size_t faces_fanned_ = 0;
};

}  // namespace

std::map<int, Mesh> buildObjMeshes(ObjGeometry& geometry, std::span<const int> materials, glm::dvec3 origin) {
  std::vector<glm::vec3> places;
  places.reserve(geometry.positions.size());
  for (const glm::dvec3& position : geometry.positions) places.emplace_back(position - origin);
  addMissingNormals(geometry, places);
  ObjMeshBuilder builder(geometry, places);
  for (const ObjFace& face : geometry.faces)
    builder.add(face, face.material >= 0 ? materials[std::size_t(face.material)] : -1);
  return builder.finish(geometry.repair);
}

}  // namespace mirrorball
