#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace mirrorball::flip {

// FLIP's colour spaces, with the digits of the published program, on which its values depend. (formula/color.glsl
// rounds the same primaries otherwise.)

inline constexpr glm::vec3 kWhite{0.950428545f, 1.0f, 1.088900371f};  ///< D65 as XYZ

inline glm::vec3 xyzFromRec709(glm::vec3 c) {
  return {(10135552.0f / 24577794.0f) * c.x + (8788810.0f / 24577794.0f) * c.y + (4435075.0f / 24577794.0f) * c.z,
          (2613072.0f / 12288897.0f) * c.x + (8788810.0f / 12288897.0f) * c.y + (887015.0f / 12288897.0f) * c.z,
          (1425312.0f / 73733382.0f) * c.x + (8788810.0f / 73733382.0f) * c.y + (70074185.0f / 73733382.0f) * c.z};
}

inline glm::vec3 rec709FromXyz(glm::vec3 c) {
  return {3.241003275f * c.x - 1.537398934f * c.y - 0.498615861f * c.z,
          -0.969224334f * c.x + 1.875930071f * c.y + 0.041554224f * c.z,
          0.055639423f * c.x - 0.204011202f * c.y + 1.057148933f * c.z};
}

/// The linear form of L*a*b* in which contrast is filtered: achromatic, red against green, blue against yellow.
inline glm::vec3 opponentFromRec709(glm::vec3 light) {
  const glm::vec3 c = xyzFromRec709(light) / kWhite;
  return {116.0f * c.y - 16.0f, 500.0f * (c.x - c.y), 200.0f * (c.y - c.z)};
}

inline glm::vec3 rec709FromOpponent(glm::vec3 c) {
  const float y = (c.x + 16.0f) / 116.0f;
  return rec709FromXyz(glm::vec3(y + c.y / 500.0f, y, y - c.z / 200.0f) * kWhite);
}

/// The lightness curve of CIE L*a*b*.
inline float labCurve(float t) {
  constexpr float kDelta = 6.0f / 29.0f;
  return t > kDelta * kDelta * kDelta ? std::pow(t, 1.0f / 3.0f) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

/// CIE L*a*b* whose colours count for less the darker they are (the Hunt effect).
inline glm::vec3 huntLab(glm::vec3 light) {
  const glm::vec3 c = xyzFromRec709(light) / kWhite;
  const glm::vec3 f(labCurve(c.x), labCurve(c.y), labCurve(c.z));
  const float lightness = 116.0f * f.y - 16.0f;
  const float hunt = 0.01f * lightness;
  return {lightness, hunt * (500.0f * (f.x - f.y)), hunt * (200.0f * (f.y - f.z))};
}

/// HyAB: the distance for large differences of colour.
inline float distance(glm::vec3 a, glm::vec3 b) {
  return std::abs(a.x - b.x) + glm::length(glm::vec2(a.y - b.y, a.z - b.z));
}

/// Light as the display of HDR-FLIP shows it: Narkowicz's fit of ACES (2016) without its exposure of 0.6, in [0, 1].
/// Light below 0 is none.
inline glm::vec3 toneMapped(glm::vec3 light) {
  // The curve does not tell 10⁹ from more, whose square may be no float.
  const glm::vec3 c = glm::clamp(light, 0.0f, 1e9f);
  return glm::clamp((c * c * (0.6f * 0.6f * 2.51f) + c * (0.6f * 0.03f)) /
                        (c * c * (0.6f * 0.6f * 2.43f) + c * (0.6f * 0.59f) + 0.14f),
                    0.0f, 1.0f);
}

/// The light that this curve brings to `shown`, which lies above 0 and below 1.
inline float lightShownAs(float shown) {
  const float a = 0.6f * 0.6f * 2.51f - shown * (0.6f * 0.6f * 2.43f);
  const float b = 0.6f * 0.03f - shown * (0.6f * 0.59f);
  const float c = -shown * 0.14f;
  const float half = -0.5f * (b / a);
  return half + std::sqrt(half * half - c / a);
}

}  // namespace mirrorball::flip
