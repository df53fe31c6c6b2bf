#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/constants.h"
#include "formula/surface.h"

namespace mirrorball::formula {
namespace {

TEST(LodOfLobe, HoldsHalfOfTheLobe) {
  for (const double roughness : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    const auto alpha = static_cast<float>(roughness * roughness);
    const double s_half = std::pow(std::sin(double(ggxHalfAngle(static_cast<float>(roughness))) / 2.0), 2.0);
    // In steps of ln s, so that the narrow peak has enough of them.
    double within = 0.0;
    double whole = 0.0;
    constexpr int kSteps = 40000;
    for (int i = 0; i < kSteps; ++i) {
      const double s = 0.5 * std::exp(-20.0 * (i + 0.5) / kSteps);
      const double weight = double(ggxLobe(alpha, static_cast<float>(s))) * s;
      whole += weight;
      if (s <= s_half) within += weight;
    }
    EXPECT_NEAR(within / whole, 0.5, 0.005) << roughness;
  }
  EXPECT_NEAR(ggxHalfAngle(1.0f), kPi / 4.0f, 0.001f);
  EXPECT_NEAR(ggxHalfAngle(0.01f), 2e-4f, 1e-6f);
}

// Where a trilinear read lies within its texel is chance: over all places it is a square convolved with a tent.
TEST(LodOfLobe, ReadsTexelsThatHoldHalfOfTheirWeightThere) {
  const vec3 middle(0, 0, 1);
  const float texels = std::exp2(lodOfLobe(0.4f, 256.0f, middle));  // of level 0
  const float half_angle_in_texels = ggxHalfAngle(0.4f) * 256.0f / texels;
  const auto squareAndTent = [](float x) {
    x = std::abs(x);
    return x < 0.5f ? 0.75f - x * x : x < 1.5f ? 0.5f * (1.5f - x) * (1.5f - x) : 0.0f;
  };
  double within = 0.0;
  double whole = 0.0;
  for (float x = -1.495f; x < 1.5f; x += 0.01f)
    for (float y = -1.495f; y < 1.5f; y += 0.01f) {
      const double weight = double(squareAndTent(x) * squareAndTent(y));
      whole += weight;
      if (x * x + y * y < half_angle_in_texels * half_angle_in_texels) within += weight;
    }
  EXPECT_NEAR(within / whole, 0.5, 0.005);

  EXPECT_EQ(lodOfLobe(0.0f, 256.0f, middle), 0.0f);
  EXPECT_NEAR(lodOfLobe(0.4f, 1024.0f, middle) - lodOfLobe(0.4f, 128.0f, middle), 3.0f, 1e-5f) << "a larger map";
  // In a corner a texel has 3^(−3/2) of the solid angle that it has in the middle.
  EXPECT_NEAR(lodOfLobe(0.4f, 256.0f, normalize(vec3(1))) - lodOfLobe(0.4f, 256.0f, middle), 0.75f * std::log2(3.0f),
              1e-5f);
}

// 704 and 384 are what panoramas of 1024 and 512 rows become: 11², 5², 2², 1 texel; 6², 3², 1.
TEST(LodOfLobe, KnowsThatLevelsHalveRoundingDown) {
  for (const float side : {704.0f, 384.0f, 512.0f}) {
    float coarsest = 0.0f;
    for (float roughness = 0.1f; roughness <= 1.0f; roughness += 0.01f) {
      const float lod = lodOfLobe(roughness, side / 2.0f, vec3(0, 0, 1));
      const int level = static_cast<int>(lod);
      const float finer = side / std::floor(side / std::exp2(static_cast<float>(level)));
      const float coarser = side / std::floor(side / std::exp2(static_cast<float>(level + 1)));
      const float texels = finer * std::pow(coarser / finer, lod - static_cast<float>(level));
      EXPECT_NEAR(texels / (ggxHalfAngle(roughness) / 0.608f * side / 2.0f), 1.0f, 1e-4f) << side << ", " << roughness;
      coarsest = lod;
    }
    EXPECT_LT(coarsest, std::floor(std::log2(side)));
  }
  EXPECT_GE(lodOfLobe(1.0f, 192.0f, normalize(vec3(1))), 8.0f) << "wider than a face: its one texel";
}

TEST(Microfacet, SingleAndMultipleScatteringOfAWhiteSurfaceAddUpToOne) {
  for (const float missing : {0.7f, 0.3f, 0.0f})
    EXPECT_NEAR(multipleScattering(vec3(1.0f), vec3(1.0f), missing).x, missing, 1e-6f);
  EXPECT_EQ(multipleScattering(vec3(0.5f), vec3(0.0f), 0.5f).x, 0.0f) << "black facets reflect nothing twice";
}

TEST(Microfacet, EachFurtherBounceTakesItsShare) {
  const float mean_fresnel = 0.8f;
  const float missing = 0.4f;
  const float leaves = 1.0f - kKeptOfMissing * missing;
  float sum = 0.0f;
  float share = 0.9f * missing;  // of the first facets, which reflect 0.9
  for (int bounce = 0; bounce < 50; ++bounce) {
    share *= mean_fresnel;
    sum += leaves * share;
    share *= 1.0f - leaves;
  }
  EXPECT_NEAR(multipleScattering(vec3(0.9f), vec3(mean_fresnel), missing).x, sum, 1e-6f);
}

TEST(Microfacet, MeanFresnelIsThatOfTheWholeHemisphere) {
  const auto expectMean = [](auto form, float tolerance, const char* what) {
    constexpr int kSteps = 2000;
    vec3 mean(0.0f);
    for (int i = 0; i < kSteps; ++i) {
      const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
      mean += 2.0f * cosine / kSteps * form(cosine);
    }
    const vec3 at = kMeanFresnelCosines;
    EXPECT_NEAR(dot(kMeanFresnelWeights, vec3(form(at.x).x, form(at.y).x, form(at.z).x)), mean.x, tolerance) << what;
  };
  expectMean([](float) { return vec3(1.0f); }, 1e-5f, "white");
  expectMean([](float cosine) { return fresnelSchlick(cosine, vec3(0.3f)); }, 1e-5f, "Schlick");
  expectMean([](float cosine) { return vec3(fresnelEmpirical(cosine, 0.1f, 0.8f, 2.0f)); }, 1e-5f, "empirical");
  expectMean([](float cosine) { return vec3(fresnelDielectric(cosine, 1.5f)); }, 2e-3f, "glass");
  expectMean([](float cosine) { return vec3(fresnelDielectric(cosine, 2.417f)); }, 2e-3f, "diamond");
  expectMean([](float cosine) { return vec3(fresnelConductor1(cosine, 3.107f, 3.331f)); }, 2e-3f, "chromium");
  expectMean([](float cosine) { return fresnelF82(cosine, vec3(0.9f), vec3(0.2f)); }, 6e-3f, "F82");
}

// However metallic and rough it is, a white surface in white light is white, and whatever its BRDF table says.
TEST(Shading, AMixtureOfMetalAndDielectricLosesNothing) {
  Surface surface{};
  surface.normal = vec3(0, 0, 1);
  surface.material.base_color = vec3(1.0f);
  surface.material.specular = 1.0f;
  surface.material.ior = 1.5f;
  surface.occlusion = 1.0f;
  for (const float metallic : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f})
    for (const float perceptual_roughness : {0.0f, 0.15f, 0.6f, 1.0f})
      for (float sine = 0.0f; sine < 1.0f; sine += 0.19f) {
        surface.material.metallic = metallic;
        surface.material.perceptual_roughness = perceptual_roughness;
        surface.environment_brdf = vec3(0.1f + 0.5f * perceptual_roughness, 0.1f * sine, 0.05f * sine);
        const vec3 ray(sine, 0.0f, -std::sqrt(1.0f - sine * sine));
        const vec3 light = shadedByEnvironment(seenAlong(surface, ray), vec3(1.0f), vec3(0.0f), vec3(1.0f), vec3(0.0f));
        EXPECT_NEAR(light.x, 1.0f, 1e-5f) << metallic << ", roughness " << perceptual_roughness << " at " << sine;
      }
}

// The index is that of the air, and so there is no surface, however rough: what is behind it is seen as it is.
TEST(Shading, AnIndexOfOneIsInvisible) {
  Surface surface{};
  surface.normal = vec3(0, 0, 1);
  surface.material.base_color = vec3(1.0f);
  surface.material.transmission = 1.0f;
  surface.material.ior = 1.0f;
  surface.occlusion = 1.0f;
  for (const float perceptual_roughness : {0.0f, 0.15f, 0.6f, 1.0f})
    for (const float grazing : {0.0f, 0.5f, 0.99f}) {
      surface.material.perceptual_roughness = perceptual_roughness;
      surface.environment_brdf = vec3(0.6f * perceptual_roughness, grazing, grazing);
      const vec3 ray(0.6f, 0.0f, -0.8f);
      const Surface seen = seenAlong(surface, ray);
      const vec3 light = shadedByEnvironment(seen, vec3(100.0f), vec3(0.5f), vec3(100.0f), vec3(0.0f));
      EXPECT_NEAR(light.x, 0.5f, 1e-4f) << "roughness " << perceptual_roughness << ", " << grazing;
    }
}

TEST(Microfacet, PhongsExponentFollowsTheLobe) {
  EXPECT_NEAR(phongExponent(0.5f), 1.5f, 1e-6f) << "(2 / ¼ − 2) / 4";
  EXPECT_EQ(phongExponent(1.0f), 1.0f);
  EXPECT_GT(phongExponent(0.1f), phongExponent(0.2f));
}

}  // namespace
}  // namespace mirrorball::formula
