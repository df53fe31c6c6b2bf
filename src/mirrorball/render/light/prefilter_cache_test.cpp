#include "mirrorball/render/light/prefilter_cache.h"

#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/image/small_float.h"
#include "mirrorball/render/light/environment_light.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class PrefilterCacheTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) / ("prefilter_cache_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return fs::exists(folder_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})) : 0;
  }

  static ImageSet cubeOfValue(float value, int side = 4) {
    ImageSet cube(1, 6);
    forEachImage(cube, [value, side](Image& image) { image = Image(side, side, 3, value); });
    return cube;
  }

  static std::string keyOfValue(float value) { return PrefilterCache::keyOf(cubeOfValue(value)); }

  fs::path folder_;
};

/// Of cubes of one level of 4².
const PrefilteredShape kShape{{4}, {4}};

/// Expects a texture's texels to be the same; its fourth channel is not asked for.
template <typename Same>
void expectSameTexels(const ImageSet& found, const ImageSet& expected, Same&& same) {
  ASSERT_EQ(found.levels(), expected.levels());
  for (int level = 0; level < expected.levels(); ++level)
    for (int face = 0; face < 6; ++face) {
      const Image& image = expected.at(level, face);
      ASSERT_EQ(found.at(level, face).width(), image.width());
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          for (int c = 0; c < 3; ++c)
            ASSERT_EQ(found.at(level, face).texel(x, y)[c], same(image.texel(x, y)[c])) << "level " << level;
    }
}

/// A lamp of that radiance in soft light.
Environment roomWithLamp(float lamp) {
  return Environment(panoramaOf(128, 64, [lamp](glm::vec3 d) {
    return glm::dot(d, glm::vec3(0.6f, 0.48f, 0.64f)) > 0.98f ? glm::vec3(lamp) : 1.5f + d;
  }));
}

TEST_F(PrefilterCacheTest, FindsWhatWasKeptForTheSameCube) {
  const PrefilterCache cache{CacheFolder(folder_)};
  EXPECT_FALSE(cache.find(keyOfValue(1.0f), kShape));
  cache.keep(keyOfValue(1.0f), {cubeOfValue(0.25f), cubeOfValue(0.5f)}, TexelFormat::half);
  const auto found = cache.find(keyOfValue(1.0f), kShape);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->chain.at(0, 3).texel(1, 2)[0], 0.25f);
  EXPECT_EQ(found->irradiance.at(0, 5).texel(3, 3)[2], 0.5f);
  EXPECT_FALSE(cache.find(keyOfValue(1.0000001f), kShape));
}

TEST_F(PrefilterCacheTest, KeepsLightThatHalfFloatsDoNotHold) {
  const PrefilterCache cache{CacheFolder(folder_)};
  cache.keep(keyOfValue(2.0f), {cubeOfValue(1e5f), cubeOfValue(0.1f)}, TexelFormat::float32);
  const auto found = cache.find(keyOfValue(2.0f), kShape);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->chain.at(0, 0).texel(0, 0)[0], 1e5f);
  EXPECT_EQ(found->irradiance.at(0, 0).texel(0, 0)[0], 0.1f);
}

TEST_F(PrefilterCacheTest, ADamagedFileIsMadeAnew) {
  const PrefilterCache cache{CacheFolder(folder_)};
  cache.keep(keyOfValue(1.0f), {cubeOfValue(0.25f), cubeOfValue(0.5f)}, TexelFormat::half);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) fs::resize_file(entry.path(), 40);
  EXPECT_FALSE(cache.find(keyOfValue(1.0f), kShape));
}

// A texel of another value is as good a texel as any: only the checksum tells.
TEST_F(PrefilterCacheTest, ADamagedTexelIsNotShown) {
  const PrefilterCache cache{CacheFolder(folder_)};
  const std::string key = keyOfValue(1.0f);
  for (const char* ending : {"-chain.ktx2", "-irradiance.ktx2"}) {
    cache.keep(key, {cubeOfValue(0.25f), cubeOfValue(0.5f)}, TexelFormat::half);
    ASSERT_TRUE(cache.find(key, kShape));
    const fs::path path = folder_ / (key + ending);
    Bytes bytes = readFile(path).value();
    bytes[bytes.size() - 200] ^= 1u;
    ASSERT_TRUE(decodeImageSet(bytes)) << "it is a texture still";
    ASSERT_TRUE(writeFile(path, bytes));
    EXPECT_FALSE(cache.find(key, kShape)) << ending;
  }
}

TEST_F(PrefilterCacheTest, AnotherShapeIsMadeAnew) {
  const PrefilterCache cache{CacheFolder(folder_)};
  const std::string key = keyOfValue(1.0f);
  cache.keep(key, {cubeOfValue(0.25f), cubeOfValue(0.5f)}, TexelFormat::half);
  EXPECT_TRUE(cache.find(key, kShape));
  EXPECT_FALSE(cache.find(key, {{8}, {4}})) << "another size of the chain";
  EXPECT_FALSE(cache.find(key, {{4}, {8}})) << "another size of the irradiance";
  EXPECT_FALSE(cache.find(key, {{4, 2}, {4}})) << "more levels";
  EXPECT_FALSE(cache.find(key, {{}, {4}})) << "fewer levels";
}

TEST_F(PrefilterCacheTest, WhatIsNotOneCubeIsMadeAnew) {
  const PrefilterCache cache{CacheFolder(folder_)};
  const std::string key = keyOfValue(1.0f);
  ImageSet several(1, 6, 2);
  forEachImage(several, [](Image& image) { image = Image(4, 4, 3, 0.25f); });
  for (const ImageSet& wrong : {ImageSet(Image(4, 4, 3, 0.25f)), several}) {
    cache.keep(key, {wrong, cubeOfValue(0.5f)}, TexelFormat::half);
    EXPECT_FALSE(cache.find(key, kShape));
  }
}

// A texture holds half floats, unless the light does not fit them; so does the cache.
TEST_F(PrefilterCacheTest, AnEnvironmentIsPreparedTheSameFromIt) {
  for (const bool needs_floats : {false, true}) {
    const Environment room = roomWithLamp(needs_floats ? 1e6f : 100.0f);
    const std::size_t before = files();
    const auto made = prepareEnvironment(room, CacheFolder(folder_));
    ASSERT_TRUE(made);
    EXPECT_EQ(made->needs_floats, needs_floats);
    EXPECT_EQ(files(), before + 2);
    const auto found = prepareEnvironment(room, CacheFolder(folder_));
    ASSERT_TRUE(found);
    const auto asInTexture = [needs_floats](float sample) {
      return needs_floats ? sample : floatFromHalf(halfFromFloat(sample));
    };
    expectSameTexels(found->prefiltered, made->prefiltered, asInTexture);
    expectSameTexels(found->irradiance, made->irradiance, asInTexture);
  }
}

TEST_F(PrefilterCacheTest, AnEnvironmentIsMadeAnewWhereFilesOfItsNameHoldAnotherShape) {
  const Environment room = roomWithLamp(100.0f);
  const auto made = prepareEnvironment(room);
  ASSERT_TRUE(made);
  const PrefilterCache cache{CacheFolder(folder_)};
  cache.keep(PrefilterCache::keyOf(made->chain), {cubeOfValue(7.0f, 64), cubeOfValue(7.0f, 16)}, TexelFormat::half);
  const auto prepared = prepareEnvironment(room, CacheFolder(folder_));
  ASSERT_TRUE(prepared);
  const auto itself = [](float sample) { return sample; };
  expectSameTexels(prepared->prefiltered, made->prefiltered, itself);
  expectSameTexels(prepared->irradiance, made->irradiance, itself);
}

// Means of smooth light under lobes are the same to 1e-4 however they are computed. Where these change, it is for
// another lobe, roughness or size of a level: raise PrefilterCache::kVersion, so that nobody is shown what was kept
// before, and write both down here.
TEST(PrefilterCacheVersion, GoesUpWithOtherValues) {
  const Environment room(panoramaOf(128, 64, [](glm::vec3 d) {
    return 1.5f + d + 100.0f * std::exp(40.0f * (glm::dot(d, glm::vec3(0.6f, 0.48f, 0.64f)) - 1.0f));
  }));
  const auto prepared = prepareEnvironment(room);
  ASSERT_TRUE(prepared);
  const ImageSet& chain = prepared->prefiltered;
  ASSERT_EQ(chain.levels(), 4);
  const float values[] = {chain.at(0, 0).texel(0, 8)[0], chain.at(1, 0).texel(0, 4)[0], chain.at(2, 0).texel(0, 2)[0],
                          chain.at(3, 0).texel(0, 1)[0], prepared->irradiance.at(0, 0).texel(0, 8)[0]};

  EXPECT_EQ(PrefilterCache::kVersion, 7u);
  const float kept[] = {51.51f, 34.95f, 16.774f, 6.610f, 6.747f};
  for (std::size_t i = 0; i < std::size(values); ++i) EXPECT_NEAR(values[i], kept[i], 3e-3f * kept[i]) << i;
}

}  // namespace
}  // namespace mirrorball
