#include "mirrorball/environment/file/compass_heading.h"

#include <gtest/gtest.h>

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

// The column is one of the picture, whatever its middle is to us.
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
  }
}

}  // namespace
}  // namespace mirrorball
