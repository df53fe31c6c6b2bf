#include "mirrorball/transfer/mapped_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "formula/tangent.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/equal_vertices.h"
#include "mirrorball/scene/mesh_file/corner_angle.h"

namespace mirrorball {
namespace {

/// The mean normal at each vertex of all triangles that touch its place, weighted by angle.
std::vector<glm::vec3> meanNormals(const Mesh& mesh) {
  const std::vector<std::uint32_t> firsts = firstAtPlace(mesh.vertices);
  Mesh welded = mesh;
  for (std::uint32_t& index : welded.indices) index = firsts[index];
  computeNormals(welded);
  std::vector<glm::vec3> normals;
  normals.reserve(firsts.size());
  for (const std::uint32_t first : firsts) normals.push_back(welded.vertices[first].normal);
  return normals;
}

/// In double precision, so that neither a tiny nor a huge sum has another length than 1.
glm::vec3 unitOrElse(glm::dvec3 v, glm::vec3 otherwise) {
  const bool is_finite = !glm::any(glm::isinf(v)) && !glm::any(glm::isnan(v));
  return is_finite ? glm::vec3(unitOr(v, glm::dvec3(otherwise))) : otherwise;
}

/// Of an interpolated tangent and a unit normal. The tangent may have any length and lie nearly along the normal, where
/// a difference would keep but rounding; two cross products are at a right angle to it all the same.
MapFrame frameOf(glm::vec4 tangent, glm::vec3 normal) {
  MapFrame frame;
  frame.normal = normal;
  const glm::dvec3 up(normal);
  frame.tangent = unitOrElse(glm::cross(glm::cross(up, glm::dvec3(tangent)), up), formula::anyTangent(normal));
  frame.bitangent = glm::cross(normal, frame.tangent) * (tangent.w < 0.0f ? -1.0f : 1.0f);
  return frame;
}

}  // namespace

Result<MappedSurface> MappedSurface::make(const Scene& scene, Outwards outwards) {
  MappedSurface surface(scene);
  bool has_coordinates = false;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = surface.meshOf(i);
    has_coordinates = has_coordinates || hasTextureCoordinates(mesh);
    for (std::uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) surface.triangles_.push_back({i, first});
  }
  if (surface.triangles_.empty()) return fail(ErrorCode::bad_shape, "has no triangles for a map to lie on");
  if (!has_coordinates)
    return fail(ErrorCode::bad_shape,
                "has no texture coordinates, so no map can lie on it; unwrap it in the program that it is from");
  surface.world_from_normal_ = normalMatrices(scene);
  if (outwards == Outwards::mean_normal)
    std::transform(scene.meshes.begin(), scene.meshes.end(), std::back_inserter(surface.mean_normals_), meanNormals);
  return surface;
}

const Mesh& MappedSurface::meshOf(std::uint32_t instance) const {
  return scene_->meshes[std::size_t(scene_->instances[instance].mesh)];
}

std::vector<UvTriangle> MappedSurface::uvTriangles() const {
  std::vector<UvTriangle> uvs;
  uvs.reserve(triangles_.size());
  for (const Triangle& triangle : triangles_) {
    const Mesh& mesh = meshOf(triangle.instance);
    UvTriangle& uv = uvs.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) uv[k] = mesh.vertices[mesh.indices[triangle.first_index + k]].uv[0];
  }
  return uvs;
}

MappedPlace MappedSurface::at(const CoverSample& sample) const {
  const Triangle& triangle = triangles_[sample.triangle];
  const Instance& instance = scene_->instances[triangle.instance];
  const Mesh& mesh = meshOf(triangle.instance);
  const std::uint32_t* const corner = mesh.indices.data() + triangle.first_index;
  const glm::vec2 b = sample.barycentric;
  const auto mixed = [&](const auto& value) {
    return (1.0f - b.x - b.y) * value(corner[0]) + b.x * value(corner[1]) + b.y * value(corner[2]);
  };
  const glm::vec3 position = mixed([&](std::uint32_t i) { return mesh.vertices[i].position; });
  const glm::vec3 normal = mixed([&](std::uint32_t i) { return mesh.vertices[i].normal; });
  const glm::vec3 tangent = mixed([&](std::uint32_t i) { return glm::vec3(mesh.vertices[i].tangent); });

  MappedPlace place;
  place.instance = triangle.instance;
  place.position = glm::vec3(instance.world_from_object * glm::vec4(position, 1.0f));
  const glm::vec3 up = worldNormal(triangle.instance, normal);
  place.frame =
      frameOf(glm::vec4(glm::mat3(instance.world_from_object) * tangent, mesh.vertices[corner[0]].tangent.w), up);
  place.outwards = up;
  if (!mean_normals_.empty()) {
    const std::vector<glm::vec3>& means = mean_normals_[std::size_t(instance.mesh)];
    place.outwards = worldNormal(triangle.instance, mixed([&](std::uint32_t i) { return means[i]; }));
  }
  return place;
}

glm::vec3 MappedSurface::objectNormal(std::uint32_t instance, glm::vec3 world) const {
  // The inverse of the inverse's transpose.
  const glm::dmat3 world_from_object(scene_->instances[instance].world_from_object);
  return unitOrElse(glm::transpose(world_from_object) * glm::dvec3(world), world);
}

glm::vec3 MappedSurface::worldNormal(std::uint32_t instance, glm::vec3 object) const {
  return unitOrElse(glm::dmat3(world_from_normal_[instance]) * glm::dvec3(object), glm::vec3(0.0f, 0.0f, 1.0f));
}

}  // namespace mirrorball
