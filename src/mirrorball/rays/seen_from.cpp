#include "mirrorball/rays/seen_from.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "formula/bsdf.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/frame.h"
#include "mirrorball/rays/hiding.h"
#include "mirrorball/rays/hiding_bound.h"
#include "mirrorball/rays/vertex_places.h"
#include "mirrorball/scene/unit_vector.h"

namespace mirrorball {
namespace {

constexpr int kRays = 32;

}  // namespace

glm::vec3 PlacedTriangle::at(glm::vec3 weights) const {
  return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

glm::vec3 PlacedTriangle::normalAt(glm::vec3 weights) const {
  const glm::vec3 n = weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2];
  // They are as long as their object is small.
  float longest = 0.0f;
  for (const glm::vec3& normal : normals) longest = std::max(longest, glm::dot(normal, normal));
  return glm::dot(n, n) > 1e-12f * longest ? unitOrNone(n) : geometric_normal;
}

PlacedTriangle PlacedTriangle::turnedOver() const {
  PlacedTriangle turned = *this;
  for (glm::vec3& normal : turned.normals) normal = -normal;
  turned.geometric_normal = -geometric_normal;
  return turned;
}

PlacedTriangle placedTriangle(const Mesh& mesh, const Instance& instance, std::size_t triangle) {
  const glm::mat3 world_from_normal = glm::transpose(glm::inverse(glm::mat3(instance.world_from_object)));
  PlacedTriangle placed{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& vertex = mesh.vertices[mesh.indices[3 * triangle + i]];
    placed.corners[i] = glm::vec3(instance.world_from_object * glm::vec4(vertex.position, 1.0f));
    placed.normals[i] = world_from_normal * vertex.normal;
  }
  for (std::size_t i = 0; i < 3; ++i)
    placed.longest_edge = std::max(placed.longest_edge, glm::distance(placed.corners[i], placed.corners[(i + 1) % 3]));
  const glm::vec3 across = glm::cross(placed.corners[1] - placed.corners[0], placed.corners[2] - placed.corners[0]);
  glm::vec3 normals(0.0f);
  for (const glm::vec3& normal : placed.normals) normals += unitOrNone(normal);
  placed.geometric_normal = facingOutwards(directionOr(across, glm::vec3(0.0f)), normals);
  return placed;
}

SeenScene seenFrom(const Scene& scene, const Geometry& geometry, const PlacedTriangle& placed, glm::vec3 weights) {
  const Frame frame(placed.normalAt(weights));
  const glm::vec3 origin = formula::besideSurface(placed.at(weights), 0.0f, placed.geometric_normal);
  SeenScene seen;
  for (int ray = 0; ray < kRays; ++ray) {
    const glm::vec2 even = formula::evenPoint(glm::vec2(0.0f), static_cast<float>(ray));
    const glm::vec3 direction =
        raisedAbove(placed.geometric_normal, frame.toWorld(formula::sampleDiffuse({even.y, even.x})));
    const auto hit = hidingHit(scene, geometry, origin, direction, mixed(0u, static_cast<std::uint32_t>(ray)));
    if (hit) {
      seen.occluded += direction / float{kRays};
      seen.nearness += 1.0f / (hit->distance * float{kRays});
    } else {
      seen.open += 1.0f / float{kRays};
    }
  }
  return seen;
}

bool showsBacks(const Scene& scene, const Geometry& geometry, const Instance& instance) {
  constexpr std::size_t kAskedTriangles = 16;
  constexpr float kFewest = 1.0f / 64.0f;
  const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
  const Material& material = scene.materials[std::size_t(mesh.material)];
  const std::size_t triangles = mesh.indices.size() / 3;
  if (!material.double_sided || material.transmission > 0.0f || mesh.first_of_relief > 0 ||
      material.height != HeightKind::none || triangles == 0)
    return false;
  const std::size_t asked = std::min(triangles, kAskedTriangles);
  float open = 0.0f;
  for (std::size_t i = 0; i < asked; ++i)
    open += seenFrom(scene, geometry, placedTriangle(mesh, instance, i * triangles / asked).turnedOver(),
                     glm::vec3(1.0f / 3.0f))
                .open;
  return open > kFewest * static_cast<float>(asked);
}

std::vector<std::uint8_t> instancesWithBacks(const Scene& scene, const Geometry& geometry) {
  std::vector<std::uint8_t> shows_back(scene.instances.size());
  parallelFor(shows_back.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) shows_back[i] = showsBacks(scene, geometry, scene.instances[i]) ? 1 : 0;
  });
  return shows_back;
}

Result<bool> hidesItself(const Scene& scene) {
  constexpr std::size_t kAskedTriangles = 1000;
  constexpr float kMostlyOpen = 0.9f;
  MIRRORBALL_TRY(geometry, Geometry::make(scene));
  std::size_t count = 0;
  for (const Instance& instance : scene.instances)
    count += scene.meshes[std::size_t(instance.mesh)]->indices.size() / 3;
  const std::size_t step = std::max<std::size_t>(1, (count + kAskedTriangles - 1) / kAskedTriangles);
  std::size_t next = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    const std::size_t triangles = mesh.indices.size() / 3;
    for (; next < triangles; next += step)
      if (seenFrom(scene, geometry, placedTriangle(mesh, instance, next), glm::vec3(1.0f / 3.0f)).open < kMostlyOpen)
        return true;
    next -= triangles;
  }
  return !hidesLittleSurely(scene, instancesWithBacks(scene, geometry));
}

}  // namespace mirrorball
