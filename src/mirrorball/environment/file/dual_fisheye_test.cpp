#include "mirrorball/environment/file/dual_fisheye.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/file/picture_meaning.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What a camera with two lenses writes: each circle by the lens' own axes, from the texel to the direction.
///
/// radiance  of a direction and of the lens that sees it: 0 in front, 1 behind
/// turn_deg  by which each circle is turned counter-clockwise in the file
template <typename Radiance>
Image makeCircles(Radiance&& radiance, int side, double fov_deg, glm::dvec2 turn_deg = glm::dvec2(0.0)) {
  Image picture(2 * side, side, 3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < 2 * side; ++x) {
      const int lens = x < side ? 0 : 1;
      // To the right and up in the file, in radii.
      const glm::dvec2 place((x % side + 0.5) / side * 2.0 - 1.0, 1.0 - (y + 0.5) / side * 2.0);
      const double distance = glm::length(place);
      if (distance > 1.0) continue;
      const double angle = distance * glm::radians(0.5 * fov_deg);
      const double around = std::atan2(place.y, place.x) - glm::radians(turn_deg[lens]);
      // A lens that looks along +Z has +X on its left, one that looks back has it on its right.
      const double right = std::sin(angle) * std::cos(around), up = std::sin(angle) * std::sin(around);
      const glm::dvec3 direction(lens == 0 ? -right : right, up, (lens == 0 ? 1.0 : -1.0) * std::cos(angle));
      const glm::vec3 light = radiance(glm::vec3(direction), lens);
      std::copy_n(&light.x, 3, picture.texel(x, y));
    }
  return picture;
}

/// The largest difference between a panorama and light.
template <typename Radiance>
float largestDifference(const Image& panorama, Radiance&& radiance) {
  const EnvironmentMap map(Projection::equirect, ImageSet(Image(panorama)));
  float largest = 0.0f;
  for (const glm::vec3 d : testing::manyDirections(5000)) {
    const glm::vec3 off = glm::abs(map.radiance(d) - radiance(d));
    largest = std::max({largest, off.x, off.y, off.z});
  }
  return largest;
}

TEST(DualFisheye, GivesBackThePanoramaThatTheLensesSaw) {
  const auto lit = [](glm::vec3 d, int) { return testing::smoothRadiance(d); };
  for (const double fov : {180.0, 190.0, 220.0}) {
    const Image panorama = stitched(makeCircles(lit, 128, fov), {.fov_deg = fov});
    ASSERT_EQ(panorama.width(), 256);
    ASSERT_EQ(panorama.height(), 128);
    // Within two texels of a rim its last light is continued: at 180 degrees nothing overlaps there.
    EXPECT_LT(largestDifference(panorama, testing::smoothRadiance), fov == 180.0 ? 0.02f : 0.003f) << fov;
  }
  // 60 waves round the horizon, of 12 texels each.
  const auto waving = [](glm::vec3 d, int) { return testing::waves(d); };
  EXPECT_LT(largestDifference(stitched(makeCircles(waving, 360, 190.0), {}), testing::waves), 0.1f);
}

TEST(DualFisheye, CirclesMayBeTurned) {
  const auto lit = [](glm::vec3 d, int) { return testing::smoothRadiance(d); };
  for (const glm::dvec2 turn : {glm::dvec2(-90.0, 90.0), glm::dvec2(180.0), glm::dvec2(12.0, -7.0)}) {
    const Image circles = makeCircles(lit, 128, 190.0, turn);
    EXPECT_LT(largestDifference(stitched(circles, {.turn_deg = turn}), testing::smoothRadiance), 0.003f) << turn.x;
    EXPECT_GT(largestDifference(stitched(circles, {}), testing::smoothRadiance), 0.1f) << turn.x;
  }
}

// Two lenses never have the same exposure: no step may show where one gives way to the other.
TEST(DualFisheye, LightIsBlendedWhereBothCirclesShowIt) {
  const auto lit = [](glm::vec3, int lens) { return glm::vec3(lens == 0 ? 1.0f : 2.0f); };
  const Image panorama = stitched(makeCircles(lit, 360, 200.0), {.fov_deg = 200.0});
  // A texel is half a degree; 80 to 100 degrees from +Z both circles show the light.
  const int horizon = 180, middle = 360;
  EXPECT_EQ(panorama.texel(middle + 158, horizon)[0], 1.0f);
  EXPECT_NEAR(panorama.texel(middle + 180, horizon)[0], 1.5f, 0.03f);
  EXPECT_EQ(panorama.texel(middle + 202, horizon)[0], 2.0f);
  for (int x = middle; x < 719; ++x)
    EXPECT_LT(std::abs(panorama.texel(x + 1, horizon)[0] - panorama.texel(x, horizon)[0]), 0.03f) << x;
}

// A sun in the overlap, seen by both lenses, is one sun.
TEST(DualFisheye, ASunKeepsItsFlux) {
  constexpr float kWidth = 0.03f;  // some 2.5 texels
  for (const glm::vec3 towards : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(-0.6f, 0, -0.8f)}) {
    const auto sun = [&](glm::vec3 d, int) {
      const float off = glm::length(d - towards) / kWidth;
      return glm::vec3(1000.0f * std::exp(-off * off));
    };
    const EnvironmentMap map(Projection::equirect, ImageSet(stitched(makeCircles(sun, 256, 190.0), {})));
    const double flux = 1000.0 * 3.14159265 * double(kWidth) * double(kWidth);
    // At its contrast the cubic between texels is a line in part, which adds 2 %.
    EXPECT_NEAR(testing::fluxOf(map) / flux, 1.0, 0.03) << towards.x;
  }
}

TEST(DualFisheye, TheHintNamesWhatIsSpecialOfItsCamera) {
  const auto plain = formHintNamed("dual-fisheye");
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->projection, Projection::equirect);
  ASSERT_TRUE(plain->fisheye);
  EXPECT_FALSE(plain->fisheye->fov_deg);
  const auto other = formHintNamed("dual-fisheye:fov=195.5,turn=-90,90");
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->fisheye->fov_deg, 195.5);
  EXPECT_EQ(other->fisheye->turn_deg, glm::dvec2(-90.0, 90.0));
  EXPECT_EQ(formHintNamed("dual-fisheye:turn=180")->fisheye->turn_deg, glm::dvec2(180.0));
  for (const char* wrong : {"fov=170", "fov=x", "turn=1,2,3", "turn=", "crop=none", "for=blender"})
    EXPECT_EQ(formHintNamed(std::string("dual-fisheye:") + wrong).error().code, ErrorCode::usage) << wrong;
  EXPECT_THAT(formHintNamed("fisheye").error().message, HasSubstr("dual-fisheye"));
}

TEST(DualFisheye, WhatIsAssumedIsRemarked) {
  const auto oddities = [](std::string_view hint) {
    return readMeaning({512, 256}, {}, std::nullopt, *formHintNamed(hint))->oddities;
  };
  EXPECT_THAT(oddities("dual-fisheye"),
              ElementsAre("its two circles are taken as 190 degrees wide and upright, the left one in front; "
                          "{option:from} dual-fisheye with fov=D and turn=L,R says otherwise"));
  EXPECT_THAT(oddities("dual-fisheye:turn=0"),
              ElementsAre(HasSubstr("taken as 190 degrees wide, the left one in front; {option:from} dual-fisheye with "
                                    "fov=D says")));
  EXPECT_THAT(oddities("dual-fisheye:fov=200,turn=0"), IsEmpty());
  const auto refused = readMeaning({1920, 1080}, {}, std::nullopt, *formHintNamed("dual-fisheye"));
  EXPECT_THAT(refused.error().message, HasSubstr("is 1920x1080, and two fisheye circles side by side are 2:1"));
}

TEST(DualFisheye, IsReadFromAFile) {
  const auto lit = [](glm::vec3 d, int) { return testing::smoothRadiance(d); };
  const std::string path = ::testing::TempDir() + "mirrorball_dual_fisheye.hdr";
  ASSERT_TRUE(writeImage(path, makeCircles(lit, 128, 190.0)));
  const auto unnamed = loadEnvironment(path);
  ASSERT_FALSE(unnamed);
  EXPECT_THAT(unnamed.error().message, HasSubstr("{option:from} dual-fisheye stitches it"));
  const EnvironmentLoadOptions options{.from = *formHintNamed("dual-fisheye")};
  const auto loaded = loadEnvironment(path, options);
  const auto by_rows = openPanorama(path, options);
  std::filesystem::remove(path);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(by_rows && !*by_rows) << "it is stitched as a whole";
  EXPECT_LT(largestDifference(loaded->environment.map()->face(0), testing::smoothRadiance), 0.02f);
  EXPECT_THAT(loaded->oddities, ElementsAre(HasSubstr("the left one in front")));
}

}  // namespace
}  // namespace mirrorball
