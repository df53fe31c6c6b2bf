#include "mirrorball/rays/surface_shares.h"

#include <algorithm>
#include <cmath>

#include "formula/bodies.h"
#include "formula/surface.h"
#include "mirrorball/rays/hiding.h"

namespace mirrorball {
namespace {

/// The square of the sine beyond the surface (Snell); 1 or more: nothing passes.
float squaredSineBeyond(const formula::Material& material, float cosine, bool is_inside) {
  const float eta = is_inside ? 1.0f / material.ior : material.ior;
  return (1.0f - cosine * cosine) / (eta * eta);
}

bool isInside(const PathVertex& vertex) { return vertex.is_body && !vertex.is_outside; }

}  // namespace

bool isTotallyReflected(const formula::Material& material, float cosine, bool is_inside) {
  // Between equal indices light passes along the surface, too.
  return material.ior != 1.0f && squaredSineBeyond(material, cosine, is_inside) >= 1.0f;
}

glm::vec3 reflectanceAt(const formula::Material& material, float cosine, bool is_inside) {
  cosine = std::clamp(cosine, 0.0f, 1.0f);
  const glm::vec3 metal = formula::metalReflectance(material, cosine);
  if (is_inside && isTotallyReflected(material, cosine, true))
    return glm::mix(glm::vec3(1.0f), metal, material.metallic);
  const float sine2 = is_inside ? squaredSineBeyond(material, cosine, true) : 1.0f - cosine * cosine;
  const float outside = is_inside ? std::sqrt(std::max(1.0f - sine2, 0.0f)) : cosine;
  return glm::mix(formula::smoothDielectric(material, outside), metal, material.metallic);
}

Frame frameOnRaysSide(const PathVertex& vertex) {
  const Frame frame = surfaceFrameOf(vertex);
  return isInside(vertex) ? Frame(-frame.n, frame.t) : frame;
}

SurfaceView seenSide(const PathVertex& vertex) {
  return {isInside(vertex), std::clamp(-glm::dot(vertex.arriving.direction, frameOnRaysSide(vertex).n), 0.0f, 1.0f)};
}

SurfaceShares sharesAt(const PathVertex& vertex) { return sharesAt(vertex, frameOnRaysSide(vertex).n); }

SurfaceShares sharesAt(const PathVertex& vertex, glm::vec3 n) {
  if (vertex.surface->unlit) return {};
  const formula::Material material = materialAgainstBeyond(vertex, 0.0f);
  const bool is_inside = isInside(vertex);
  const float cosine = std::clamp(-glm::dot(vertex.arriving.direction, n), 0.0f, 1.0f);
  const float transmits = material.transmission * (1.0f - material.metallic);
  // From within, matter scatters its share before the surface is met (trace/bsdf.cpp).
  SurfaceShares shares{.reflected = reflectanceAt(material, cosine, is_inside)};
  if (is_inside) shares.reflected *= glm::mix(material.transmission, 1.0f, material.metallic);
  if (transmits <= 0.0f) return shares;
  const bool bends = !vertex.surface->thin_walled;
  shares.is_total = bends && isTotallyReflected(material, cosine, is_inside);
  if (shares.is_total) return shares;
  formula::Material dielectric = formula::withGreySpecular(material);
  dielectric.metallic = 0.0f;
  shares.refracted = transmits * material.base_color * (1.0f - reflectanceAt(dielectric, cosine, is_inside));
  return shares;
}

glm::vec3 reflectedDirection(const PathVertex& vertex, glm::vec3 n) {
  const glm::vec3 geometric = vertex.hit.geometric_normal;
  return glm::normalize(
      raisedAbove(vertex.is_outside ? geometric : -geometric, glm::reflect(vertex.arriving.direction, n)));
}

glm::vec3 refractedDirection(const PathVertex& vertex, glm::vec3 n) {
  const glm::vec3 ray = vertex.arriving.direction;
  if (vertex.surface->thin_walled) return ray;
  const float ior = materialAgainstBeyond(vertex, 0.0f).ior;
  return glm::normalize(formula::refractedDirection(ray, n, isInside(vertex) ? 1.0f / ior : ior));
}

}  // namespace mirrorball
