#include "formula/color.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mirrorball::formula {
namespace {

TEST(Color, SrgbHasItsKnownValues) {
  // IEC 61966-2-1: middle grey of 0.5 is 0.2140 in light; the straight piece ends at 0.04045.
  EXPECT_NEAR(linearFromSrgb1(0.5f), 0.21404f, 1e-5f);
  EXPECT_NEAR(linearFromSrgb1(0.04045f), 0.04045f / 12.92f, 1e-6f);
  for (float light = 0.0f; light <= 1.0f; light += 1.0f / 64.0f)
    EXPECT_NEAR(linearFromSrgb1(srgbFromLinear1(light)), light, 1e-5f);
}

TEST(Color, WhiteOfXyzIsWhite) {
  // D65: X = 0.95046, Y = 1, Z = 1.08906.
  const vec3 white = rec709FromXyz(vec3(0.95046f, 1.0f, 1.08906f));
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(white[channel], 1.0f, 1e-3f);
  EXPECT_NEAR(luminance(vec3(1.0f)), 1.0f, 1e-6f);
}

// Chosen wavelengths count as 1 in the mean, or what glass does not disperse would be tinted.
TEST(Color, AllWavelengthsTogetherAreWhite) {
  vec3 sum(0.0f);
  constexpr int kSteps = 4096;
  for (int i = 0; i < kSteps; ++i) {
    const float wavelength = sampleWavelength((float(i) + 0.5f) / kSteps);
    sum += shareOfWavelength(wavelength) / float(kSteps);
  }
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(sum[channel], 1.0f, 1e-4f) << channel;
}

TEST(Color, WavelengthsHaveTheirColors) {
  const auto strongest = [](vec3 weight) {
    return weight.x > weight.y ? (weight.x > weight.z ? 0 : 2) : (weight.y > weight.z ? 1 : 2);
  };
  EXPECT_EQ(strongest(wavelengthWeight(0.63f)), 0);
  EXPECT_EQ(strongest(wavelengthWeight(0.53f)), 1);
  EXPECT_EQ(strongest(wavelengthWeight(0.45f)), 2);
  EXPECT_LT(wavelengthWeight(0.5f).x, 0.0f) << "cyan is outside of Rec.709";
  // CIE 1931: ȳ is 1 at 555 nm, and z̄ 1.7721 at 450 nm; the fit is within 2 %.
  EXPECT_NEAR(xyzOfWavelength(0.555f).y, 1.0f, 0.02f);
  EXPECT_NEAR(xyzOfWavelength(0.45f).z, 1.7721f, 0.035f);
}

TEST(Color, EveryToneMapRisesFromBlackToWhite) {
  for (int curve = 0; curve < 5; ++curve) {
    EXPECT_NEAR(toneMap(curve, vec3(0.0f)).x, 0.0f, 2e-3f) << curve;
    float before = -1.0f;
    for (float stop = -8.0f; stop < 8.0f; stop += 0.125f) {
      const vec3 shown = toneMap(curve, vec3(std::exp2(stop)));
      EXPECT_GE(shown.x, before - 1e-4f) << curve << " at 2^" << stop;
      EXPECT_LE(shown.x, 1.0f);
      EXPECT_NEAR(shown.x, shown.y, 0.01f) << "grey stays grey";
      EXPECT_NEAR(shown.x, shown.z, 0.01f) << "grey stays grey";
      before = shown.x;
    }
    EXPECT_GT(before, 0.98f) << curve;
  }
}

TEST(Color, ToneMapsHaveTheirKnownValues) {
  EXPECT_NEAR(toneMapReinhard(vec3(1.0f)).x, 0.5f, 1e-6f);
  // Khronos' own example: a colour without a channel below 0.08 moves down by 0.04.
  EXPECT_NEAR(toneMapNeutral(vec3(0.5f, 0.3f, 0.2f)).x, 0.46f, 1e-6f);
  EXPECT_NEAR(toneMapNeutral(vec3(0.5f, 0.3f, 0.2f)).z, 0.16f, 1e-6f);
  // AgX keeps middle grey near itself: the fitted sigmoid brings 0.18 to 0.21.
  EXPECT_NEAR(toneMapAgx(vec3(0.18f)).y, 0.20f, 0.02f);
  // ACES' reference transform brings 0.18 to about 0.10 of the display.
  EXPECT_NEAR(toneMapAces(vec3(0.18f)).y, 0.10f, 0.015f);
}

// An edge that half covers a white wall with a lamp 64 times as bright: on a display they are one white.
TEST(Color, HalfOfALampIsHalfOfItsLight) {
  const vec4 half = displayLight(vec4(32.0f, 32.0f, 32.0f, 0.5f), 1.0f, 4);
  EXPECT_EQ(half, vec4(0.5f));
  EXPECT_EQ(laidOver(half, vec4(1.0f)), vec4(1.0f));
  EXPECT_EQ(laidOver(half, vec4(0.0f)), half);
  EXPECT_NEAR(encodedPicture(laidOver(half, vec4(0.0f, 0.0f, 0.0f, 1.0f))).x, srgbFromLinear1(0.5f), 1e-6f);
}

TEST(Color, DisplayedUndoesThePremultiplication) {
  const vec4 half = displayed(vec4(0.25f, 0.25f, 0.25f, 0.5f), 1.0f, 4);
  EXPECT_NEAR(half.x, srgbFromLinear1(0.5f), 1e-6f);
  EXPECT_EQ(half.w, 0.5f);
  EXPECT_EQ(displayed(vec4(0.0f), 1.0f, 4), vec4(0.0f));
}

}  // namespace
}  // namespace mirrorball::formula
