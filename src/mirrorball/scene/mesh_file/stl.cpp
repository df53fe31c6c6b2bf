#include "mirrorball/scene/mesh_file/stl.h"

#include <array>
#include <string>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/scene/mesh_file/stl_facets.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"
#include "mirrorball/scene/model_origin.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball {
namespace {

/// Adds a facet of three corners; its area is that of the floats that are stored.
///
/// origin   of the mesh
void addFacet(Mesh& mesh, std::span<const glm::dvec3> in_file, glm::dvec3 origin, glm::vec3 color) {
  std::array<glm::dvec3, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = glm::vec3(in_file[i] - origin);
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(normal);
  if (length == 0.0) return;
  for (const glm::dvec3& corner : corners) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    Vertex& vertex = mesh.vertices.emplace_back();
    vertex.position = glm::vec3(corner);
    vertex.normal = glm::vec3(normal / length);
    vertex.color = glm::vec4(color, 1.0f);
  }
}

Mesh buildMesh(const StlFacets& facets, glm::dvec3 origin) {
  Mesh mesh;
  mesh.vertices.reserve(facets.corners.size());
  mesh.indices.reserve(facets.corners.size());
  for (std::size_t first = 0; first + 2 < facets.corners.size(); first += 3)
    addFacet(mesh, std::span(facets.corners).subspan(first, 3), origin,
             facets.colors.empty() ? glm::vec3(1.0f) : facets.colors[first / 3]);
  return mesh;
}

}  // namespace

Result<void> checkStlMemory(std::uint64_t corners) {
  constexpr std::uint64_t kOfCorner = 180;  // bytes, measured, in lists that grow
  return checkMemory(corners * kOfCorner);
}

Result<Scene> decodeStl(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  const auto text = hasStlSize(bytes) ? std::nullopt : stlText(bytes);
  MIRRORBALL_TRY(facets, text ? readStlText(*text) : readStlBinary(bytes));
  if (std::string repairs = remarkOn(facets.repair); !repairs.empty()) facets.remarks.push_back(std::move(repairs));
  const glm::dvec3 origin = originFor(facets.corners);
  Mesh mesh = buildMesh(facets, origin);
  facets.corners = {};
  if (mesh.indices.empty()) {
    std::string problem = "holds no facet with an area";
    for (const std::string& remark : facets.remarks) problem += "; " + remark;
    return fail(ErrorCode::bad_file, problem);
  }
  computeTangents(mesh);
  Scene scene = meshScene(std::move(mesh), materialOfColors(!facets.colors.empty()));
  for (const std::string& remark : facets.remarks) scene.warnings.push_back(path.string() + ": " + remark);
  setOrigin(scene, origin, !text);
  return scene;
}

}  // namespace mirrorball
