#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/surface.h"

namespace mirrorball::formula {
namespace {

TEST(Microfacet, ALargerMapIsBlurredByAsManyLevelsMore) {
  EXPECT_EQ(lodOfLobe(1.0f, 6.0f), 6.0f);
  EXPECT_NEAR(lodOfLobe(std::sqrt(0.5f), 6.0f), 6.0f, 1e-5f) << "alpha ½ is as wide as a texel of 4² a face";
  EXPECT_EQ(lodOfLobe(0.0f, 6.0f), 0.0f);
  EXPECT_FLOAT_EQ(lodOfLobe(0.4f, 9.0f) - lodOfLobe(0.4f, 6.0f), 3.0f);
  // Half the width, alpha / 2, is r / √2.
  EXPECT_NEAR(lodOfLobe(0.6f, 8.0f) - lodOfLobe(0.6f / std::sqrt(2.0f), 8.0f), 1.0f, 1e-5f);
}

TEST(Microfacet, WhatAWhiteSurfaceDoesNotReflectAtOnceItReflectsLater) {
  for (const float whole : {0.3f, 0.7f, 1.0f})
    EXPECT_NEAR(multipleScattering(vec3(whole), vec3(1.0f), whole).x, 1.0f - whole, 1e-6f);
  EXPECT_EQ(multipleScattering(vec3(0.5f), vec3(0.0f), 0.5f).x, 0.0f) << "black facets reflect nothing twice";
}

TEST(Microfacet, EachFurtherBounceTakesItsShare) {
  const float once = 0.5f;
  const float mean_fresnel = 0.8f;
  const float whole = 0.6f;
  float sum = 0.0f;
  float share = once;
  for (int bounce = 0; bounce < 50; ++bounce) {
    share *= mean_fresnel * (1.0f - whole);
    sum += share;
  }
  EXPECT_NEAR(multipleScattering(vec3(once), vec3(mean_fresnel), whole).x, sum, 1e-6f);
}

TEST(Microfacet, MeanFresnelIsSchlicksOverTheHemisphere) {
  const float head_on = 0.3f;
  constexpr int kSteps = 2000;
  float mean = 0.0f;
  for (int i = 0; i < kSteps; ++i) {
    const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
    mean += 2.0f * cosine / kSteps * fresnelSchlick(cosine, vec3(head_on)).x;
  }
  EXPECT_NEAR(meanFresnel(vec3(head_on), 1.0f).x, mean, 1e-5f);
}

// However metallic and rough it is, a white surface in white light is white, and whatever its BRDF table says.
TEST(Shading, AMixtureOfMetalAndDielectricLosesNothing) {
  Surface surface{};
  surface.normal = vec3(0, 0, 1);
  surface.base_color = vec3(1.0f);
  surface.specular = 1.0f;
  surface.ior = 1.5f;
  surface.occlusion = 1.0f;
  for (const float metallic : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
    for (const float perceptual_roughness : {0.0f, 0.15f, 0.6f, 1.0f})
      for (float sine = 0.0f; sine < 1.0f; sine += 0.19f) {
        surface.metallic = metallic;
        surface.perceptual_roughness = perceptual_roughness;
        surface.environment_brdf = vec2(0.9f - 0.6f * perceptual_roughness, 0.1f * sine);
        const vec3 ray(sine, 0.0f, -std::sqrt(1.0f - sine * sine));
        const vec3 light = shadedByEnvironment(surface, ray, vec3(1.0f), vec3(0.0f), vec3(1.0f));
        EXPECT_NEAR(light.x, 1.0f, 1e-5f) << metallic << ", roughness " << perceptual_roughness << " at " << sine;
      }
}

TEST(Microfacet, PhongsExponentFollowsTheLobe) {
  EXPECT_NEAR(phongExponent(0.5f), 1.5f, 1e-6f) << "(2 / ¼ − 2) / 4";
  EXPECT_EQ(phongExponent(1.0f), 1.0f);
  EXPECT_GT(phongExponent(0.1f), phongExponent(0.2f));
}

}  // namespace
}  // namespace mirrorball::formula
