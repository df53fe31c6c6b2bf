#include "mirrorball/trace/layered_bsdf.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/sheen_albedo.h"
#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/trace/bsdf_testing.h"

namespace mirrorball {
namespace {

using testing::directionOf;
using testing::Estimate;
using testing::onSphere;

formula::Material white(float metallic, float roughness) {
  formula::Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = metallic;
  material.perceptual_roughness = roughness;
  return material;
}

formula::Material coated(formula::Material material, float share, float roughness) {
  material.clearcoat = share;
  material.clearcoat_roughness = roughness;
  return material;
}

formula::Material withCloth(formula::Material material, glm::vec3 color, float roughness) {
  material.sheen_color = color;
  material.sheen_roughness = roughness;
  return material;
}

formula::Material filmed(formula::Material material) {
  material.iridescence = 1.0f;
  material.iridescence_thickness = 350.0f;
  return material;
}

formula::Material brushed(formula::Material material, float anisotropy) {
  material.anisotropy = anisotropy;
  return material;
}

const Frame kFrame(glm::vec3(0.0f, 0.0f, 1.0f));
/// The coat's own, tilted as if the surface had bumps.
const Frame kCoatFrame(glm::normalize(glm::vec3(0.15f, -0.1f, 1.0f)));

LayeredBsdf layersOf(const formula::Material& material) {
  LayeredBsdf bsdf(material, {.ior = material.ior}, kFrame);
  bsdf.addSheen(material);
  bsdf.addCoat(material, kCoatFrame);
  return bsdf;
}

struct LayeredCase {
  const char* name;
  formula::Material material;
};
const auto kLayeredCases = std::to_array<LayeredCase>({
    {"coat", coated(white(1.0f, 0.4f), 1.0f, 0.0f)},
    {"rough coat over half", coated(white(0.0f, 0.6f), 0.5f, 0.5f)},
    {"cloth", withCloth(white(0.0f, 1.0f), glm::vec3(1.0f), 0.4f)},
    {"cloth under a coat", coated(withCloth(white(0.0f, 0.5f), glm::vec3(0.6f), 0.8f), 0.8f, 0.2f)},
    {"brushed metal", brushed(white(1.0f, 0.3f), 0.7f)},
    {"filmed plastic", filmed(white(0.0f, 0.4f))},
});

// White layers over white: nothing is lost.
TEST(LayeredBsdf, NothingIsLostInWhiteLayers) {
  for (const LayeredCase& one : kLayeredCases)
    for (const float cosine : {0.25f, 0.6f, 1.0f}) {
      const LayeredBsdf bsdf = layersOf(one.material);
      glm::dvec3 sum(0.0);
      Estimate green;
      constexpr int kPaths = 30000;
      for (std::uint32_t i = 0; i < kPaths; ++i) {
        SampleSequence samples(20, i);
        const auto next = bsdf.scatter(directionOf(cosine), {}, samples).scattering.next;
        sum += next ? glm::dvec3(next->weight) / double(kPaths) : glm::dvec3(0.0);
        green.add(next ? double(next->weight.y) : 0.0);
      }
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(sum[channel], 1.0, 2e-3 + 4.5 * green.error()) << one.name << ", n.v = " << cosine;
    }
}

// Light from all sides, half by light samples and half found by the path: together all of it.
TEST(LayeredBsdf, LightSamplesAndFoundLightAreBalanced) {
  const float uniform = 1.0f / (4.0f * formula::kPi);
  for (const LayeredCase& one : kLayeredCases)
    for (const float cosine : {0.25f, 0.9f}) {
      const LayeredBsdf bsdf = layersOf(one.material);
      Estimate light;
      for (std::uint32_t i = 0; i < 30000; ++i) {
        SampleSequence samples(22, i);
        const glm::vec3 l = onSphere(samples.next());
        const Scattering scattering = bsdf.scatter(directionOf(cosine), {l, uniform}, samples).scattering;
        const auto& next = scattering.next;
        const float weight = next && next->pdf > 0.0f ? balanceHeuristic(next->pdf, uniform) : 1.0f;
        light.add(double(scattering.direct.y + (next ? next->weight.y * weight : 0.0f)));
      }
      EXPECT_NEAR(light.mean(), 1.0, 2e-3 + 4.5 * light.error()) << one.name << ", n.v = " << cosine;
    }
}

// A coat of black below: what comes back is Fresnel's share of the index 1.5, and the rest has gone below.
TEST(LayeredBsdf, ASmoothCoatReflectsWhatFresnelSays) {
  formula::Material black = coated(white(0.0f, 1.0f), 1.0f, 0.0f);
  black.base_color = glm::vec3(0.0f);
  black.specular = 0.0f;
  LayeredBsdf bsdf(black, {.ior = black.ior}, kFrame);
  bsdf.addCoat(black, kFrame);
  for (const float cosine : {0.2f, 0.7f}) {
    Estimate reflected, below;
    for (std::uint32_t i = 0; i < 40000; ++i) {
      SampleSequence samples(24, i);
      const LayeredScattering scattered = bsdf.scatter(directionOf(cosine), {}, samples);
      reflected.add(scattered.scattering.next ? double(scattered.scattering.next->weight.y) : 0.0);
      below.add(double(scattered.share_below.y));
    }
    const double fresnel = double(formula::fresnelDielectric(cosine, 1.5f));
    EXPECT_NEAR(reflected.mean(), fresnel, 4.5 * reflected.error()) << cosine;
    EXPECT_NEAR(below.mean(), 1.0 - fresnel, 4.5 * below.error()) << cosine;
  }
}

// Cloth reflects its colour times its albedo, and lets through what its brightest channel leaves.
TEST(LayeredBsdf, ClothOverBlackReflectsItsAlbedo) {
  formula::Material black = withCloth(white(0.0f, 1.0f), {0.8f, 0.4f, 0.1f}, 0.5f);
  black.base_color = glm::vec3(0.0f);
  black.specular = 0.0f;
  for (const float cosine : {0.15f, 0.5f, 0.95f}) {
    glm::dvec3 reflected(0.0);
    Estimate red;
    constexpr int kPaths = 40000;
    for (std::uint32_t i = 0; i < kPaths; ++i) {
      SampleSequence samples(26, i);
      const auto next = layersOf(black).scatter(directionOf(cosine), {}, samples).scattering.next;
      reflected += next ? glm::dvec3(next->weight) / double(kPaths) : glm::dvec3(0.0);
      red.add(next ? double(next->weight.x) : 0.0);
    }
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(reflected[channel], double(black.sheen_color[channel] * sheenAlbedo(0.5f, cosine)),
                  2e-3 + 4.5 * red.error())
          << cosine << ", channel " << channel;
  }
}

// The eye straight above, whose cosine rounding has brought above 1: cloth has a number there.
TEST(LayeredBsdf, ClothHasANumberStraightFromAbove) {
  const glm::vec3 above(0.0f, 0.0f, 1.0000002f);
  for (const float roughness : {0.0f, 0.4f, 1.0f}) {
    const float alpha = formula::alphaOfSheen(roughness);
    EXPECT_TRUE(std::isfinite(formula::evalCharlie(alpha, above, {0.6f, 0.0f, 0.8f}))) << roughness;
    EXPECT_TRUE(std::isfinite(formula::evalCharlie(alpha, {0.6f, 0.0f, 0.8f}, above))) << roughness;
  }
}

// Facets are rougher along X: light from a light beside the highlight is found there, and not as far along Y.
TEST(LayeredBsdf, RoughnessIsStretchedAlongTheTangent) {
  const LayeredBsdf bsdf = layersOf(brushed(white(1.0f, 0.2f), 0.6f));
  const auto towards = [&](glm::vec3 l) {
    Estimate value;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      SampleSequence samples(28, i);
      value.add(double(bsdf.scatter({0.0f, 0.0f, 1.0f}, {glm::normalize(l), 1e9f}, samples).scattering.direct.y) * 1e9);
    }
    return value.mean();
  };
  // What one facet sends, by the formula, and a little from several of them.
  const glm::vec3 along = glm::normalize(glm::vec3(0.5f, 0.0f, 0.8f));
  const float expected = formula::evalGgx(formula::stretchedAlpha(0.2f, 0.6f), {0.0f, 0.0f, 1.0f}, along) * along.z;
  EXPECT_NEAR(towards(along), double(expected), 0.15 * double(expected));
  EXPECT_LT(towards({0.0f, 0.5f, 0.8f}), 0.05 * towards(along));
}

}  // namespace
}  // namespace mirrorball
