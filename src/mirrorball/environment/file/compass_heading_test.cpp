#include "mirrorball/environment/file/compass_heading.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

/// Where a direction is in a panorama: columns to the right of its middle and rows above it, in degrees.
glm::vec2 placeInPicture(glm::vec3 direction) {
  const glm::vec2 uv = positionOf(Projection::equirect, direction).uv;
  return {360.0f * (uv.x - 0.5f), 180.0f * (0.5f - uv.y)};
}

void expectAt(const CompassHeading& heading, glm::vec2 place) {
  const glm::vec2 found = placeInPicture(compassAxes(heading).north);
  EXPECT_NEAR(found.x, place.x, 1e-3f) << heading.heading_deg;
  EXPECT_NEAR(found.y, place.y, 1e-3f) << heading.heading_deg;
}

// Who looks east has north on the left.
TEST(CompassHeading, NorthIsAsFarToTheLeftAsTheMiddleIsToTheEast) {
  expectAt({.heading_deg = 0.0}, {0.0f, 0.0f});
  expectAt({.heading_deg = 90.0}, {-90.0f, 0.0f});
  expectAt({.heading_deg = 330.0}, {30.0f, 0.0f});
  expectAt({.heading_deg = 0.25}, {-0.25f, 0.0f});
  EXPECT_EQ(compassAxes({.heading_deg = 37.0}).up, glm::vec3(0.0f, 1.0f, 0.0f));
}

// A camera that looks north and up sees the horizon below; one that looks south has it above its back.
TEST(CompassHeading, TheHorizonOfATiltedPictureIsTilted) {
  expectAt({.heading_deg = 0.0, .pitch_deg = 10.0}, {0.0f, -10.0f});
  expectAt({.heading_deg = 90.0, .pitch_deg = 10.0}, {-90.0f, 0.0f});
  const glm::vec2 behind = placeInPicture(compassAxes({.heading_deg = 180.0, .pitch_deg = 10.0}).north);
  EXPECT_NEAR(std::abs(behind.x), 180.0f, 1e-3f);
  EXPECT_NEAR(behind.y, 10.0f, 1e-3f);
  // The horizon turns counter-clockwise: it falls on the left.
  expectAt({.heading_deg = 90.0, .roll_deg = 5.0}, {-90.0f, -5.0f});
  expectAt({.heading_deg = 0.0, .roll_deg = 5.0}, {0.0f, 0.0f});
  const CompassAxes axes = compassAxes({.heading_deg = 70.0, .pitch_deg = -20.0, .roll_deg = 33.0});
  EXPECT_NEAR(glm::dot(axes.north, axes.up), 0.0f, 1e-6f);
}

TEST(CompassHeading, ThePicturesMiddleMayBeAnotherOfOurAxes) {
  const glm::vec3 north = compassAxes({.heading_deg = 0.0}, SignedAxis::minus_z).north;
  EXPECT_LT(glm::distance(north, glm::vec3(0.0f, 0.0f, -1.0f)), 1e-6f);
  EXPECT_LT(glm::distance(compassAxes({.heading_deg = 0.0}, SignedAxis::plus_x).north, glm::vec3(1.0f, 0.0f, 0.0f)),
            1e-6f);
}

// Light that was seen by a tilted camera is where it comes from again, whatever axis of ours the middle is.
TEST(CompassHeading, ALevelledPanoramaHasTheLightOfItsDirections) {
  constexpr double kPitch_deg = 20.0, kRoll_deg = -35.0;
  for (const SignedAxis centre : {SignedAxis::plus_z, SignedAxis::minus_x}) {
    const glm::mat3 map_from_picture = centredOn(vectorOf(centre));
    const glm::mat3 level_from_picture = glm::transpose(pictureFromLevel(kPitch_deg, kRoll_deg));
    const Environment tilted(
        [&](glm::vec3 d) {
          return testing::smoothRadiance(map_from_picture * level_from_picture * glm::transpose(map_from_picture) * d);
        },
        128);
    const auto level = levelled(*convert(tilted, Projection::equirect, 128), kPitch_deg, kRoll_deg, centre);
    ASSERT_TRUE(level) << level.error().message;
    for (const glm::vec3 direction : testing::manyDirections(500))
      EXPECT_LT(glm::distance(level->radiance(direction), testing::smoothRadiance(direction)), 2e-3f);
  }
  // A camera that looks up has the horizon below the middle of its picture.
  const glm::vec3 horizon = pictureFromLevel(30.0, 0.0) * glm::vec3(0.0f, 0.0f, 1.0f);
  EXPECT_NEAR(horizon.y, -0.5f, 1e-6f);
}

// The column is one of the picture, whatever its middle is to us; of the whole panorama where that is larger.
TEST(CompassHeading, NorthIsFoundInPanoramasAlone) {
  LoadedEnvironment loaded{.environment = Environment({}, 1), .file_size = {2048, 1024}};
  const CompassHeading heading{.heading_deg = 90.0};
  EXPECT_EQ(checkTakesHeading(loaded).error().code, ErrorCode::bad_shape);
  EXPECT_TRUE(findNorth(heading, loaded).error().message.ends_with("is a function of the direction"));
  loaded.recognition.emplace().form.projection = Projection::octahedral;
  EXPECT_TRUE(findNorth(heading, loaded).error().message.ends_with("this map is octahedral"));
  for (const SignedAxis centre : {SignedAxis::plus_z, SignedAxis::minus_z, SignedAxis::plus_x}) {
    loaded.recognition->form = {.projection = Projection::equirect, .centre = centre};
    const auto north = findNorth(heading, loaded);
    ASSERT_TRUE(north) << north.error().message;
    EXPECT_NEAR(north->column, 512.0f, 0.01f);
    EXPECT_EQ(north->axes.north, compassAxes(heading, centre).north);
    EXPECT_EQ(north->heading.heading_deg, 90.0);
    EXPECT_EQ(north->columns, 2048);
  }
  loaded.window = PictureWindow{.whole = {4096, 2048}, .corner = {512, 512}, .size = {2048, 1024}};
  EXPECT_NEAR(findNorth(heading, loaded)->column, 1024.0f, 0.01f);
  const CompassHeading tilted{.heading_deg = 90.0, .pitch_deg = 5.0, .roll_deg = 12.0};
  EXPECT_GT(std::abs(findNorth(tilted, loaded)->axes.north.y), 0.1f);
  loaded.is_levelled = true;
  EXPECT_EQ(findNorth(tilted, loaded)->axes.up, glm::vec3(0.0f, 1.0f, 0.0f));
  EXPECT_EQ(findNorth(tilted, loaded)->axes.north, compassAxes(heading, SignedAxis::plus_x).north);
}

}  // namespace
}  // namespace mirrorball
