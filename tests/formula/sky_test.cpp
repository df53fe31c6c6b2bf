#include "formula/sky.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/color.h"

namespace mirrorball::formula {
namespace {

// Bodhaine, Wood, Dutton & Slusser 1999, "On Rayleigh optical depth calculations", table 3 (sea level, 45° N).
TEST(Sky, MoleculesHaveTheirKnownDepth) {
  EXPECT_NEAR(moleculeDepth(0.40f), 0.3596f, 0.01f);
  EXPECT_NEAR(moleculeDepth(0.55f), 0.0972f, 0.001f);
  EXPECT_NEAR(moleculeDepth(0.70f), 0.0365f, 0.0005f);
}

TEST(Sky, OzoneIsATentOfOneColumn) {
  double sum = 0.0;
  for (float height = 0.05f; height < kTopOfAir; height += 0.1f) sum += double(ozoneDensity(height)) * 0.1;
  EXPECT_NEAR(sum, 1.0, 1e-3);
  EXPECT_NEAR(ozoneColumn(0.0f, 1.0f), 1.0f, 1e-5f);
  EXPECT_EQ(ozoneColumn(45.0f, 1.0f), 0.0f);
  EXPECT_NEAR(ozoneColumn(0.0f, 0.0f), 11.3f, 0.3f) << "R / √((R + 25)² − R²)";
}

TEST(Sky, PhaseFunctionsSendOnWhatComes) {
  double molecules = 0.0;
  double haze = 0.0;
  double forwards = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = (2.0 * i + 1.0) / kSteps - 1.0;
    const double solid_angle = 4.0 * double(kPi) / kSteps;
    molecules += double(moleculePhase(static_cast<float>(cosine))) * solid_angle;
    haze += double(hazePhase(static_cast<float>(cosine))) * solid_angle;
    forwards += double(hazePhase(static_cast<float>(cosine))) * solid_angle * cosine;
  }
  EXPECT_NEAR(molecules, 1.0, 1e-4);
  EXPECT_NEAR(haze, 1.0, 1e-4);
  EXPECT_NEAR(forwards, double(kHazeAsymmetry), 1e-3);
}

TEST(Sky, RaysMeetTheGroundAndLeaveTheAir) {
  for (const float cosine : {-1.0f, -0.5f, -0.1f, 0.0f, 0.3f, 1.0f}) {
    const float to_top = distanceToTop(20.0f, cosine);
    EXPECT_NEAR(heightAlong(20.0f, cosine, to_top), kTopOfAir, 0.01f) << cosine;
    const float to_ground = distanceToGround(20.0f, cosine);
    if (cosine < -0.09f) {
      EXPECT_NEAR(heightAlong(20.0f, cosine, to_ground), 0.0f, 0.01f) << cosine;
    } else {
      EXPECT_EQ(to_ground, -1.0f) << cosine;
    }
  }
  EXPECT_EQ(distanceToGround(20.0f, -0.05f), -1.0f) << "passes over the horizon";
}

/// The air along a ray by steps, as a multiple of what is above its beginning.
double airAlong(float height, float cosine, float scale) {
  const double from = double(kEarthRadius) + double(height);
  double sum = 0.0;
  const double step = 0.02 * double(scale);
  for (double t = 0.5 * step; t < 3000.0; t += step) {
    const double here = std::sqrt(from * from + t * t + 2.0 * from * t * double(cosine));
    sum += std::exp(-(here - from) / double(scale)) * step;
  }
  return sum / double(scale);
}

TEST(Sky, AirMassIsTheAirAlongARay) {
  for (const float scale : {kMoleculeScale, kHazeScale})
    for (const float cosine : {1.0f, 0.5f, 0.2f, 0.1f, 0.05f, 0.02f, 0.0f, -0.02f})
      EXPECT_NEAR(double(airMass(3.0f, cosine, scale)) / airAlong(3.0f, cosine, scale), 1.0, 0.005)
          << scale << " km, cosine " << cosine;
}

TEST(Sky, TheSunSetsLaterFromAbove) {
  EXPECT_EQ(sunAboveHorizon(0.0f, 0.01f), 1.0f);
  EXPECT_NEAR(sunAboveHorizon(0.0f, 0.0f), 0.5f, 1e-4f);
  EXPECT_EQ(sunAboveHorizon(0.0f, -0.01f), 0.0f);
  EXPECT_EQ(sunAboveHorizon(10.0f, -0.04f), 1.0f) << "the horizon is 3.2° lower from 10 km";
}

// The CIE's own values: x̄ 1.0622, ȳ 0.6310 and z̄ 0.0008 at 600 nm; 0.3362, 0.0380 and 1.7721 at 450 nm.
TEST(Sky, ColourMatchingIsTheCies) {
  const vec3 orange = xyzOfWavelength(0.600f);
  EXPECT_NEAR(orange.x, 1.0622f, 0.03f);
  EXPECT_NEAR(orange.y, 0.6310f, 0.03f);
  EXPECT_NEAR(orange.z, 0.0008f, 0.03f);
  const vec3 blue = xyzOfWavelength(0.450f);
  EXPECT_NEAR(blue.x, 0.3362f, 0.03f);
  EXPECT_NEAR(blue.y, 0.0380f, 0.03f);
  EXPECT_NEAR(blue.z, 1.7721f, 0.06f);
}

// A black body of 5778 K: x 0.3259, y 0.3353 on Planck's locus.
TEST(Sky, TheSunOutsideOfTheAirIsABlackBody) {
  vec3 sum(0.0f);
  for (float wavelength = 0.38f; wavelength < 0.75f; wavelength += 0.005f)
    sum += xyzOfWavelength(wavelength) * sunSpectrum(wavelength);
  EXPECT_NEAR(sum.x / (sum.x + sum.y + sum.z), 0.3259f, 0.004f);
  EXPECT_NEAR(sum.y / (sum.x + sum.y + sum.z), 0.3353f, 0.004f);
}

TEST(Sky, DaylightFilmsWhiteIsWhite) {
  const vec3 d55(0.33242f / 0.34743f, 1.0f, (1.0f - 0.33242f - 0.34743f) / 0.34743f);
  const vec3 white = rec709FromXyz(xyzD65FromD55(d55));
  EXPECT_NEAR(white.x, 1.0f, 0.002f);
  EXPECT_NEAR(white.y, 1.0f, 0.002f);
  EXPECT_NEAR(white.z, 1.0f, 0.002f);
}

}  // namespace
}  // namespace mirrorball::formula
