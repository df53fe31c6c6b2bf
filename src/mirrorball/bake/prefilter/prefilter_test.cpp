#include "mirrorball/bake/prefilter/prefilter.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/prefilter.h"
#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/base/range.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

constexpr int kRows = 192;  // enough for the narrowest lobe of a chain of 64²: 2.5 / 0.018

TEST(Prefilter, AWhiteFurnaceIsWhiteOnEveryLevel) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 64);
  for (const Projection projection : {Projection::equirect, Projection::cube, Projection::octahedral}) {
    const EnvironmentMap map = *convert(white, projection, 128);
    const ImageSet chain = chainOf(map, 64);
    for (int level = 0; level < chain.levels(); ++level)
      for (int face = 0; face < 6; ++face)
        for (const float sample : chain.at(level, face).samples())
          ASSERT_NEAR(sample, 1.0f, 1e-5f) << nameOf(projection) << " level " << level << " face " << face;
  }
}

TEST(Prefilter, LevelZeroIsTheEnvironmentItself) {
  const EnvironmentMap panorama = panoramaOf(2 * kRows, kRows, landscape);
  const ImageSet chain = chainOf(panorama, 64);
  const EnvironmentMap cube = *convert(Environment(panorama), Projection::cube, 64);
  for (int face = 0; face < 6; ++face) EXPECT_TRUE(areEqual(chain.at(0, face).samples(), cube.face(face).samples()));
}

TEST(Prefilter, AnyNumberOfThreadsGivesTheSameBits) {
  const EnvironmentMap panorama = panoramaOf(2 * kRows, kRows, landscapeWithSun);
  const ImageSet chain = chainOf(panorama, 64);
  const testing::OneThread one_thread;
  const ImageSet again = chainOf(panorama, 64);
  for (int level = 0; level < chain.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      EXPECT_TRUE(areEqual(chain.at(level, face).samples(), again.at(level, face).samples()));
}

// A cube and an octahedron that sample the same light as a panorama: a soft lamp in a gradient.
TEST(Prefilter, OtherProjectionsAgreeWithAPanorama) {
  const glm::vec3 lamp = glm::normalize(glm::vec3(0.4f, 0.7f, -0.5f));
  const auto radiance = [lamp](glm::vec3 d) {
    return glm::vec3(1.0f + 0.5f * d.x * d.y) + 500.0f * std::exp(-500.0f * (1.0f - glm::dot(d, lamp)));
  };
  const Environment light(radiance, 256);
  const ImageSet expected = chainOf(*convert(light, Projection::equirect, 512), 32);
  for (const Projection projection : {Projection::cube, Projection::octahedral}) {
    const ImageSet chain = chainOf(*convert(light, projection, projection == Projection::cube ? 256 : 512), 32);
    for (int level = 1; level < chain.levels(); ++level)
      for (int face = 0; face < 6; ++face)
        for (std::size_t i = 0; i < chain.at(level, face).samples().size(); ++i) {
          const float truth = expected.at(level, face).samples()[i];
          ASSERT_NEAR(chain.at(level, face).samples()[i], truth, 2e-3f * truth)
              << nameOf(projection) << " level " << level;
        }
  }
}

TEST(Prefilter, ABlackMapIsBlack) {
  const ImageSet chain = chainOf(panoramaOf(128, 64, [](glm::vec3) { return glm::vec3(0.0f); }), 32);
  for (int level = 0; level < chain.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      for (const float sample : chain.at(level, face).samples()) ASSERT_EQ(sample, 0.0f);
}

TEST(Prefilter, ASunOfOneTexelOnBlackIsItsLobe) {
  EnvironmentMap map = panoramaOf(512, 256, [](glm::vec3) { return glm::vec3(0.0f); });
  for (int c = 0; c < 3; ++c) map.face(0).texel(100, 60)[c] = 1e5f;
  const ImageSet chain = chainOf(map, 64);
  for (int level = 1; level < chain.levels(); ++level) {
    const double roughness = static_cast<double>(roughnessOfLevel(MipMapping::filament, level, 4, 64));
    const int size = chain.at(level, 0).width();
    for (int face = 0; face < 6; ++face)
      for (int x = 0; x < size; x += 3) {
        const glm::vec3 d =
            directionAt(Projection::cube, {face, {(float(x) + 0.5f) / float(size), 0.5f + 0.5f / float(size)}});
        const double truth = meanOfTexels(map, ggxKernel(roughness), d).x;
        const auto found = static_cast<double>(rgbAt(chain.at(level, face), x, size / 2).x);
        EXPECT_NEAR(found, truth, 2e-4 * truth + 1e-5) << "level " << level;
        EXPECT_GE(found, 0.0);
      }
  }
}

// A map of very few texels is what lies between them, seen smoothly: no spots where its texels are.
TEST(Prefilter, AMapOfVeryFewTexelsIsTakenAsSmoothLight) {
  const Environment light([](glm::vec3 d) { return d.x > 0.0f ? glm::vec3(3.0f, 1.0f, 0.0f) : glm::vec3(1.0f); }, 1);
  for (const Projection projection :
       {Projection::equirect, Projection::cube, Projection::octahedral, Projection::equal_area}) {
    const ImageSet chain = chainOf(*convert(light, projection, 1), 32);
    for (int level = 0; level < chain.levels(); ++level)
      for (int face = 0; face < 6; ++face)
        for (const float sample : chain.at(level, face).samples()) {
          ASSERT_GE(sample, 0.0f) << nameOf(projection);
          ASSERT_LE(sample, 3.5f) << nameOf(projection);
        }
  }
}

/// ∫ of one level of a chain over the sphere.
double fluxOf(const ImageSet& chain, int level) {
  const int size = chain.at(level, 0).width();
  double flux = 0.0;
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        flux += static_cast<double>(rgbAt(chain.at(level, face), x, y).x *
                                    texelSolidAngle(Projection::cube, {size, size}, {x, y}));
  return flux;
}

// Whether or not the map has enough texels for the narrowest lobe.
TEST(Prefilter, ASunOfOneTexelOfACubeKeepsItsFlux) {
  for (const int size : {32, 64, 100, 256})
    for (const glm::ivec2 place : {glm::ivec2(size / 2, size / 3), glm::ivec2(size - 1, 1)}) {
      ImageSet faces(1, 6);
      forEachImage(faces, [size](Image& image) { image = Image(size, size, 3, 0.0f); });
      for (int c = 0; c < 3; ++c) faces.at(0, 2).texel(place.x, place.y)[c] = 1e4f;
      const EnvironmentMap map(Projection::cube, std::move(faces));
      const double flux = static_cast<double>(1e4f * texelSolidAngle(Projection::cube, {size, size}, place));
      const ImageSet chain = chainOf(map, 128);
      // The sums over so few texels of a level are not integrals of its narrow lobes.
      for (int level = 3; level < chain.levels(); ++level)
        EXPECT_NEAR(fluxOf(chain, level), flux, 0.03 * flux) << size << " level " << level;
    }
}

TEST(Prefilter, SizesThatAreNoPowersOfTwoHaveAllLevels) {
  const EnvironmentMap panorama = panoramaOf(2 * kRows, kRows, landscape);
  for (const int size : {1, 3, 7, 8, 100}) {
    const ImageSet chain = chainOf(panorama, size);
    ASSERT_EQ(chain.levels(), lastLevel(size) + 1) << size;
    EXPECT_EQ(chain.at(chain.levels() - 1, 5).width(), levelSide(size, lastLevel(size))) << size;
  }
}

/// Stops whatever it is told the progress of once half of the steps are done, and counts how often it is asked after.
class StopHalfway {
 public:
  ProgressFunction progress() {
    return [this](std::size_t done, std::size_t total) {
      if (is_told_) ++asked_after_;
      if (2 * done >= total) is_told_ = true;
      return !is_told_;
    };
  }
  bool isTold() const { return is_told_; }
  int askedAfter() const { return asked_after_; }

 private:
  std::atomic<bool> is_told_ = false;
  std::atomic<int> asked_after_ = 0;
};

/// `work(progress)` fails as it should, and soon after it was told to.
template <typename Work>
void expectToStop(const Work& work) {
  StopHalfway stop;
  const auto stopped = work(stop.progress());
  EXPECT_TRUE(stop.isTold());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  // What other threads, or the other orders of a piece, were about before.
  EXPECT_LE(stop.askedAfter(), 64);
}

TEST(Prefilter, StopsWhenItIsTold) {
  const Environment sky = *builtinEnvironment("sky");
  const std::vector<PrefilterLevel> levels = prefilterLevels({.size = 32});
  const std::vector<Lobe> lobes = lobesOf(levels);
  expectToStop([&](const ProgressFunction& progress) { return LightHarmonics::make(sky, lobes, progress); });
  const LightHarmonics light = *LightHarmonics::make(sky, lobes);
  expectToStop(
      [&](const ProgressFunction& progress) { return prefilter(sky, light, levels, glm::mat3(1.0f), progress); });
  expectToStop([&](const ProgressFunction& progress) { return light.blurred(lobes.front(), progress); });
  expectToStop(
      [&](const ProgressFunction& progress) { return cubeOf(light, lobes.front(), 64, glm::mat3(1.0f), progress); });
}

TEST(Prefilter, TellsItsProgressToTheEnd) {
  const Environment sky = *builtinEnvironment("sky");
  const std::vector<PrefilterLevel> levels = prefilterLevels({.size = 32});
  std::atomic<std::size_t> max = 0;
  std::atomic<std::size_t> all = 0;
  const ProgressFunction progress = [&](std::size_t done, std::size_t total) {
    for (std::size_t before = max; before < done && !max.compare_exchange_weak(before, done);) continue;
    all = total;
    return true;
  };
  const LightHarmonics light = *LightHarmonics::make(sky, lobesOf(levels), progress);
  EXPECT_EQ(max, all);
  max = 0;
  ASSERT_TRUE(prefilter(sky, light, levels, glm::mat3(1.0f), progress));
  EXPECT_EQ(max, all);
}

TEST(MipMappings, EndAtRoughnessOneAndGrow) {
  for (const MipMapping mapping : {MipMapping::filament, MipMapping::linear, MipMapping::unreal, MipMapping::unity,
                                   MipMapping::frostbite, MipMapping::gltf}) {
    float before = 0.0f;
    for (int level = 1; level <= 6; ++level) {
      const float roughness = roughnessOfLevel(mapping, level, 6, 256);
      EXPECT_GT(roughness, before);
      before = roughness;
    }
    EXPECT_FLOAT_EQ(before, 1.0f);
  }
}

TEST(MipMappings, AreTheInversesOfWhatEnginesLookUp) {
  for (int level = 1; level <= 6; ++level) {
    const auto lod = static_cast<float>(level);
    const auto r = [level](MipMapping mapping) { return roughnessOfLevel(mapping, level, 6, 256); };
    EXPECT_NEAR(formula::lodOfRoughness(r(MipMapping::filament), 6.0f), lod, 1e-5f);
    EXPECT_NEAR(6.0f * r(MipMapping::linear), lod, 1e-5f);
    EXPECT_NEAR(6.0f + 1.2f * std::log2(r(MipMapping::unreal)), lod, 1e-5f);
    EXPECT_NEAR(6.0f * r(MipMapping::unity) * (1.7f - 0.7f * r(MipMapping::unity)), lod, 1e-5f);
    EXPECT_NEAR(6.0f * std::sqrt(r(MipMapping::frostbite)), lod, 1e-5f);
    const auto alpha = [&](MipMapping mapping) { return r(mapping) * r(mapping); };
    EXPECT_NEAR(0.8f * std::log2(256.0f * alpha(MipMapping::babylon)), lod, 1e-5f);
    // Babylon.js' glTF loader makes the scale of its logarithm fit the number of levels.
    EXPECT_NEAR(6.0f / std::log2(256.0f) * std::log2(256.0f * alpha(MipMapping::gltf)), lod, 1e-5f);
  }
}

}  // namespace
}  // namespace mirrorball
