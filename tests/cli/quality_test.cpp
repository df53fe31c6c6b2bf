#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;

/// Without --quality, as users run it.
class QualityCliTest : public CliTest {
 protected:
  Outcome runPlainly(const std::string& line) const {
    return Program({.arguments = Arguments(line).words, .folder = path("")}).wait();
  }
};

TEST_F(QualityCliTest, GoodIsTheDefaultAndSaysWhatItChose) {
  const std::string line = "render tumbler-water -e studio --size 48x48 ";
  EXPECT_EQ(runPlainly(line + "-o plain.png").err,
            "mirrorball: note: --quality good chose --refraction auto --behind screen "
            "--self-reflection\n");
  succeed(line + "--refraction auto --behind screen --self-reflection -o told.png");
  EXPECT_TRUE(bytes("plain.png") == bytes("told.png"));
  succeed(line + "-o draft.png");
  EXPECT_FALSE(bytes("plain.png") == bytes("draft.png"));
}

TEST_F(QualityCliTest, NothingIsChosenWhereNothingIsNeeded) {
  EXPECT_EQ(runPlainly("render sphere --material gold -e studio --size 16x16 -o ball.png").err, "");
  EXPECT_EQ(runPlainly("render none -e studio --size 16x16 -o none.png").err, "");
}

TEST_F(QualityCliTest, AStrongSunStandsApart) {
  Image map(256, 128, 3, 0.5f);
  std::fill_n(map.texel(100, 40), 3, 2e4f);
  write("sunny.exr", map);
  const std::string line = "render sphere -e sunny.exr --size 32x32 ";
  EXPECT_EQ(runPlainly(line + "-o good.png").err, "mirrorball: note: --quality good chose --sun split\n");
  succeed(line + "--sun split -o split.png");
  EXPECT_TRUE(bytes("good.png") == bytes("split.png"));
  EXPECT_EQ(runPlainly(line + "--threads 1 -o alone.png").err, runPlainly(line + "-o good.png").err);
  EXPECT_TRUE(bytes("good.png") == bytes("alone.png"));
  EXPECT_EQ(runPlainly(line + "--sun map -o map.png").err, "");
  EXPECT_FALSE(bytes("good.png") == bytes("map.png"));
  EXPECT_EQ(runPlainly(line + "--proxy sphere -o near.png").err, "") << "where light is near, a sun is no direction";
}

TEST_F(QualityCliTest, WhatIsGivenIsDrawn) {
  const std::string line = "render bowl -e studio --size 48x48 ";
  EXPECT_EQ(runPlainly(line + "--occlusion none -o plain.png").err, "");
  succeed(line + "-o draft.png");
  EXPECT_TRUE(bytes("plain.png") == bytes("draft.png"));
}

TEST_F(QualityCliTest, CaptureTakesItToo) {
  const Outcome outcome = runPlainly("capture bowl --at 0,0.2,0 -e studio --size 16 -o map.exr");
  EXPECT_THAT(outcome.err, HasSubstr("--quality good chose --occlusion vertex"));
  succeed("capture bowl --at 0,0.2,0 -e studio --size 16 -o draft.exr");
  EXPECT_FALSE(bytes("map.exr") == bytes("draft.exr"));
}

TEST_F(QualityCliTest, OptionsThatCannotActSaySo) {
  const std::string line = "render sphere -e studio --size 8x8 -o ball.png ";
  EXPECT_THAT(run(line + "--light-intensity 2").err, HasSubstr("the model has no lights of its own"));
  EXPECT_THAT(run(line + "--behind screen").err, HasSubstr("no surface lets light through"));
  EXPECT_THAT(run("capture sphere --at 0,0,3 -e studio --size 8 --lobe-taps 2 --blur mip -o map.exr").err,
              HasSubstr("--lobe-taps changes nothing"));
  EXPECT_THAT(run(line + "--material glass --set attenuation_distance=1 --set attenuation_color=0.2,0.9,0.4").err,
              HasSubstr("no absorption"));
}

TEST_F(QualityCliTest, ContradictionsAreTold) {
  const std::string line = "render sphere -e studio --size 8x8 -o ball.png ";
  EXPECT_THAT(refuse(2, line + "--stand --proxy none"), HasSubstr("--stand is on a ground"));
  EXPECT_THAT(refuse(2, line + "--self-reflection --occlusion none"), HasSubstr("leave --occlusion none out"));
}

// The shadow of a ball that stands on the ground below the sun, alone: black that covers as much as is missing.
TEST_F(QualityCliTest, StandsOnTheFloorAndItsShadowIsAlpha) {
  const std::string line = "render sphere -e sky:elevation=50 --size 96x64 --samples 1 --stand ";
  succeed(line + "-o ground.exr");
  succeed(line + "--background transparent -o shadow.exr");
  const Image ground = image("ground.exr"), shadow = image("shadow.exr");
  ASSERT_EQ(shadow.channels(), 4);
  int covered = 0, clear = 0;
  for (int y = 0; y < shadow.height(); ++y)
    for (int x = 0; x < shadow.width(); ++x) {
      const float* texel = shadow.texel(x, y);
      if (texel[3] >= 1.0f) continue;  // the ball
      EXPECT_EQ(texel[0], 0.0f);
      covered += texel[3] > 0.3f ? 1 : 0;
      clear += texel[3] == 0.0f ? 1 : 0;
    }
  EXPECT_GT(covered, 40);
  EXPECT_GT(clear, 1000);
  // On a page of a colour, as much of it is missing.
  succeed(line + "--background 4,2,1 -o page.exr");
  const Image page = image("page.exr");
  for (int y = 0; y < page.height(); ++y)
    for (int x = 0; x < page.width(); ++x)
      if (const float missing = shadow.texel(x, y)[3]; missing < 0.9f) {  // not at the ball's outline
        EXPECT_NEAR(page.texel(x, y)[0], 4.0f * (1.0f - missing), 0.02f) << x << " " << y;
      }
  succeed(line + "--background #ffffff -o page.png");
  const Image white = image("page.png");
  int darkened = 0;
  for (int y = 0; y < white.height(); ++y)
    for (int x = 0; x < white.width(); ++x)
      if (const float missing = shadow.texel(x, y)[3]; missing == 0.0f) {
        EXPECT_GT(white.texel(x, y)[0], 0.99f) << x << " " << y;
      } else if (missing > 0.3f && missing < 0.9f) {
        EXPECT_LT(white.texel(x, y)[0], 0.9f) << x << " " << y;
        ++darkened;
      }
  EXPECT_GT(darkened, 20);
  // Of a black ground nothing is missing.
  write("black.exr", Image(8, 4, 3, 0.0f));
  succeed("render sphere -e black.exr --size 32x24 --samples 1 --stand --background transparent -o black_shadow.exr");
  EXPECT_EQ(image("black_shadow.exr").texel(1, 22)[3], 0.0f);
  // The picture's border is free of it: the camera holds the shadow too.
  for (int y = 0; y < shadow.height(); ++y) EXPECT_LT(shadow.texel(0, y)[3] + shadow.texel(95, y)[3], 0.3f) << y;
  EXPECT_THAT(refuse(2, "render sphere --shadow -o ball.png"), HasSubstr("did you mean --stand?"));
}

}  // namespace
}  // namespace mirrorball::testing
