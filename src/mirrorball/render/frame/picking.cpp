#include "mirrorball/render/frame/picking.h"

#include <cmath>

#include "mirrorball/rays/seen_from.h"
#include "mirrorball/rays/surface_point.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

/// Whether the eye sees a surface there.
bool isSeen(const Scene& scene, const EyeRay& ray, const Hit& hit) {
  const Material& material = materialOf(scene, hit.instance);
  const bool shows_front = glm::dot(ray.direction, hit.geometric_normal) < 0.0f;
  return hit.distance >= ray.nearest && (shows_front || material.double_sided) && opacityAt(scene, hit) > 0.0f;
}

std::optional<Hit> firstSeen(const EyeRay& ray, const Scene& scene, const Geometry& geometry, Surfaces surfaces) {
  constexpr int kMostPassed = 256;
  float nearest = 0.0f;
  for (int passed = 0; passed < kMostPassed; ++passed) {
    const auto hit = geometry.hit(ray.origin, ray.direction, nearest, surfaces);
    if (!hit || isSeen(scene, ray, *hit)) return hit;
    nearest = std::nextafter(hit->distance, INFINITY);
  }
  return std::nullopt;
}

glm::vec2 uvAt(const Mesh& mesh, const Hit& hit) {
  const std::uint32_t* const corner = mesh.indices.data() + std::size_t{3} * hit.triangle;
  const auto uv = [&](int of) { return mesh.vertices[corner[of]].uv[0]; };
  const glm::vec2 b = hit.barycentric;
  return (1.0f - b.x - b.y) * uv(0) + b.x * uv(1) + b.y * uv(2);
}

}  // namespace

Picked pickedAt(const EyeRay& ray, const Hit& hit, const Scene& scene, ReliefKind relief) {
  const Instance& instance = scene.instances[hit.instance];
  const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
  const Material& material = scene.materials[std::size_t(mesh.material)];
  const glm::mat3 world_from_normal = glm::transpose(glm::inverse(glm::mat3(instance.world_from_object)));
  Picked picked{.instance = hit.instance,
                .node = instance.node,
                .material = std::size_t(mesh.material),
                .triangle = hit.triangle,
                .position = hit.relief ? hit.relief->position : ray.origin + hit.distance * ray.direction,
                .uv = uvAt(mesh, hit)};
  const glm::vec2 b = hit.barycentric;
  picked.smooth_normal = placedTriangle(mesh, instance, hit.triangle).normalAt({1.0f - b.x - b.y, b});
  picked.normal = surfacePointAt(scene, world_from_normal, hit, relief).normal;
  const bool is_back = glm::dot(ray.direction, hit.geometric_normal) > 0.0f;
  const glm::vec3 facing = is_back ? -picked.normal : picked.normal;
  picked.reflected = glm::reflect(ray.direction, facing);
  if (material.transmission > 0.0f) {
    const float ior = material.thin_walled ? 1.0f : material.ior;
    const glm::vec3 refracted = glm::refract(ray.direction, facing, is_back ? ior : 1.0f / ior);
    if (glm::dot(refracted, refracted) > 0.0f) picked.refracted = refracted;
  }
  return picked;
}

std::optional<Picked> pickAlong(const EyeRay& ray, const Scene& scene, const Geometry& geometry,
                                const FrameSettings& settings) {
  const Surfaces surfaces = movesSurface(settings.relief) ? Surfaces::reliefs : Surfaces::triangles;
  const std::optional<Hit> hit = firstSeen(ray, scene, geometry, surfaces);
  if (!hit) return std::nullopt;
  return pickedAt(ray, *hit, scene, settings.relief);
}

}  // namespace mirrorball
