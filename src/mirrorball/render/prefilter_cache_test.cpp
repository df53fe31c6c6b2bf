#include "mirrorball/render/prefilter_cache.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/environment/builtin.h"
#include "mirrorball/environment/convert.h"
#include "mirrorball/render/environment_light.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class PrefilterCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("prefilter_cache_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return fs::exists(folder_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})) : 0;
  }

  static ImageSet cubeOfValue(float value) {
    ImageSet cube(1, 6);
    forEachImage(cube, [value](Image& image) { image = Image(4, 4, 3, value); });
    return cube;
  }

  fs::path folder_;
};

TEST_F(PrefilterCacheTest, FindsWhatWasKeptForTheSameCube) {
  const PrefilterCache cache(folder_);
  const ImageSet cube = cubeOfValue(1.0f);
  EXPECT_FALSE(cache.find(cube));
  cache.keep(cube, {cubeOfValue(0.25f), cubeOfValue(0.5f)});
  const auto found = cache.find(cube);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->chain.at(0, 3).texel(1, 2)[0], 0.25f);
  EXPECT_EQ(found->irradiance.at(0, 5).texel(3, 3)[2], 0.5f);
  EXPECT_FALSE(cache.find(cubeOfValue(1.0000001f)));
}

TEST_F(PrefilterCacheTest, KeepsLightThatHalfFloatsDoNotHold) {
  const PrefilterCache cache(folder_);
  cache.keep(cubeOfValue(2.0f), {cubeOfValue(1e5f), cubeOfValue(0.5f)});
  const auto found = cache.find(cubeOfValue(2.0f));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->chain.at(0, 0).texel(0, 0)[0], 1e5f);
}

TEST_F(PrefilterCacheTest, ADamagedFileIsMadeAnew) {
  const PrefilterCache cache(folder_);
  cache.keep(cubeOfValue(1.0f), {cubeOfValue(0.25f), cubeOfValue(0.5f)});
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) fs::resize_file(entry.path(), 40);
  EXPECT_FALSE(cache.find(cubeOfValue(1.0f)));
}

TEST_F(PrefilterCacheTest, AFolderThatCannotBeMadeDoesNoHarm) {
  std::ofstream(folder_) << "a file";
  const PrefilterCache cache(folder_ / "below");
  cache.keep(cubeOfValue(1.0f), {cubeOfValue(0.25f), cubeOfValue(0.5f)});
  EXPECT_FALSE(cache.find(cubeOfValue(1.0f)));
}

TEST_F(PrefilterCacheTest, WhatWasNotUsedForLongestIsDroppedAndNothingElse) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "mine.ktx2") << std::string(5000, 'x');
  const PrefilterCache cache(folder_, 4000);  // about one cube of 4² and its irradiance
  for (const float value : {1.0f, 2.0f, 3.0f}) {
    cache.keep(cubeOfValue(value), {cubeOfValue(value), cubeOfValue(value)});
    fs::last_write_time(folder_ / "mine.ktx2", fs::file_time_type::min());
  }
  EXPECT_TRUE(cache.find(cubeOfValue(3.0f)));
  EXPECT_FALSE(cache.find(cubeOfValue(1.0f)));
  EXPECT_TRUE(fs::exists(folder_ / "mine.ktx2"));
}

TEST_F(PrefilterCacheTest, AnEnvironmentIsPreparedTheSameFromIt) {
  const Environment sky = *builtinEnvironment("sky");
  const EnvironmentMap map = *convert(sky, Projection::equirect, 64);
  const auto made = prepareEnvironment(Environment(map), PrefilterCache(folder_));
  ASSERT_TRUE(made);
  EXPECT_EQ(files(), 2u);
  const auto found = prepareEnvironment(Environment(map), PrefilterCache(folder_));
  ASSERT_TRUE(found);
  for (int level = 0; level < made->prefiltered.levels(); ++level)
    for (int face = 0; face < 6; ++face) {
      // The fourth channel of a texture's texels is not asked for.
      const Image& expected = made->prefiltered.at(level, face);
      const Image& image = found->prefiltered.at(level, face);
      for (int y = 0; y < expected.height(); ++y)
        for (int x = 0; x < expected.width(); ++x)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(image.texel(x, y)[c], expected.texel(x, y)[c], 1e-3f * expected.texel(x, y)[c]);
    }
}

}  // namespace
}  // namespace mirrorball
