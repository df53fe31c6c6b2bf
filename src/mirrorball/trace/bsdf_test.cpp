#include "mirrorball/trace/bsdf.h"

#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

formula::Material whiteMetal(float roughness) {
  formula::Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = roughness;
  return material;
}

formula::Material plastic(float roughness) {
  formula::Material material = whiteMetal(roughness);
  material.metallic = 0.0f;
  return material;
}

formula::Material glass(float roughness) {
  formula::Material material = plastic(roughness);
  material.transmission = 1.0f;
  return material;
}

formula::Material halfGlass(float roughness) {
  formula::Material material = plastic(roughness);
  material.transmission = 0.5f;
  return material;
}

Bsdf bsdfOf(const formula::Material& material) { return {material, {.ior = material.ior}}; }

glm::vec3 directionOf(float cosine) { return {std::sqrt(1.0f - cosine * cosine), 0.0f, cosine}; }

/// A direction of equal density over the whole sphere.
glm::vec3 onSphere(glm::vec2 u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(1.0f - z * z, 0.0f));
  return {radius * std::cos(formula::kTwoPi * u.y), radius * std::sin(formula::kTwoPi * u.y), z};
}

std::optional<BsdfSample> sampled(const Bsdf& bsdf, glm::vec3 v, SampleSequence& samples) {
  return bsdf.scatter(v, {}, samples).next;
}

/// The BSDF times cosine: what a light sample gives that is so likely that nothing else has a weight.
float evaluated(const Bsdf& bsdf, glm::vec3 v, glm::vec3 l, SampleSequence& samples) {
  constexpr float kCertain = 1e9f;
  return bsdf.scatter(v, {l, kCertain}, samples).direct.y * kCertain;
}

/// A mean and its standard error.
struct Estimate {
  double sum = 0.0, squares = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double error() const { return std::sqrt(std::max(squares / count - mean() * mean(), 0.0) / count); }
};

struct Case {
  const char* name;
  formula::Material material;
  bool is_thin = false;
};
const auto kCases = std::to_array<Case>({{"metal 0.2", whiteMetal(0.2f)},
                                         {"metal 0.6", whiteMetal(0.6f)},
                                         {"metal 1", whiteMetal(1.0f)},
                                         {"plastic 0", plastic(0.0f)},
                                         {"plastic 0.3", plastic(0.3f)},
                                         {"plastic 1", plastic(1.0f)},
                                         {"glass 0.2", glass(0.2f)},
                                         {"glass 0.6", glass(0.6f)},
                                         {"glass 1", glass(1.0f)},
                                         {"milk glass 0", halfGlass(0.0f)},
                                         {"milk glass 0.4", halfGlass(0.4f)},
                                         {"pane 0", glass(0.0f), true},
                                         {"pane 0.5", glass(0.5f), true},
                                         {"milk pane 0.5", halfGlass(0.5f), true}});

Bsdf bsdfOf(const Case& one) { return {one.material, {.ior = one.material.ior, .is_thin = one.is_thin}}; }

// What nothing absorbs leaves: in white light the surface is white. A walk of 64 facets at most loses less than 1e-3.
TEST(Bsdf, NothingIsLostAtAWhiteSurface) {
  for (const Case& one : kCases)
    for (const float cosine : {0.1f, 0.5f, 1.0f, -0.5f}) {
      if (cosine < 0.0f && one.material.transmission == 0.0f) continue;
      Estimate share;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        SampleSequence samples(1, i);
        const auto sample = sampled(bsdfOf(one), directionOf(cosine), samples);
        share.add(sample ? double(sample->weight.y) : 0.0);
      }
      EXPECT_NEAR(share.mean(), 1.0, 1e-3 + 4.0 * share.error()) << one.name << ", n.v = " << cosine;
    }
}

// The same light by evaluate alone, over directions of equal density; smooth surfaces' single directions are not in it.
TEST(Bsdf, EvaluatedAndSampledLightIsTheSameInEachPartOfTheSphere) {
  constexpr int kSectors = 8;
  const auto sectorOf = [](glm::vec3 l) {
    return (l.z > 0.0f ? 0 : 4) + (std::abs(l.z) > 0.6f ? 2 : 0) + (l.x > 0.0f ? 1 : 0);
  };
  for (const Case& one : kCases)
    for (const float cosine : {0.3f, 0.8f, -0.6f}) {
      if (cosine < 0.0f && one.material.transmission == 0.0f) continue;
      const Bsdf bsdf = bsdfOf(one);
      const glm::vec3 v = directionOf(cosine);
      std::array<Estimate, kSectors> by_walk, by_light;
      for (std::uint32_t i = 0; i < 40000; ++i) {
        SampleSequence samples(2, i);
        const auto sample = sampled(bsdf, v, samples);
        const bool counts = sample && sample->pdf > 0.0f;
        const glm::vec3 l = onSphere(samples.next());
        const double value = double(evaluated(bsdf, v, l, samples)) * 4.0 * double(formula::kPi);
        for (int sector = 0; sector < kSectors; ++sector) {
          by_walk[std::size_t(sector)].add(counts && sectorOf(sample->direction) == sector ? double(sample->weight.y)
                                                                                           : 0.0);
          by_light[std::size_t(sector)].add(sectorOf(l) == sector ? value : 0.0);
        }
      }
      for (std::size_t sector = 0; sector < kSectors; ++sector)
        EXPECT_NEAR(by_walk[sector].mean(), by_light[sector].mean(),
                    2e-3 + 4.5 * std::hypot(by_walk[sector].error(), by_light[sector].error()))
            << one.name << ", n.v = " << cosine << ", sector " << sector;
    }
}

// Helmholtz: f(v, l) = f(l, v), so evaluate's value times the other cosine is the same both ways.
TEST(Bsdf, AMetalIsReciprocal) {
  const Bsdf bsdf = bsdfOf(whiteMetal(0.7f));
  const glm::vec3 a = directionOf(0.35f), b = glm::normalize(glm::vec3(-0.3f, 0.5f, 0.7f));
  Estimate forth, back;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    SampleSequence samples(4, i);
    forth.add(double(evaluated(bsdf, a, b, samples) * a.z));
    back.add(double(evaluated(bsdf, b, a, samples) * b.z));
  }
  EXPECT_NEAR(forth.mean(), back.mean(), 4.0 * std::hypot(forth.error(), back.error()));
  EXPECT_GT(forth.mean(), 100.0 * forth.error());
}

// Facets that reflect a thousandth at any angle reflect hardly anything twice: what is left is formula/bsdf/ggx.glsl.
TEST(Bsdf, SingleScatteringIsTheFormulas) {
  constexpr float kReflectance = 1e-3f;
  formula::Material material = plastic(0.5f);
  material.base_color = glm::vec3(0.0f);
  material.fresnel = formula::kFresnelEmpirical;
  material.fresnel_offset = kReflectance;
  material.fresnel_scale = 0.0f;
  const Bsdf bsdf = bsdfOf(material);
  const float alpha = 0.25f;
  const glm::vec3 v = directionOf(0.8f);
  for (const glm::vec3 l : {glm::vec3(-0.6f, 0.0f, 0.8f), glm::normalize(glm::vec3(-0.2f, 0.3f, 0.9f))}) {
    Estimate value;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      SampleSequence samples(6, i);
      value.add(double(evaluated(bsdf, v, l, samples)));
    }
    const double expected = double(formula::evalGgx(glm::vec2(alpha), v, l) * l.z * kReflectance);
    EXPECT_NEAR(value.mean(), expected, 2e-3 * expected + 4.0 * value.error());
  }
}

// Light from all sides is sampled and found by the path, each with its weight: together all of it, and no path has much
// more than its part, however narrow the lobe is.
TEST(Bsdf, LightSamplesAndFoundLightAreBalanced) {
  const float uniform = 1.0f / (4.0f * formula::kPi);
  for (const Case& one : kCases)
    for (const float cosine : {0.03f, 0.3f, 0.9f}) {
      Estimate light;
      float max = 0.0f;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        SampleSequence samples(8, i);
        const glm::vec3 l = onSphere(samples.next());
        const auto [direct, next, enters] = bsdfOf(one).scatter(directionOf(cosine), {l, uniform}, samples);
        const float found =
            !next ? 0.0f : next->weight.y * (next->pdf > 0.0f ? balanceHeuristic(next->pdf, uniform) : 1.0f);
        light.add(double(direct.y + found));
        max = std::max(max, direct.y + found);
      }
      EXPECT_NEAR(light.mean(), 1.0, 1e-3 + 4.0 * light.error()) << one.name << ", n.v = " << cosine;
      EXPECT_LT(max, 9.0f) << one.name << ", n.v = " << cosine;
    }
}

// A small light away from the highlight of a rough metal is seen by way of several facets. No path that finds it is so
// bright that it stands out: drawn by the walk alone, paths would spread by 7 to 9 times their mean.
TEST(Bsdf, ASmallLightBetweenTheFacetsIsFoundEvenly) {
  constexpr float kSunPdf = 15000.0f;
  for (const float roughness : {0.45f, 0.7f})
    for (const glm::vec3 l :
         {glm::vec3(0.9f, 0.3f, 0.3f), glm::vec3(0.2f, 0.95f, 0.2f), glm::vec3(-0.3f, 0.95f, 0.1f)}) {
      Estimate light;
      for (std::uint32_t i = 0; i < 50000; ++i) {
        SampleSequence samples(12, i);
        const LightSample sun{glm::normalize(l), kSunPdf};
        light.add(double(bsdfOf(whiteMetal(roughness)).scatter(directionOf(0.6f), sun, samples).direct.y * kSunPdf));
      }
      EXPECT_LT(light.error() * std::sqrt(light.count), 2.5 * light.mean()) << roughness << ", " << l.x;
    }
}

// The same of a lamp of 0.3 sr, which both a light sample and the walk find: weighed against the walk alone, single
// paths by two facets would take the spread to 6 times the mean.
TEST(Bsdf, ALampBetweenTheFacetsIsFoundEvenly) {
  constexpr float kCosine = 0.95f;
  const float pdf = 1.0f / (formula::kTwoPi * (1.0f - kCosine));
  const Bsdf bsdf = bsdfOf(whiteMetal(0.45f));
  for (const glm::vec3 towards : {glm::vec3(0.9f, 0.3f, 0.3f), glm::vec3(0.2f, 0.95f, 0.2f)}) {
    const glm::vec3 lamp = glm::normalize(towards), x = formula::anyTangent(lamp), y = glm::cross(lamp, x);
    Estimate light;
    for (std::uint32_t i = 0; i < 50000; ++i) {
      SampleSequence samples(18, i);
      const glm::vec2 u = samples.next();
      const float z = 1.0f - u.x * (1.0f - kCosine), radius = std::sqrt(1.0f - z * z);
      const glm::vec3 l =
          z * lamp + radius * (std::cos(formula::kTwoPi * u.y) * x + std::sin(formula::kTwoPi * u.y) * y);
      const auto [direct, next, enters] = bsdf.scatter(directionOf(0.6f), {l, pdf}, samples);
      const bool finds = next && glm::dot(next->direction, lamp) > kCosine;
      light.add(double(direct.y + (finds ? next->weight.y * balanceHeuristic(next->pdf, pdf) : 0.0f)));
    }
    EXPECT_LT(light.error() * std::sqrt(light.count), 2.5 * light.mean()) << lamp.x;
  }
}

// What a thin wall lets through goes straight on, and as far to the sides as what it reflects.
TEST(Bsdf, AThinWallDoesNotRefract) {
  const Bsdf pane = {glass(0.0f), {.ior = 1.5f, .is_thin = true}};
  bool has_passed = false;
  for (std::uint32_t i = 0; i < 64; ++i) {
    SampleSequence samples(0, i);
    const auto sample = sampled(pane, directionOf(0.5f), samples);
    ASSERT_TRUE(sample);
    if (!sample->is_refracted) continue;
    has_passed = true;
    EXPECT_NEAR(glm::distance(sample->direction, -directionOf(0.5f)), 0.0f, 1e-6f);
  }
  EXPECT_TRUE(has_passed);
  // Of narrow facets, hardly any send light to and fro.
  const Bsdf rough = {glass(0.2f), {.ior = 1.5f, .is_thin = true}};
  const glm::vec3 v = directionOf(0.7f), reflected = glm::normalize(glm::vec3(-0.7f, 0.05f, 0.72f));
  Estimate through, back;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    SampleSequence samples(14, i);
    back.add(double(evaluated(rough, v, reflected, samples)));
    through.add(double(evaluated(rough, v, {reflected.x, reflected.y, -reflected.z}, samples)));
  }
  const double fresnel = double(formula::fresnelDielectric(glm::dot(v, glm::normalize(v + reflected)), 1.5f));
  EXPECT_NEAR(through.mean() / back.mean(), (1.0 - fresnel) / fresnel, 0.03 * (1.0 - fresnel) / fresnel);
}

// Refracted light counts for its wavelength, reflected light for all: the share of each is what Fresnel says.
TEST(Bsdf, OnlyRefractedLightHasAWavelength) {
  formula::Material diamond = glass(0.0f);
  diamond.ior = 2.4f;
  diamond.dispersion = 0.36f;
  const glm::vec3 weight(3.0f, 0.5f, -0.25f);
  glm::dvec3 refracted(0.0), reflected(0.0);
  constexpr int kPaths = 20000;
  for (std::uint32_t i = 0; i < kPaths; ++i) {
    SampleSequence samples(16, i);
    const auto sample = Bsdf(diamond, {.ior = 2.45f, .weight = weight}).scatter(directionOf(0.8f), {}, samples).next;
    (sample->is_refracted ? refracted : reflected) += glm::dvec3(sample->weight) / double(kPaths);
  }
  for (int channel = 0; channel < 3; ++channel) {
    const float passes = 1.0f - formula::fresnelDielectric(0.8f, 2.45f);
    EXPECT_NEAR(refracted[channel], passes * weight[channel], 0.01 * std::abs(weight[channel])) << channel;
    const float ior = formula::iorOfChannels(diamond.ior, diamond.dispersion)[channel];
    EXPECT_NEAR(reflected[channel], formula::fresnelDielectric(0.8f, ior), 0.01) << channel;
  }
}

TEST(Bsdf, ASmoothMirrorHasOneDirection) {
  SampleSequence samples(0, 0);
  const auto sample = sampled(bsdfOf(whiteMetal(0.0f)), directionOf(0.6f), samples);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->pdf, 0.0f);
  EXPECT_NEAR(glm::distance(sample->direction, glm::vec3(-0.8f, 0.0f, 0.6f)), 0.0f, 1e-6f);
  EXPECT_EQ(evaluated(bsdfOf(whiteMetal(0.0f)), directionOf(0.6f), directionOf(0.5f), samples), 0.0f);
}

}  // namespace
}  // namespace mirrorball
