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

glm::vec3 directionOf(float cosine) { return {std::sqrt(1.0f - cosine * cosine), 0.0f, cosine}; }

/// A direction of equal density over the whole sphere.
glm::vec3 onSphere(glm::vec2 u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(1.0f - z * z, 0.0f));
  return {radius * std::cos(formula::kTwoPi * u.y), radius * std::sin(formula::kTwoPi * u.y), z};
}

std::optional<BsdfSample> sampled(const Bsdf& bsdf, glm::vec3 v, SampleSequence& samples) {
  return bsdf.scatter(v, {}, samples).next;
}

/// The BSDF times cosine: what an offer gives that is so likely that nothing else has a weight.
float evaluated(const Bsdf& bsdf, glm::vec3 v, glm::vec3 l, SampleSequence& samples) {
  constexpr float kCertain = 1e9f;
  return bsdf.scatter(v, {l, kCertain}, samples).offered.y * kCertain;
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
                                         {"milk glass 0.4", halfGlass(0.4f)}});

// What nothing absorbs leaves: in white light the surface is white. A walk of 64 facets at most loses less than 1e-3.
TEST(Bsdf, NothingIsLostAtAWhiteSurface) {
  for (const Case& one : kCases)
    for (const float cosine : {0.1f, 0.5f, 1.0f, -0.5f}) {
      if (cosine < 0.0f && one.material.transmission == 0.0f) continue;
      Estimate share;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        SampleSequence samples(1, i);
        const auto sample = sampled(Bsdf(one.material), directionOf(cosine), samples);
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
      const Bsdf bsdf(one.material);
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
  const Bsdf bsdf(whiteMetal(0.7f));
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
  const Bsdf bsdf(material);
  const float alpha = 0.25f;
  const glm::vec3 v = directionOf(0.8f);
  for (const glm::vec3 l : {glm::vec3(-0.6f, 0.0f, 0.8f), glm::normalize(glm::vec3(-0.2f, 0.3f, 0.9f))}) {
    Estimate value;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      SampleSequence samples(6, i);
      value.add(double(evaluated(bsdf, v, l, samples)));
    }
    const double expected = double(formula::evalGgx(alpha, v, l) * l.z * kReflectance);
    EXPECT_NEAR(value.mean(), expected, 2e-3 * expected + 4.0 * value.error());
  }
}

// Light from all sides is offered and found by the path, each with its weight: together all of it, and no path has much
// more than its part, however narrow the lobe is.
TEST(Bsdf, OfferedAndFoundLightAreBalanced) {
  const float uniform = 1.0f / (4.0f * formula::kPi);
  for (const Case& one : kCases)
    for (const float cosine : {0.03f, 0.3f, 0.9f}) {
      Estimate light;
      float max = 0.0f;
      for (std::uint32_t i = 0; i < 20000; ++i) {
        SampleSequence samples(8, i);
        const glm::vec3 l = onSphere(samples.next());
        const auto [offered, next] = Bsdf(one.material).scatter(directionOf(cosine), {l, uniform}, samples);
        const float found = !next ? 0.0f : next->weight.y * (next->pdf > 0.0f ? balanced(next->pdf, uniform) : 1.0f);
        light.add(double(offered.y + found));
        max = std::max(max, offered.y + found);
      }
      EXPECT_NEAR(light.mean(), 1.0, 1e-3 + 4.0 * light.error()) << one.name << ", n.v = " << cosine;
      EXPECT_LT(max, 8.0f) << one.name << ", n.v = " << cosine;
    }
}

TEST(Bsdf, ASmoothMirrorHasOneDirection) {
  SampleSequence samples(0, 0);
  const auto sample = sampled(Bsdf(whiteMetal(0.0f)), directionOf(0.6f), samples);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->pdf, 0.0f);
  EXPECT_NEAR(glm::distance(sample->direction, glm::vec3(-0.8f, 0.0f, 0.6f)), 0.0f, 1e-6f);
  EXPECT_EQ(evaluated(Bsdf(whiteMetal(0.0f)), directionOf(0.6f), directionOf(0.5f), samples), 0.0f);
}

}  // namespace
}  // namespace mirrorball
