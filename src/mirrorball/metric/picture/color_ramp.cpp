#include "mirrorball/metric/picture/color_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/common.hpp>

#include "formula/color.h"

namespace mirrorball {
namespace {

constexpr int kSteps = 256;
using Ramp = std::array<glm::vec3, kSteps>;

/// Linear Rec.709 of a colour in Oklab's polar form (Björn Ottosson, "A perceptual color space for image processing",
/// 2020).
glm::vec3 linearFromOklch(float lightness, float chroma, float hue_deg) {
  const float hue = hue_deg * std::numbers::pi_v<float> / 180.0f;
  const float a = chroma * std::cos(hue);
  const float b = chroma * std::sin(hue);
  const float l = lightness + 0.3963377774f * a + 0.2158037573f * b;
  const float m = lightness - 0.1055613458f * a - 0.0638541728f * b;
  const float s = lightness - 0.0894841775f * a - 1.2914855480f * b;
  const glm::vec3 cones(l * l * l, m * m * m, s * s * s);
  return {4.0767416621f * cones.x - 3.3077115913f * cones.y + 0.2309699292f * cones.z,
          -1.2684380046f * cones.x + 2.6097574011f * cones.y - 0.3413193965f * cones.z,
          -0.0041960863f * cones.x - 0.7034186147f * cones.y + 1.7076147010f * cones.z};
}

/// A colour that a display has, encoded.
glm::vec3 displayColor(float lightness, float chroma, float hue_deg) {
  return formula::srgbFromLinear(glm::clamp(linearFromOklch(lightness, chroma, hue_deg), 0.0f, 1.0f));
}

Ramp makeRamp(glm::vec3 (*color)(float)) {
  Ramp ramp;
  for (int step = 0; step < kSteps; ++step)
    ramp[std::size_t(step)] = color(static_cast<float>(step) / static_cast<float>(kSteps - 1));
  return ramp;
}

/// The colour of a number in [0, 1], NaN's that of 0.
glm::vec3 colorAt(const Ramp& ramp, float t) {
  if (!(t > 0.0f)) return ramp.front();
  return ramp[static_cast<std::size_t>(std::min(t, 1.0f) * static_cast<float>(kSteps - 1) + 0.5f)];
}

// Chromas stay within what a display has of each lightness and hue: where one is cut off, a ramp gets an edge.
constexpr float kLightest = 0.97f;

glm::vec3 sequential(float t) {
  constexpr float kDarkest = 0.12f;
  const float chroma = 0.06f + 0.11f * std::sin(std::numbers::pi_v<float> * t) + 0.035f * t;
  // From violet (290°) over red (25°) to yellow (105°).
  return displayColor(kDarkest + (kLightest - kDarkest) * t, chroma, 290.0f + 175.0f * t);
}

/// One arm of the diverging ramp.
glm::vec3 arm(float t, float hue_deg) {
  constexpr float kDarkest = 0.45f;
  return displayColor(kLightest + (kDarkest - kLightest) * t, 0.18f * t, hue_deg);
}

}  // namespace

glm::vec3 sequentialColor(float t) {
  static const Ramp ramp = makeRamp(sequential);
  return colorAt(ramp, t);
}

glm::vec3 divergingColor(float t) {
  static const Ramp above = makeRamp([](float distance) { return arm(distance, 27.0f); });
  static const Ramp below = makeRamp([](float distance) { return arm(distance, 262.0f); });
  return t < 0.0f ? colorAt(below, -t) : colorAt(above, t);
}

}  // namespace mirrorball
