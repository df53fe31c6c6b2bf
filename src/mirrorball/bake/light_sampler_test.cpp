#include "mirrorball/bake/light_sampler.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "chi_squared.h"
#include "formula/constants.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

/// A sun of 10⁵ and half a degree, beside 1.
Environment sunlit() {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.3f, 0.8f, -0.5f));
  return Environment([=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > std::cos(0.00436f) ? 1e5f : 1.0f); }, 1024);
}

double meanOf(const Environment& environment, const LightSampler& sampler, std::uint32_t count, double& error) {
  double sum = 0.0, squares = 0.0;
  const auto side = static_cast<std::uint32_t>(std::sqrt(double(count)));
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const LightSample sample = sampler.sample((glm::vec2(i, j) + 0.5f) / float(side));
      const double value = double(environment.radiance(sample.direction).y / sample.pdf);
      sum += value;
      squares += value * value;
    }
  const double n = double(side) * double(side);
  error = std::sqrt(std::max(squares / n - sum / n * (sum / n), 0.0) / n);
  return sum / n;
}

// The light of all directions, of which the sun's 6e-5 sr are a third.
TEST(LightSampler, FindsASmallSun) {
  const Environment environment = sunlit();
  const LightSampler sampler = *LightSampler::make(environment);
  double error = 0.0;
  const double sphere = 4.0 * double(formula::kPi);
  const double sun = 1e5 * 2.0 * double(formula::kPi) * (1.0 - std::cos(0.00436));
  EXPECT_NEAR(meanOf(environment, sampler, 1 << 16, error), sphere + sun, 0.02 * (sphere + sun));
  EXPECT_LT(error, 0.01 * (sphere + sun)) << "a choice without the light would be 300 times as noisy";
}

TEST(LightSampler, TakesWhatRoundingMadeOne) {
  for (const int size : {1, 2, 64}) {
    const LightSampler sampler = *LightSampler::make(Environment(testing::smoothRadiance, 64), {}, size);
    for (const glm::vec2 u : {glm::vec2(1.0f), glm::vec2(1.0f, 0.3f), glm::vec2(0.0f, 1.0f), glm::vec2(0.0f)}) {
      const LightSample sample = sampler.sample(u);
      EXPECT_NEAR(glm::length(sample.direction), 1.0f, 1e-5f);
      EXPECT_GT(sample.pdf, 0.0f);
    }
  }
}

// The density of a direction is that with which it was chosen.
TEST(LightSampler, DensitiesAgree) {
  for (const Environment& environment :
       {sunlit(), Environment(testing::smoothRadiance, 64), *builtinEnvironment("sky")}) {
    const LightSampler sampler = *LightSampler::make(environment);
    int differ = 0;
    for (int i = 0; i < 4096; ++i) {
      const LightSample sample = sampler.sample((glm::vec2(i % 64, i / 64) + 0.37f) / 64.0f);
      EXPECT_NEAR(glm::length(sample.direction), 1.0f, 1e-5f);
      differ += std::abs(sampler.pdf(sample.direction) - sample.pdf) > 1e-3f * sample.pdf ? 1 : 0;
    }
    EXPECT_LE(differ, 4) << "only what rounding puts into the next texel";
  }
}

// As many directions fall into each part of the sphere as the density says.
TEST(LightSampler, DirectionsAreDrawnByTheirDensity) {
  constexpr int kBins = 16, kPlaces = 128, kDrawn = 200000;
  for (const Environment& environment :
       {sunlit(), Environment(testing::smoothRadiance, 64), *builtinEnvironment("sky")}) {
    const LightSampler sampler = *LightSampler::make(environment);
    std::vector<double> counted(kBins * kBins, 0.0), expected(kBins * kBins, 0.0);
    constexpr int kSide = kBins * kPlaces;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / float(kSide);
        expected[std::size_t(y / kPlaces * kBins + x / kPlaces)] +=
            double(sampler.pdf(directionAt(Projection::equal_area, {0, uv}))) * 4.0 * double(formula::kPi) / kSide /
            kSide * kDrawn;
      }
    std::mt19937 generator(3);
    const auto number = [&] { return float(generator() >> 8) * 0x1p-24f; };
    for (std::uint32_t i = 0; i < kDrawn; ++i) {
      const glm::vec2 u{number(), number()};
      const glm::ivec2 bin(positionOf(Projection::equal_area, sampler.sample(u).direction).uv * float(kBins));
      counted[std::size_t(std::min(bin.y, kBins - 1) * kBins + std::min(bin.x, kBins - 1))] += 1.0;
    }
    testing::expectCounts(counted, expected, "light");
  }
}

TEST(LightSampler, BlackLightIsChosenUniformly) {
  const LightSampler sampler = *LightSampler::make(Environment([](glm::vec3) { return glm::vec3(0.0f); }, 16));
  EXPECT_NEAR(sampler.pdf({0, 1, 0}), 1.0f / (4.0f * formula::kPi), 1e-4f);
  EXPECT_NEAR(sampler.sample({0.3f, 0.7f}).pdf, 1.0f / (4.0f * formula::kPi), 1e-4f);
}

}  // namespace
}  // namespace mirrorball
