#include "mirrorball/rays/path_vertex.h"

#include <cstddef>
#include <optional>

#include "formula/surface.h"
#include "formula/tangent.h"
#include "mirrorball/rays/surface_finder.h"
#include "mirrorball/scene/bodies/surrounding_media.h"

namespace mirrorball {
namespace {

/// The point at which a ray leaves a surface, so far beside it as rounding may have put it on the wrong side.
glm::vec3 besideHit(const Ray& arriving, const Hit& hit, bool goes_out) {
  const glm::vec3 towards = goes_out ? hit.geometric_normal : -hit.geometric_normal;
  if (!hit.relief)
    return formula::besideSurface(arriving.origin + hit.distance * arriving.direction, hit.distance, towards);
  // Above and below are told apart by heights.
  constexpr float kHeights = 1e-3f;
  return formula::besideSurface(hit.relief->position, hit.distance, towards) +
         (goes_out ? kHeights : -kHeights) * hit.relief->up;
}

}  // namespace

PathVertex pathVertexAt(const Scene& scene, std::span<const glm::mat3> world_from_normal, const Hit& hit,
                        const Ray& ray, ReliefKind relief) {
  const Material& material = materialOf(scene, hit.instance);
  const bool is_outside = glm::dot(ray.direction, hit.geometric_normal) < 0.0f;
  const int other =
      formula::fillingBody(is_outside ? ray.media : formula::left(ray.media, static_cast<int>(hit.instance)));
  return {hit,
          ray,
          &material,
          surfacePointAt(scene, world_from_normal[hit.instance], hit, relief),
          isBody(material),
          is_outside,
          other >= 0 ? &materialOf(scene, std::size_t(other)) : nullptr};
}

Frame surfaceFrameOf(const PathVertex& vertex) {
  // A thin surface is the same from both sides; a body has an inside.
  const bool is_inside = vertex.is_body && !vertex.is_outside;
  const bool is_from_behind = !vertex.is_body && !vertex.is_outside;
  const float facing = is_inside ? -1.0f : 1.0f;
  const glm::vec3 smooth = is_from_behind ? -vertex.point.normal : vertex.point.normal;
  const glm::vec3 normal = facing * formula::facingNormal(facing * smooth, vertex.arriving.direction);
  glm::vec2 stretched = vertex.point.stretched;
  if (is_from_behind) stretched.y = -stretched.y;  // with the normal that is turned round
  return Frame(normal, formula::turnedTangent(vertex.point.tangent, normal, stretched));
}

float iorBeyond(const PathVertex& vertex, float wavelength) {
  return vertex.beyond ? formula::atWavelength(*vertex.beyond, wavelength).ior : 1.0f;
}

formula::Material materialAgainstBeyond(const PathVertex& vertex, float wavelength) {
  formula::Material material = formula::atWavelength(vertex.point.material, wavelength);
  const float beyond = iorBeyond(vertex, wavelength);
  material.ior /= beyond;
  material.conductor_n /= beyond;
  material.conductor_k /= beyond;
  if (vertex.beyond) material.dispersion = 0.0f;
  return material;
}

Ray leavingRay(const PathVertex& vertex, glm::vec3 direction) {
  const Ray& arriving = vertex.arriving;
  const Hit& hit = vertex.hit;
  const bool goes_out = glm::dot(direction, hit.geometric_normal) >= 0.0f;
  const bool crosses = goes_out != vertex.is_outside;
  Ray ray{.origin = besideHit(arriving, hit, goes_out), .direction = direction, .from = hit, .media = arriving.media};
  const int body = static_cast<int>(hit.instance);
  if (crosses && vertex.is_body)
    ray.media = goes_out ? formula::left(ray.media, body) : formula::entered(ray.media, body, vertex.surface->priority);
  return ray;
}

formula::Media mediaAt(const Scene& scene, const Geometry& geometry, glm::vec3 point, ReliefKind relief) {
  return surroundingMedia(
      scene, point, [&](glm::vec3 origin, glm::vec3 direction, float nearest) -> std::optional<Crossing> {
        const auto hit = geometry.hit(origin, direction, nearest, surfacesOf(relief));
        if (!hit) return std::nullopt;
        return Crossing{hit->distance, hit->instance, glm::dot(direction, hit->geometric_normal) < 0.0f};
      });
}

}  // namespace mirrorball
