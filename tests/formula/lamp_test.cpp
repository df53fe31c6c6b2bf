#include "formula/lamp.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "formula/surface.h"

namespace mirrorball::formula {
namespace {

Lamp lampOfKind(int kind, vec3 color = vec3(1.0f)) {
  Lamp lamp;
  lamp.kind = kind;
  lamp.color = color;
  return lamp;
}

TEST(Lamp, APointsLightFallsWithTheSquareOfTheDistance) {
  Lamp lamp = lampOfKind(kLampPoint, vec3(18.0f, 9.0f, 0.0f));
  lamp.position = {0, 0, 3};
  EXPECT_EQ(lampIlluminance(lamp, vec3(0.0f)), vec3(2.0f, 1.0f, 0.0f));
  EXPECT_EQ(lampIlluminance(lamp, vec3(0, 0, 9)), vec3(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(towardsLamp(lamp, vec3(0, 0, 9)), vec3(0, 0, -1));
  for (const int kind : {kLampPoint, kLampSpot}) {
    lamp.kind = kind;
    const vec3 at_itself = lampIlluminance(lamp, lamp.position);
    EXPECT_TRUE(std::isfinite(at_itself.x)) << kind;
  }
}

TEST(Lamp, ItsRangeEndsItsLight) {
  Lamp lamp = lampOfKind(kLampPoint);
  lamp.range = 2.0f;
  // 1 − (d / range)⁴ of the inverse square.
  EXPECT_FLOAT_EQ(lampIlluminance(lamp, vec3(1, 0, 0)).x, 1.0f - 1.0f / 16.0f);
  EXPECT_EQ(lampIlluminance(lamp, vec3(2, 0, 0)).x, 0.0f);
  EXPECT_EQ(lampIlluminance(lamp, vec3(50, 0, 0)).x, 0.0f);
}

TEST(Lamp, ASpotIsWholeInItsInnerConeAndDarkBeyondTheOuter) {
  Lamp lamp = lampOfKind(kLampSpot);
  lamp.cosine_inner = std::cos(0.3f);
  lamp.cosine_outer = std::cos(0.6f);
  const auto at = [&](float angle) { return lampIlluminance(lamp, vec3(std::sin(angle), 0, -std::cos(angle))).x; };
  EXPECT_NEAR(at(0.0f), 1.0f, 1e-5f);
  EXPECT_NEAR(at(0.29f), 1.0f, 1e-5f);
  EXPECT_NEAR(at(0.61f), 0.0f, 1e-6f);
  EXPECT_EQ(at(3.0f), 0.0f);
  for (float angle = 0.31f; angle < 0.59f; angle += 0.02f) EXPECT_GT(at(angle), at(angle + 0.02f));
  lamp.cosine_inner = lamp.cosine_outer;  // without an edge in between
  EXPECT_NEAR(at(0.5f), 1.0f, 1e-5f);
  EXPECT_EQ(at(0.7f), 0.0f);
}

TEST(Lamp, DirectionalLightIsTheSameEverywhere) {
  Lamp lamp = lampOfKind(kLampDirectional, vec3(5.0f));
  lamp.direction = {0, -1, 0};
  lamp.range = 0.1f;
  EXPECT_EQ(lampIlluminance(lamp, vec3(1e6f)), vec3(5.0f));
  EXPECT_EQ(towardsLamp(lamp, vec3(1e6f)), vec3(0, 1, 0));
}

/// The sum of what a surface sends towards the eye of light that is 1 in each direction.
vec3 underAllDirections(const Surface& surface, vec3 ray) {
  const Surface s = seenAlong(surface, ray);
  constexpr int kRings = 400, kSpokes = 200;
  vec3 sum(0.0f);
  for (int ring = 0; ring < kRings; ++ring)
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const float z = (float(ring) + 0.5f) / kRings;
      const float angle = kTwoPi * (float(spoke) + 0.5f) / kSpokes;
      const float sine = std::sqrt(1.0f - z * z);
      sum += shadedByPunctualLight(s, ray, vec3(sine * std::cos(angle), sine * std::sin(angle), z), vec3(1.0f));
    }
  return sum * (kTwoPi / (kRings * kSpokes));
}

/// Surface::environment_brdf of facets with Schlick's form: what is missing to 1, and 1 − c where (1 − c)⁵ is the share
/// that those of f0 = 0 send of what white ones do; so all are of one kind.
vec3 environmentBrdfOf(float perceptual_roughness, vec3 v) {
  const auto sent = [&](float f0) {
    Surface metal;
    metal.normal = {0, 0, 1};
    metal.material.metallic = 1.0f;
    metal.material.base_color = vec3(f0);
    metal.material.perceptual_roughness = perceptual_roughness;
    metal.environment_brdf = vec3(0.0f);  // nothing is taken for missing
    return underAllDirections(metal, -v).x;
  };
  const float grazing = std::pow(sent(0.0f) / sent(1.0f), 0.2f);
  return {1.0f - sent(1.0f), grazing, grazing};
}

// What a surface sends of light from all sides is what it sends of an environment: a white one stays white.
TEST(ShadedByPunctualLight, KeepsTheEnergyOfAWhiteSurface) {
  for (const float roughness : {0.4f, 0.7f, 1.0f})
    for (const float cosine : {0.95f, 0.5f}) {
      const vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
      for (const float metallic : {0.0f, 1.0f}) {
        Surface s;
        s.normal = {0, 0, 1};
        s.material.metallic = metallic;
        s.material.base_color = vec3(1.0f);
        s.material.perceptual_roughness = roughness;
        s.material.fresnel = kFresnelSchlick;
        s.environment_brdf = environmentBrdfOf(roughness, v);
        EXPECT_NEAR(underAllDirections(s, -v).x, 1.0f, 2e-3f) << roughness << ", " << cosine << ", " << metallic;
      }
    }
}

TEST(ShadedByPunctualLight, OfAMattSurfaceIsLamberts) {
  Surface s;
  s.normal = {0, 0, 1};
  s.material.base_color = {0.5f, 0.25f, 1.0f};
  s.material.specular = 0.0f;
  s.environment_brdf = vec3(0.0f);
  const vec3 light = normalize(vec3(1, 0, 1));
  const vec3 shaded = shadedByPunctualLight(seenAlong(s, vec3(0, 0, -1)), vec3(0, 0, -1), light, vec3(2.0f));
  EXPECT_LT(distance(shaded, s.material.base_color * (2.0f / kPi * light.z)), 1e-6f);
  EXPECT_EQ(shadedByPunctualLight(s, vec3(0, 0, -1), -light, vec3(2.0f)), vec3(0.0f)) << "from behind";
}

TEST(ShadedByPunctualLight, IsFiniteAtGrazingAnglesAndOnMirrors) {
  for (const float roughness : {0.0f, 1e-3f, 1.0f})
    for (const vec3 ray : {vec3(0, 0, -1), vec3(1, 0, 0), vec3(1, 0, 1e-6f), vec3(0, 0, 1)})
      for (const vec3 light : {vec3(0, 0, 1), vec3(-1, 0, 1e-7f), vec3(1, 0, 1e-7f)}) {
        Surface s;
        s.normal = {0, 0, 1};
        s.material.metallic = 1.0f;
        s.material.base_color = vec3(1.0f);
        s.material.perceptual_roughness = roughness;
        s.environment_brdf = vec3(0.1f);
        EXPECT_TRUE(std::isfinite(shadedByPunctualLight(seenAlong(s, ray), ray, light, vec3(1.0f)).x)) << roughness;
      }
}

}  // namespace
}  // namespace mirrorball::formula
