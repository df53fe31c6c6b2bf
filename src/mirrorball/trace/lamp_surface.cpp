#include "mirrorball/trace/lamp_surface.h"

#include <algorithm>
#include <cmath>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/bake/brdf/sheen_albedo.h"

namespace mirrorball {

LampSurface::LampSurface(const formula::Material& material, const Frame& frame, glm::vec3 coat_normal, glm::vec3 ray)
    : ray_(ray) {
  const auto cosineTo = [&](glm::vec3 normal) { return std::clamp(-glm::dot(ray, normal), 0.0f, 1.0f); };
  const auto environmentBrdf = [&](float perceptual_roughness, glm::vec3 normal) -> glm::vec3 {
    const DirectionalAlbedo albedo = directionalAlbedo(Distribution::ggx, perceptual_roughness, cosineTo(normal));
    return {1.0f - albedo.total(), albedo.grazing(), albedo.meanTilt()};
  };
  surface_.material = material;
  surface_.normal = frame.n;
  surface_.tangent = frame.t;
  surface_.environment_brdf = environmentBrdf(material.perceptual_roughness, frame.n);
  if (material.anisotropy > 0.0f) {
    const glm::vec2 alpha = formula::stretchedAlpha(material.perceptual_roughness, material.anisotropy);
    const glm::vec3 of_mean_width = environmentBrdf(std::sqrt(0.5f * (alpha.x + alpha.y)), frame.n);
    surface_.environment_brdf = {surface_.environment_brdf.x, of_mean_width.y, of_mean_width.z};
    surface_.stretched_share = formula::stretchedShare(alpha, frame.toLocal(-ray));
  }
  const bool has_sheen = material.sheen_color != glm::vec3(0.0f);
  surface_.sheen_albedo = has_sheen ? sheenAlbedo(material.sheen_roughness, cosineTo(frame.n)) : 0.0f;
  surface_ = formula::seenAlong(surface_, ray);
  if (material.clearcoat <= 0.0f) return;
  const Frame coat_frame(coat_normal);
  coat_ = formula::coatOf(surface_, ray, coat_frame.n, coat_frame.t,
                          environmentBrdf(material.clearcoat_roughness, coat_frame.n));
}

glm::vec3 LampSurface::shownOf(const formula::Lamp& lamp, glm::vec3 place, float factor) const {
  const glm::vec3 below = factor * formula::shadedByLamp(surface_, ray_, place, lamp);
  const float clearcoat = surface_.material.clearcoat;
  if (clearcoat <= 0.0f) return below;
  return formula::underCoat(coat_, clearcoat, below, factor * formula::shadedByLamp(coat_, ray_, place, lamp));
}

}  // namespace mirrorball
