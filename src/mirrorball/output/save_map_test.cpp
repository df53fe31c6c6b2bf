#include "mirrorball/output/save_map.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/bake/bake.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/output/output_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using SaveMapTest = testing::InFolder;

EnvironmentMap smoothCube() { return *convert(Environment(testing::smoothRadiance, 64), Projection::cube, 16); }

EnvironmentMap brightCube(float radiance) {
  return *convert(Environment([=](glm::vec3) { return glm::vec3(radiance); }, 8), Projection::cube, 8);
}

TEST_F(SaveMapTest, WhatIsSavedIsLoadedAsTheSameMap) {
  for (const char* name : {"a.exr", "a.ktx2", "a.dds", "a.ktx"}) {
    const auto saved = saveMap(path(name), smoothCube());
    ASSERT_TRUE(saved) << saved.error().message;
    EXPECT_THAT(saved->paths, ElementsAre(path(name)));
    EXPECT_THAT(saved->remarks, IsEmpty());
    const auto loaded = loadEnvironment(path(name));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->environment.map()->projection(), Projection::cube);
    EXPECT_LT(glm::distance(loaded->environment.radiance({0, 0, 1}), testing::smoothRadiance({0, 0, 1})), 0.05f);
  }
}

TEST_F(SaveMapTest, SixFilesAreNamedByTheirProgram) {
  const auto saved = saveMap(path("a.exr"), smoothCube(), {.program = "unity", .layout = CubeLayout::faces});
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->paths.size(), 6u);
  for (const std::string& file : saved->paths) EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

TEST_F(SaveMapTest, ColoursGoIntoAFileInItsPrimaries) {
  const MapFileOptions in_acescg{.format = TexelFormat::float32, .primaries = OutputPrimaries::acescg};
  ASSERT_TRUE(saveMap(path("wide.ktx2"), smoothCube(), in_acescg));
  const auto loaded = loadEnvironment(path("wide.ktx2"));
  ASSERT_TRUE(loaded);
  const EnvironmentMap cube = smoothCube();
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(loaded->environment.map()->face(3).texel(7, 5)[c], cube.face(3).texel(7, 5)[c], 1e-5f);
  const BakedMaps maps = *bake(Environment(testing::smoothRadiance, 64), {.size = 16});
  ASSERT_TRUE(saveMap(path("chain.ktx2"), maps.specular, in_acescg));
  EXPECT_NEAR(readImageSet(path("chain.ktx2"))->images.at(1, 2).texel(3, 4)[0], maps.specular.at(1, 2).texel(3, 4)[0],
              1e-5f);
  EXPECT_THAT(saveMap(path("wide.dds"), smoothCube(), {.primaries = OutputPrimaries::p3}).error().message,
              HasSubstr("cannot state other primaries"));
}

TEST_F(SaveMapTest, AChainKeepsItsLevels) {
  const BakedMaps maps = *bake(Environment(testing::smoothRadiance, 64), {.size = 16});
  const auto saved = saveMap(path("specular.ktx2"), maps.specular);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(loadEnvironment(path("specular.ktx2"))->levels, 3);
  EXPECT_THAT(saveMap(path("specular.exr"), maps.specular).error().message, HasSubstr("goes into .ktx2"));
}

// What a file does not hold is told as data, and to whoever observes.
TEST_F(SaveMapTest, RemarksAreData) {
  int told = 0;
  const Observer observer{.remark = [&](const Remark&) { ++told; }};
  const auto widened = saveMap(path("bright.ktx2"), brightCube(1e5f), {}, observer);
  ASSERT_TRUE(widened) << widened.error().message;
  ASSERT_EQ(widened->remarks.size(), 1u);
  EXPECT_EQ(widened->remarks[0].kind, RemarkKind::format_widened);
  const auto lowered = saveMap(path("lower.ktx2"), brightCube(131008.0f), {.format = TexelFormat::half}, observer);
  ASSERT_TRUE(lowered) << lowered.error().message;
  ASSERT_EQ(lowered->remarks.size(), 1u);
  EXPECT_EQ(lowered->remarks[0].kind, RemarkKind::light_lost);
  EXPECT_THAT(lowered->remarks[0].message, HasSubstr("50 % of the light is lost"));
  const auto unsaid = saveMap(path("a.dds"), smoothCube(), {.program = "unreal"}, observer);
  ASSERT_EQ(unsaid->remarks.size(), 1u);
  EXPECT_EQ(unsaid->remarks[0].kind, RemarkKind::form_unsaid);
  EXPECT_EQ(unsaid->remarks[0].detail, "cube:for=unreal");
  const auto flat =
      saveMap(path("flat.dds"), *convert(Environment(testing::smoothRadiance, 64), Projection::equirect, 16),
              {.program = "unreal"}, observer);
  ASSERT_FALSE(flat->remarks.empty());
  EXPECT_EQ(flat->remarks[0].kind, RemarkKind::not_imported);
  EXPECT_THAT(flat->remarks[0].message, HasSubstr("not of a panorama in .dds"));
  EXPECT_EQ(told, 3 + static_cast<int>(flat->remarks.size()));
}

TEST_F(SaveMapTest, WhatDoesNotGoTogetherIsRefused) {
  EXPECT_THAT(saveMap(path("a.png"), smoothCube(), {.format = TexelFormat::half}).error().message,
              HasSubstr("cannot hold half texels"));
  EXPECT_THAT(saveMap(path("a.ktx2"), smoothCube(), {.layout = CubeLayout::vcross}).error().message,
              HasSubstr("in no layout"));
  EXPECT_THAT(saveMap(path("a.xyz"), smoothCube()).error().message, HasSubstr("not a format"));
  EXPECT_THAT(saveMap(path("a.exr"), *convert(Environment(testing::smoothRadiance, 64), Projection::equirect, 16),
                      {.flip = Flip::both})
                  .error()
                  .message,
              HasSubstr("equirect is none"));
}

}  // namespace
}  // namespace mirrorball
