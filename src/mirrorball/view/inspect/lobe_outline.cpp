#include "mirrorball/view/inspect/lobe_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "formula/constants.h"
#include "mirrorball/rays/frame.h"

namespace mirrorball {
namespace {

/// A direction of the light, of the direction that it has in the cap.
glm::vec3 lightOfCap(glm::vec2 alpha, glm::vec3 towards, glm::vec3 stretched, glm::vec3 in_cap) {
  const glm::vec3 h = in_cap + stretched;
  const glm::vec3 facet = glm::normalize(glm::vec3(alpha * glm::vec2(h), std::max(h.z, 0.0f)));
  glm::vec3 light = glm::reflect(-towards, facet);
  light.z = std::max(light.z, 0.0f);
  return glm::normalize(light);
}

}  // namespace

// The cap is all c with c.z ≥ −s.z, s being the eye's direction in the stretched frame; its mirror direction is
// m = (−s.x, −s.y, s.z). On the great circle from m along a unit tangent t, cos r m + sin r t, the cap ends where
// s.z (1 + cos r) = −t.z sin r: at tan(r/2) = s.z / −t.z, or if t rises at r = π, where all circles meet on its rim.
// A wedge up to r has the area (1 − cos r) dφ = 2 sin²(r/2) dφ, and so the share ends at
// sin²(r/2) = share · s.z² / (s.z² + min(t.z, 0)²).
std::vector<glm::vec3> lobeOutline(glm::vec2 alpha, glm::vec3 towards, float share, int count) {
  constexpr float kLeastCosine = 1e-4f;
  towards.z = std::max(towards.z, kLeastCosine);
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * glm::vec2(towards), towards.z));
  const Frame around(glm::vec3(-stretched.x, -stretched.y, stretched.z));
  std::vector<glm::vec3> outline;
  outline.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const float angle = formula::kTwoPi * static_cast<float>(i) / static_cast<float>(count);
    const glm::vec3 tangent = std::cos(angle) * around.t + std::sin(angle) * around.b;
    const float falls = std::min(tangent.z, 0.0f);
    const float rises = stretched.z * stretched.z;
    const float half_sine = std::sqrt(share * rises / (rises + falls * falls));
    const float half_cosine = std::sqrt(1.0f - half_sine * half_sine);
    const float cosine = 1.0f - 2.0f * half_sine * half_sine;
    const glm::vec3 in_cap = cosine * around.n + 2.0f * half_sine * half_cosine * tangent;
    outline.push_back(lightOfCap(alpha, towards, stretched, in_cap));
  }
  return outline;
}

}  // namespace mirrorball
