#include "mirrorball/output/convert_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/output/output_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ConvertFileTest : public testing::InFolder {
 protected:
  ConvertFileTest() {
    EXPECT_TRUE(saveMap(path("map.exr"), *convert(Environment(testing::smoothRadiance, 64), Projection::equirect, 32)));
  }
};

TEST_F(ConvertFileTest, IsWhatLoadingConvertingAndSavingGive) {
  const auto saved = convertFile(path("map.exr"), path("cube.ktx2"), {.to = Projection::cube, .size = 16});
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_THAT(saved->paths, ElementsAre(path("cube.ktx2")));
  const auto by_file = loadEnvironment(path("cube.ktx2"));
  ASSERT_TRUE(by_file) << by_file.error().message;
  ASSERT_TRUE(saveMap(path("steps.ktx2"), *convert(*loadEnvironment(path("map.exr")), Projection::cube, 16)));
  const auto by_steps = loadEnvironment(path("steps.ktx2"));
  ASSERT_TRUE(by_steps) << by_steps.error().message;
  for (int face = 0; face < 6; ++face)
    EXPECT_TRUE(std::ranges::equal(by_file->environment.map()->face(face).samples(),
                                   by_steps->environment.map()->face(face).samples()));
}

TEST_F(ConvertFileTest, WhatIsLeftOutIsARemark) {
  ASSERT_TRUE(convertFile(path("map.exr"), path("cube.ktx2"), {.to = Projection::cube, .file = {.mips = true}}));
  const auto saved = convertFile(path("cube.ktx2"), path("one.ktx2"));
  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->remarks.size(), 1u);
  EXPECT_EQ(saved->remarks[0].kind, RemarkKind::levels_left_out);
}

TEST_F(ConvertFileTest, TheInputIsNotOverwritten) {
  const auto saved = convertFile(path("map.exr"), path("map.exr"), {.to = Projection::octahedral});
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::usage);
  EXPECT_THAT(saved.error().message, HasSubstr("is the input itself"));
}

TEST_F(ConvertFileTest, ABuiltInNeedsAProjection) {
  const auto saved = convertFile("sky", path("sky.exr"));
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().fix_hint, FixHint::name_projection);
}

}  // namespace
}  // namespace mirrorball
