#include "mirrorball/view/inspect/fresnel_curve.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/rays/surface_shares.h"

namespace mirrorball {
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
