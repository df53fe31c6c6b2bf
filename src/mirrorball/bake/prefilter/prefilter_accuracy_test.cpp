// Prefiltered maps against the truth: sums over all texels, in double, of lobes that are written anew.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/bake/prefilter/prefilter_testing.h"

namespace mirrorball {
namespace {

constexpr int kPanoramaRows = 192;  // enough for the narrowest lobe of a chain of 64²: 2.5 / 0.018

struct Error {
  double mean = 0.0;
  double max = 0.0;
};

/// Relative, of all channels, over 72 texels of a cube: a corner, an edge, the middle and scattered ones of each face.
Error errorOfCube(const EnvironmentMap& panorama, const ImageSet& cube, int level, const LobeKernel& kernel) {
  const int size = cube.at(level, 0).width();
  std::mt19937 random(static_cast<unsigned>(level));
  Error error;
  int count = 0;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < 12; ++i) {
      const glm::ivec2 texel = i == 0   ? glm::ivec2(0)
                               : i == 1 ? glm::ivec2(size - 1, size / 2)
                               : i == 2 ? glm::ivec2(size / 2)
                                        : glm::ivec2(random() % unsigned(size), random() % unsigned(size));
      const glm::vec3 direction =
          directionAt(Projection::cube, {face, (glm::vec2(texel) + 0.5f) / static_cast<float>(size)});
      const glm::dvec3 truth = meanOfTexels(panorama, kernel, direction);
      const glm::dvec3 found(rgbAt(cube.at(level, face), texel.x, texel.y));
      for (int c = 0; c < 3; ++c) {
        const double relative = std::abs(found[c] - truth[c]) / truth[c];
        error.mean += relative;
        error.max = std::max(error.max, relative);
        ++count;
      }
    }
  error.mean /= count;
  return error;
}

glm::vec3 softboxInADarkRoom(glm::vec3 d) {
  const bool is_lamp = d.z > 0.0f && std::abs(d.x) < 0.2f * d.z && std::abs(d.y) < 0.3f * d.z;
  return is_lamp ? glm::vec3(50.0f, 40.0f, 45.0f) : glm::vec3(0.02f, 0.01f, 0.03f);
}

/// More texels than are taken for points of light.
glm::vec3 windowInADarkRoom(glm::vec3 d) {
  const bool is_window = d.z > 0.0f && std::abs(d.x) < 0.6f * d.z && std::abs(d.y) < 0.6f * d.z;
  return is_window ? glm::vec3(50.0f, 40.0f, 45.0f) : glm::vec3(0.02f, 0.01f, 0.03f);
}

glm::vec3 sunAtTheZenith(glm::vec3 d) { return landscape(d) + (d.y > 0.9998f ? glm::vec3(1e5f) : glm::vec3(0.0f)); }

glm::vec3 horizon(glm::vec3 d) { return d.y > 0.0f ? glm::vec3(1.0f, 0.8f, 0.9f) : glm::vec3(1.0f / 64.0f); }

/// One row of texels.
glm::vec3 brightRing(glm::vec3 d) {
  return std::abs(d.y - 0.3f) < 0.008f ? glm::vec3(256.0f, 200.0f, 100.0f) : glm::vec3(0.05f);
}

/// Six hundred texels alike, and all else so dark that the rounding of floats would be seen.
glm::vec3 brightDisc(glm::vec3 d) {
  const glm::vec3 middle = glm::normalize(glm::vec3(-0.5f, 0.3f, 0.6f));
  return glm::distance(d, middle) < 0.2f ? glm::vec3(6e4f, 5e4f, 4e4f) : glm::vec3(0.5f);
}

// Five times better in the mean than asked for and twice at most, even around a lamp in the dark.
constexpr Error kLimitOfGgx = {4e-4, 5e-3};

// Others have no long tail that would hide errors beside a lamp some thousand times as bright.
constexpr Error kLimit = {2e-3, 1e-2};

struct Light {
  const char* name;
  glm::vec3 (*at)(glm::vec3);
  // A ring along the horizon that ends there in an edge, whose bands fall slowly.
  Error limit_of_charlie = kLimit;
};

struct Reflection {
  const char* name;
  Distribution distribution;
  LobeKernel (*kernel)(double perceptual_roughness);
};

class PrefilterAccuracy : public ::testing::TestWithParam<std::tuple<Light, Reflection>> {};

TEST_P(PrefilterAccuracy, EveryLevelIsTheSumOverAllTexels) {
  const auto& [light, reflection] = GetParam();
  const Error limit = reflection.distribution == Distribution::ggx       ? kLimitOfGgx
                      : reflection.distribution == Distribution::charlie ? light.limit_of_charlie
                                                                         : kLimit;
  const EnvironmentMap panorama = panoramaOf(2 * kPanoramaRows, kPanoramaRows, light.at);
  const PrefilterOptions options{.size = 64, .distribution = reflection.distribution};
  const std::vector<PrefilterLevel> levels = prefilterLevels(options);
  const ImageSet chain = chainOf(Environment(panorama), options);
  ASSERT_EQ(chain.levels(), 5);
  for (int level = 1; level < chain.levels(); ++level) {
    const auto roughness = static_cast<double>(levels[std::size_t(level)].perceptual_roughness);
    const Error error = errorOfCube(panorama, chain, level, reflection.kernel(roughness));
    EXPECT_LT(error.mean, limit.mean) << "level " << level;
    EXPECT_LT(error.max, limit.max) << "level " << level;
  }
}

constexpr Light kLights[] = {{"Landscape", landscape},           {"Sun", landscapeWithSun},
                             {"Softbox", softboxInADarkRoom},    {"Window", windowInADarkRoom, {4e-3, 4e-2}},
                             {"SunAtTheZenith", sunAtTheZenith}, {"Horizon", horizon},
                             {"BrightRing", brightRing},         {"BrightDisc", brightDisc, {2e-3, 7e-2}}};
constexpr Reflection kReflections[] = {{"Ggx", Distribution::ggx, ggxKernel},
                                       {"Phong", Distribution::phong, phongKernel},
                                       {"Blinn", Distribution::blinn, blinnKernel},
                                       {"Charlie", Distribution::charlie, charlieKernel}};

INSTANTIATE_TEST_SUITE_P(Maps, PrefilterAccuracy,
                         ::testing::Combine(::testing::ValuesIn(kLights), ::testing::ValuesIn(kReflections)),
                         [](const auto& test) {
                           return std::string(std::get<Reflection>(test.param).name) + std::get<Light>(test.param).name;
                         });

// What repeats itself every few texels has all its light in a few bands, beyond those that noise of that strength would
// ask for.
class RegularDetail : public ::testing::TestWithParam<Light> {};

TEST_P(RegularDetail, OfASmoothLevelIsTheSumOverAllTexels) {
  const EnvironmentMap panorama = panoramaOf(2048, 1024, GetParam().at);
  const PrefilterOptions options{.size = 256};
  const auto roughness = static_cast<double>(prefilterLevels(options)[1].perceptual_roughness);
  const Error error = errorOfCube(panorama, chainOf(Environment(panorama), options), 1, ggxKernel(roughness));
  EXPECT_LT(error.mean, kLimit.mean);
  EXPECT_LT(error.max, kLimit.max);
}

float longitudeOf(glm::vec3 d) { return std::atan2(d.x, -d.z); }

glm::vec3 grating(glm::vec3 d) { return glm::vec3(1.0f + 0.95f * std::cos(200.0f * longitudeOf(d))); }

glm::vec3 rings(glm::vec3 d) { return glm::vec3(1.0f + 0.95f * std::sin(300.0f * std::acos(d.y))); }

glm::vec3 windowWithBlinds(glm::vec3 d) {
  const bool is_window = d.z > 0.0f && std::abs(d.x) < 0.3f * d.z && std::abs(d.y) < 0.3f * d.z;
  if (!is_window) return glm::vec3(1.0f);
  return glm::vec3(std::fmod((d.y + 1.0f) * 200.0f, 2.0f) < 1.0f ? 3.0f : 0.3f);
}

/// Each dot bright in the dark, so close together that all that is left of them lies in bands just left out.
glm::vec3 dots(glm::vec3 d) {
  const float across = 0.5f + 0.5f * std::cos(390.0f * longitudeOf(d));
  const float down = 0.5f + 0.5f * std::cos(390.0f * std::acos(d.y));
  return glm::vec3(0.01f + std::pow(across * down, 8.0f));
}

INSTANTIATE_TEST_SUITE_P(Maps, RegularDetail,
                         ::testing::Values(Light{"Grating", grating}, Light{"Rings", rings}, Light{"Dots", dots},
                                           Light{"WindowWithBlinds", windowWithBlinds}),
                         [](const auto& test) { return std::string(test.param.name); });

class IrradianceAccuracy : public ::testing::TestWithParam<Light> {};

TEST_P(IrradianceAccuracy, IsTheSumOverAllTexels) {
  const EnvironmentMap panorama = panoramaOf(2 * kPanoramaRows, kPanoramaRows, GetParam().at);
  const ImageSet cube = irradianceCubeOf(panorama, 32);
  const Error error = errorOfCube(panorama, cube, 0, cosineKernel());
  EXPECT_LT(error.mean, 1e-3);
  EXPECT_LT(error.max, kLimit.max);
}

INSTANTIATE_TEST_SUITE_P(Maps, IrradianceAccuracy, ::testing::ValuesIn(kLights),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace mirrorball
