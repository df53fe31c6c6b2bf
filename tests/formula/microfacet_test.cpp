#include <cmath>

#include <gtest/gtest.h>

#include "formula/formula.h"

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

TEST(Microfacet, ASmoothSurfaceOfReflectanceOneReflectsAll) {
  for (float cosine = 0.1f; cosine <= 1.0f; cosine += 0.1f) {
    const vec2 scale_and_bias = environmentBrdf(0.0f, cosine);
    EXPECT_NEAR(scale_and_bias.x + scale_and_bias.y, 1.0f, 0.01f);
  }
}

// However metallic it is, a smooth white surface in white light is white.
TEST(Shading, AMixtureOfMetalAndDielectricLosesNothing) {
  Surface surface{};
  surface.normal = vec3(0, 0, 1);
  surface.base_color = vec3(1.0f);
  surface.specular = 1.0f;
  surface.ior = 1.5f;
  surface.occlusion = 1.0f;
  for (const float metallic : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
    for (float sine = 0.0f; sine < 1.0f; sine += 0.19f) {
      surface.metallic = metallic;
      const vec3 ray(sine, 0.0f, -std::sqrt(1.0f - sine * sine));
      const vec3 light = shadedByEnvironment(surface, ray, vec3(1.0f), vec3(0.0f), vec3(1.0f));
      EXPECT_NEAR(light.x, 1.0f, 1e-5f) << metallic << " at " << sine;
    }
}

// Karis 2014, figure 2: head on at roughness 1 the table has a scale of about 0.45 and hardly any bias.
TEST(Microfacet, ARoughSurfaceReflectsLess) {
  const vec2 head_on = environmentBrdf(1.0f, 1.0f);
  EXPECT_NEAR(head_on.x + head_on.y, 0.45f, 0.05f);
  EXPECT_GT(environmentBrdf(0.5f, 1.0f).x, head_on.x);
}

TEST(Microfacet, PhongsExponentFollowsTheLobe) {
  // alpha = ½: (2 / ¼ − 2) / 4.
  EXPECT_NEAR(phongExponent(std::sqrt(0.5f)), 1.5f, 1e-4f);
  EXPECT_GT(phongExponent(0.1f), phongExponent(0.2f));
}

}  // namespace
}  // namespace mirrorball::formula
