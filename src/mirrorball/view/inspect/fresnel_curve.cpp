#include "mirrorball/view/inspect/fresnel_curve.h"

#include <algorithm>
#include <cmath>

#include "formula/surface.h"

namespace mirrorball {
namespace {

/// The square of the sine beyond the surface (Snell); 1 or more: nothing passes.
float squaredSineBeyond(const formula::Material& material, float cosine, bool is_inside) {
  const float eta = is_inside ? 1.0f / material.ior : material.ior;
  return (1.0f - cosine * cosine) / (eta * eta);
}

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

FresnelCurve fresnelCurve(const formula::Material& material, float cosine, bool is_inside) {
  constexpr int kDegrees = 90;
  FresnelCurve curve;
  for (int angle_deg = 0; angle_deg <= kDegrees; ++angle_deg) {
    const float angle = static_cast<float>(angle_deg);
    curve.samples.push_back({angle, reflectanceAt(material, std::cos(glm::radians(angle)), is_inside)});
  }
  const float angle = glm::degrees(std::acos(std::clamp(cosine, 0.0f, 1.0f)));
  curve.here = {angle, reflectanceAt(material, cosine, is_inside)};
  return curve;
}

}  // namespace mirrorball
