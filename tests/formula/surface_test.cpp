#include "formula/surface.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace mirrorball::formula {
namespace {

/// A point of the unit sphere, away from its poles.
vec3 spherePoint(float u, float v) { return {std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u)}; }

/// A height over the parameters, with slopes of both signs.
float waves(float u, float v) { return 0.01f * std::sin(5.0f * u) * std::cos(4.0f * v); }

/// The normal of the displaced sphere by central differences, pointing outwards.
vec3 trueNormal(float u, float v) {
  constexpr float kStep = 1e-3f;
  const auto point = [](float a, float b) { return spherePoint(a, b) * (1.0f + waves(a, b)); };
  const vec3 across = point(u + kStep, v) - point(u - kStep, v);
  const vec3 down = point(u, v + kStep) - point(u, v - kStep);
  const vec3 normal = normalize(cross(across, down));
  return dot(normal, spherePoint(u, v)) > 0.0f ? normal : -normal;
}

/// The cosine between the true normal and that of `bend`, at its worst.
template <typename Bend>
float worstCosine(const Bend& bend) {
  float worst = 1.0f;
  for (float u = 0.0f; u < 6.2f; u += 0.21f)
    for (float v = 0.5f; v < 2.6f; v += 0.17f) {
      const vec3 n = spherePoint(u, v);
      const vec3 p_u(-std::sin(v) * std::sin(u), 0.0f, std::sin(v) * std::cos(u));
      const vec3 p_v(std::cos(v) * std::cos(u), -std::sin(v), std::cos(v) * std::sin(u));
      const float d_u = 0.05f * std::cos(5.0f * u) * std::cos(4.0f * v);
      const float d_v = -0.04f * std::sin(5.0f * u) * std::sin(4.0f * v);
      // p_u × p_v points inwards here: with the outward normal the frame is left-handed and v runs the other way.
      worst = std::min(worst, dot(bend(-p_v, p_u, n, -d_v, d_u), trueNormal(u, v)));
    }
  return worst;
}

// p + d n is followed to first order in d: with d = 0.01 and a curvature of 1 the normal is off by about 0.01 · slope.
TEST(Tangent, PerturbedNormalIsTheDisplacedSurfaces) {
  const float worst = worstCosine(
      [](vec3 p_u, vec3 p_v, vec3 n, float d_u, float d_v) { return perturbedNormal(p_u, p_v, n, d_u, d_v); });
  EXPECT_GT(worst, std::cos(0.002f));
}

// Where heights go aside, as on a stretched object: the normal of a plane's points p + d · up, which change by
// p_u + d_u up.
TEST(LiftedNormal, IsThatOfAPlaneLiftedAside) {
  const vec3 n(0.0f, 0.0f, 1.0f);
  for (const float right : {1.0f, -1.0f})
    for (const vec3 up : {vec3(0.0f, 0.0f, 0.5f), vec3(0.3f, -0.4f, 0.5f)}) {
      const vec3 p_u(2.0f * right, 0.0f, 0.0f), p_v(0.5f, 1.0f, 0.0f);
      const vec2 d(0.7f * right, -0.3f);
      const vec3 expected = normalize(cross(p_u + d.x * up, p_v + d.y * up)) * right;
      EXPECT_LT(distance(liftedNormal(p_u, p_v, n, up, d), expected), 1e-6f) << right;
    }
}

/// The greatest angle between the displaced sphere's normal and displacedNormal [rad], of waves of that height.
///
/// right, down   signs with which u and v are counted
float worstBumpAngle(float height, float right, float down) {
  float worst = 0.0f;
  for (float u = 0.0f; u < 6.2f; u += 0.21f)
    for (float v = 0.5f; v < 2.6f; v += 0.17f) {
      const vec3 n = spherePoint(u, v);
      const vec3 p_u(-std::sin(v) * std::sin(u), 0.0f, std::sin(v) * std::cos(u));
      const vec3 p_v(std::cos(v) * std::cos(u), -std::sin(v), std::cos(v) * std::sin(u));
      const float d = height * std::sin(5.0f * u) * std::cos(4.0f * v);
      const float d_u = 5.0f * height * std::cos(5.0f * u) * std::cos(4.0f * v);
      const float d_v = -4.0f * height * std::sin(5.0f * u) * std::sin(4.0f * v);
      // (p + d n)_u with n = p
      const vec3 across = cross(p_u * (1.0f + d) + d_u * n, p_v * (1.0f + d) + d_v * n);
      const vec3 bent = displacedNormal(right * p_u, down * p_v, n, vec2(right * d_u, down * d_v));
      EXPECT_LT(distance(displacedNormal(down * p_v, right * p_u, n, vec2(down * d_v, right * d_u)), bent), 1e-6f);
      worst = std::max(worst, std::asin(length(cross(normalize(across), bent))));
      EXPECT_GT(dot(across, bent), 0.0f);
    }
  return worst;
}

// A map of slopes lies on the surface as a normal map does, however large and whichever way round it is.
TEST(Tangent, SlopesTellTheNormalsOfANormalMap) {
  const vec3 n(0.0f, 0.0f, 1.0f);
  const vec2 slope(0.5f, -0.25f);
  for (const float right : {-3.0f, 1e-4f, 1e5f})
    for (const float down : {-2.0f, 1.0f, 7.0f}) {
      const vec3 p_u(right, 0.0f, 0.0f), p_v(0.0f, -down, 0.0f);
      const vec3 mapped = normalFromMap(normalize(p_u), -normalize(p_v), n, vec3(-slope.x, slope.y, 1.0f), 1.0f);
      EXPECT_LT(distance(slopedNormal(p_u, p_v, n, slope), mapped), 1e-6f) << right << ", " << down;
      // What leans towards n counts only across it.
      EXPECT_LT(distance(slopedNormal(p_u + 0.5f * right * n, p_v, n, slope), mapped), 1e-6f);
    }
  EXPECT_EQ(slopedNormal(vec3(0.0f), vec3(0.0f), n, slope), n) << "no coordinates";
  EXPECT_EQ(slopedNormal(vec3(1, 0, 0), vec3(2, 0, 0), n, slope), n) << "both along one line";
}

TEST(Tangent, ObjectSpaceNormalsTurnAndKeepTheSurfaceWhereTheyAreNone) {
  const vec3 n(0.0f, 0.0f, 1.0f);
  const mat3 wide(vec3(0.5f, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
  const vec3 mapped(0.6f, 0.0f, 0.8f);
  EXPECT_LT(distance(objectMappedNormal(wide, n, mapped, 1.0f), normalize(vec3(0.3f, 0.0f, 0.8f))), 1e-6f);
  EXPECT_LT(distance(objectMappedNormal(wide, n, mapped, 0.0f), n), 1e-6f);
  EXPECT_EQ(objectMappedNormal(wide, n, vec3(0.0f), 1.0f), n);
  EXPECT_LT(objectMappedNormal(wide, n, mapped, -1.0f).x, 0.0f);
}

// An object's normals are as long as it is small, and its tangents as it is large.
TEST(Tangent, ObjectsMayBeOfAnySize) {
  const vec3 n(0.0f, 0.0f, 1.0f), mapped(0.6f, 0.0f, 0.8f);
  for (const float size : {1e-9f, 1e-6f, 1.0f, 1e6f, 1e9f}) {
    EXPECT_LT(distance(objectMappedNormal(mat3(1.0f / size), n, mapped, 1.0f), mapped), 1e-6f) << size;
    EXPECT_EQ(objectMappedNormal(mat3(1.0f / size), n, vec3(0.0f), 1.0f), n) << size;
    const vec3 turned = turnedTangent(vec4(size * vec3(0.6f, 0.8f, 0.1f), 1.0f), n, vec2(1.0f, 0.0f));
    EXPECT_LT(distance(turned, vec3(0.6f, 0.8f, 0.0f)), 1e-6f) << size;
  }
}

// However u and v run, and the more exact the lower the bumps are.
TEST(Tangent, BumpsAreRightInAllOrientationsToTheSquareOfTheirHeight) {
  for (const float right : {-1.0f, 1.0f})
    for (const float down : {-1.0f, 1.0f}) {
      const float high = worstBumpAngle(0.04f, right, down), low = worstBumpAngle(0.02f, right, down);
      EXPECT_LT(high, 0.02f);
      EXPECT_NEAR(high / low, 4.0f, 0.4f);
      EXPECT_NEAR(low / worstBumpAngle(0.01f, right, down), 4.0f, 0.4f);
    }
}

TEST(Tangent, TheSlidesSignsBendTheOtherWay) {
  const float worst = worstCosine([](vec3 p_u, vec3 p_v, vec3 n, float d_u, float d_v) {
    return normalize(cross(p_u, p_v) - d_u * cross(n, p_v) + d_v * cross(n, p_u));
  });
  EXPECT_LT(worst, std::cos(0.05f));
}

TEST(Tangent, AnyTangentIsUnitAndOrthogonal) {
  for (int i = 0; i < 500; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / 500.0f;
    const float angle = 2.39996f * static_cast<float>(i);
    const vec3 n(std::sqrt(1.0f - y * y) * std::cos(angle), std::sqrt(1.0f - y * y) * std::sin(angle), y);
    EXPECT_NEAR(dot(anyTangent(n), n), 0.0f, 1e-6f);
    EXPECT_NEAR(length(anyTangent(n)), 1.0f, 1e-6f);
  }
  EXPECT_EQ(anyTangent(vec3(0, 0, -1)), vec3(1, 0, 0));
}

TEST(Tangent, AFlatNormalMapLeavesTheNormal) {
  const vec3 n = normalFromMap(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0, 0, 1), 1.0f);
  EXPECT_EQ(n, vec3(0, 0, 1));
  const vec3 bent = normalFromMap(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 0, 0), 1.0f);
  EXPECT_NEAR(bent.x, 1.0f, 1e-6f) << "red points along the tangent";
  EXPECT_EQ(normalFromMap(vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.0f), 1.0f), vec3(0, 0, 1))
      << "a texel without a direction";
}

// glTF's rule, that of programs which write 128 for 0, and signed numbers: each has its 0, and all the same 1.
TEST(Tangent, ANormalMapIsDecodedByItsZero) {
  const vec3 flat(128.0f / 255.0f, 128.0f / 255.0f, 1.0f);
  EXPECT_NEAR(decodedNormal(flat, 127.5f).x, 1.0f / 255.0f, 1e-6f);
  EXPECT_LT(distance(decodedNormal(flat, 128.0f), vec3(0, 0, 1)), 1e-7f);
  EXPECT_EQ(decodedNormal(vec3(-0.25f, 0.5f, 1.0f), 0.0f), vec3(-0.25f, 0.5f, 1.0f));
  for (const float zero : {0.0f, 127.5f, 128.0f}) {
    const vec3 n(-0.6f, 0.0f, 0.8f);
    EXPECT_LT(distance(decodedNormal(encodedNormal(n, zero), zero), n), 1e-6f) << zero;
  }
}

// KHR_materials_specular: mix(min(f0 · color, 1), 1, (1 − cos θ)⁵) · specular.
TEST(TintedReflectance, IsTheExtensionsFormulaForSchlicksForm) {
  Surface s;
  s.material.fresnel = kFresnelSchlick;
  s.material.specular = 0.7f;
  s.material.specular_color = {0.5f, 3.0f, 40.0f};
  for (const float cosine : {0.0f, 0.3f, 0.8f, 1.0f}) {
    const vec3 f0 = min(0.04f * s.material.specular_color, vec3(1.0f));
    const vec3 wanted = 0.7f * mix(f0, vec3(1.0f), std::pow(1.0f - cosine, 5.0f));
    EXPECT_LT(distance(smoothDielectric(s.material, cosine), wanted), 1e-6f) << cosine;
  }
}

TEST(TintedReflectance, TakesNoMoreThanAllLight) {
  for (const float ior : {1.0f, 1.5f, 10.0f})
    for (const float factor : {0.0f, 1.0f, 1e6f}) {
      Surface s;
      s.material.ior = ior;
      s.material.specular_color = {factor, 0.0f, 1.0f};
      Surface grey;
      grey.material = withGreySpecular(s.material);
      for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.05f) {
        const vec3 reflected = smoothDielectric(s.material, cosine);
        const vec3 entering = vec3(1.0f) - smoothDielectric(grey.material, cosine);
        for (int channel = 0; channel < 3; ++channel) {
          EXPECT_GE(reflected[channel], 0.0f);
          EXPECT_LE(reflected[channel] + entering[channel], 1.0f + 1e-6f) << ior << ", " << factor << ", " << cosine;
        }
      }
    }
}

TEST(Height, TheGradientIsTheHeightsOwn) {
  constexpr float kStep = 1e-3f;
  int felt = 0;
  for (int i = 0; i < 2000; ++i) {
    const vec3 p = gridRandom(ivec3(i, 7, -3)) * 20.0f - 10.0f;
    const vec4 here = orangeHeight(p);
    for (int axis = 0; axis < 3; ++axis) {
      vec3 step(0.0f);
      step[axis] = kStep;
      const float slope = (orangeHeight(p + step).w - orangeHeight(p - step).w) / (2.0f * kStep);
      // The third derivative is at most about 100: a step of 10⁻³ leaves 2e-5, rounding of heights near 1 leaves 1e-4.
      EXPECT_NEAR(here[axis], slope, 2e-3f);
    }
    if (here.w < 0.0f) ++felt;
  }
  EXPECT_GT(felt, 500) << "pits of half a cell's radius fill half the space";
}

TEST(Height, TheSlopesHaveTheVarianceThatIsWrittenDown) {
  constexpr int kPlaces = 400000;
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const vec3 slopes(orangeHeight(gridRandom(ivec3(i, 3, 5)) * 200.0f - 100.0f));
    sum += double(dot(slopes, slopes)) / 3.0;
  }
  EXPECT_NEAR(sum / kPlaces, double(kOrangeSlopeVariance), 0.01);
}

// Of the mean over a square across two axes.
TEST(Height, AMeanOfSlopesKeepsTheShareThatIsTold) {
  constexpr int kPlaces = 3000;
  constexpr int kSide = 12;
  for (const float width : {0.125f, 0.25f, 0.5f, 1.0f, 2.0f}) {
    double sum = 0.0;
    for (int i = 0; i < kPlaces; ++i) {
      const vec3 corner = gridRandom(ivec3(i, 3, 5)) * 200.0f - 100.0f;
      vec2 mean(0.0f);
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          mean += vec2(orangeHeight(corner + width / float(kSide) * vec3(x, y, 0.0f))) / float(kSide * kSide);
      sum += 0.5 * double(dot(mean, mean));
    }
    const float share = orangeSlopeShare(vec3(width, 0.0f, 0.0f), vec3(0.0f, width, 0.0f));
    EXPECT_NEAR(std::sqrt(sum / (kPlaces * double(kOrangeSlopeVariance))), double(share), 0.03) << width;
  }
}

/// In the plane of x and the normal, which is y.
vec3 tilted(float degrees) { return {std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0.0f}; }

// From a corner that sees all of the sky to one that a small hider stands beside: what is hidden of the lobe grows from
// nothing, without a dip or a jump on its way, which would be a line along the triangle's edge.
TEST(SelfOcclusion, WhatIsHiddenGrowsEvenlyAcrossATriangle) {
  constexpr int kSteps = 1000;
  constexpr float kShareAtCorner = 1.0f / 64.0f;
  const vec3 n = tilted(0.0f);
  for (const float alpha : {0.04f, 0.09f, 0.36f, 1.0f})
    for (const float tilt : {0.0f, 40.0f, 70.0f, 85.0f})
      for (const float reflected : {-80.0f, -40.0f, 0.0f, 40.0f, 65.0f, 80.0f, 88.0f}) {
        float before = 1.0f;
        for (int step = 0; step <= kSteps; ++step) {
          const float share = kShareAtCorner * static_cast<float>(step) / static_cast<float>(kSteps);
          const Opening opening = openingOf(n, share * tilted(tilt), 1.0f - share);
          const float open = lobeInOpening(opening, n, tilted(reflected), alpha);
          ASSERT_LE(open, before + 1e-4f) << alpha << ", hidden at " << tilt << ", to " << reflected << ": " << share;
          ASSERT_GE(open, before - 0.02f) << alpha << ", hidden at " << tilt << ", to " << reflected << ": " << share;
          before = open;
        }
      }
}

// The lobe of a hider in front of a sun holds more than arrives: what is left is not black, nor of another colour.
TEST(SelfOcclusion, ASunBehindAHiderTakesNotAllTheLight) {
  const glm::vec3 on_surface(1.0f, 1.0f, 1.2f), through(0.3f, 0.4f, 0.6f);
  const glm::vec3 in_front_of_sun = lightBesideOccluded(on_surface, glm::vec3(9.0f, 8.0f, 7.0f), through, 0.7f);
  EXPECT_NEAR(glm::distance(in_front_of_sun, 0.5f * through), 0.0f, 1e-6f);
  const glm::vec3 in_even_light = lightBesideOccluded(on_surface, glm::vec3(1.0f), through, 0.7f);
  EXPECT_NEAR(glm::distance(in_even_light, on_surface - 0.3f), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace mirrorball::formula
