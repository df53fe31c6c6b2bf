#include "mirrorball/photo/ball_photo.h"

#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/photo/find_ball_testing.h"

namespace mirrorball {
namespace {

using testing::BallScene;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A photograph of a ball in the studio, in a file of light.
std::string photographed(const BallScene& scene, const char* name) {
  std::string path = ::testing::TempDir() + name;
  EXPECT_TRUE(writeImage(path, scene.photograph()));
  return path;
}

BallScene ballInStudio() {
  BallScene scene;
  scene.environment = testing::builtin("studio");
  scene.background = testing::clutter(1);
  scene.size = {240, 180};
  scene.focal_px = 450.0;
  return scene;
}

TEST(BallPhoto, TheCircleIsFoundOrTakenAsGiven) {
  const BallScene scene = ballInStudio();
  const std::string path = photographed(scene, "ball_photo.hdr");
  const auto read = readBallLight({{path}}, {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->told, "one photograph, response linear light");
  EXPECT_THAT(read->remarks, IsEmpty());
  BallPhotoSettings settings;
  settings.fov_deg = float(glm::degrees(2.0 * std::atan(90.0 / scene.focal_px)));
  const auto found = ballIn(*read, settings);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(testing::outlineError_px(scene, *found), 0.5);
  EXPECT_NEAR(found->view.distance(), scene.distance(), 0.1);
  settings.circle = {100, 80, 30};
  const Circle taken = circleInPicture(ballIn(*read, settings)->view);
  EXPECT_NEAR(taken.center_px.x, 100.0, 0.1);
  EXPECT_NEAR(taken.center_px.y, 80.0, 0.1);
  EXPECT_NEAR(taken.radius_px, 30.0, 0.1);
  settings.circle = {-100, 80, 30};
  EXPECT_EQ(ballIn(*read, settings).error().code, ErrorCode::usage);
}

TEST(BallPhoto, WhatHasNoBallIsTold) {
  const std::string path = ::testing::TempDir() + "no_ball.hdr";
  ASSERT_TRUE(writeImage(path, Image(200, 150, 3, 0.5f)));
  const auto found = ballIn(*readBallLight({{path}}, {}), {});
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("no_ball.hdr: no mirror ball is found"));
  EXPECT_EQ(found.error().fix_hint, FixHint::give_circle);
}

TEST(BallPhoto, ADoubtfulCircleIsTold) {
  FoundBall ball{BallView(Pinhole{{60, 60}, 0.0}, {{60, 60}, 40})};
  EXPECT_EQ(doubtAbout(ball, "a.jpg"), "");
  ball.confidence = 0.5;
  ball.rival = Circle{{180, 60}, 40};
  EXPECT_EQ(doubtAbout(ball, "a.jpg"),
            "a.jpg: this circle may not be the ball's (confidence 50 %; the next likely one is about 180,60,40)");
}

TEST(BallPhoto, WhatCannotBeIsRefusedBeforeAnythingIsRead) {
  BallPhotoSettings settings;
  EXPECT_TRUE(checkBallPhoto(settings));
  settings.distance = 0.5f;
  EXPECT_THAT(checkBallPhoto(settings).error().message, HasSubstr("more than 1"));
  settings.distance = 5.0f;
  EXPECT_TRUE(checkBallPhoto(settings));
  settings.fov_deg = 40.0f;
  EXPECT_THAT(checkBallPhoto(settings).error().message, HasSubstr("say the same"));
}

// Each fits by itself.
TEST(BallPhoto, ASeriesThatIsTooLargeIsRefused) {
  const std::string path = ::testing::TempDir() + "one_of_many.ppm";
  const std::string_view header = "P6 256 256 255\n";
  Bytes picture(header.begin(), header.end());
  picture.resize(picture.size() + 256 * 256 * 3, std::uint8_t{100});
  ASSERT_TRUE(writeFile(path, picture));
  const std::vector<std::string> series(40, path);
  std::string exposures = "1";
  for (std::size_t i = 1; i < series.size(); ++i) exposures += ",1/" + std::to_string(i + 1);
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{6} << 20u);
  const auto one = readBallLight(std::span(series).first(1), {});
  const auto all = readBallLight(series, {.exposures = exposures, .response = 1});
  setMemoryLimit(usual);
  EXPECT_TRUE(one) << one.error().message;
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().code, ErrorCode::too_large) << all.error().message;
  EXPECT_THAT(all.error().message, ::testing::StartsWith(path + ": needs "));
}

TEST(BallPhoto, TheTableHoldsAllSettings) {
  BallPhotoSettings settings;
  const std::vector<std::string> texts{"1,2,3", "2", "4", "1/60", "linear", "rgba"};
  ASSERT_EQ(ballPhotoOptions().size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) ASSERT_TRUE(assign(ballPhotoOptions()[i], settings, texts[i]));
  const BallPhotoSettings expected{.circle = {1, 2, 3},
                                   .distance = 2,
                                   .fov_deg = 4,
                                   .exposures = "1/60",
                                   .response = 1 + int(ResponseKind::linear),
                                   .layer = "rgba"};
  EXPECT_EQ(settings, expected);
}

}  // namespace
}  // namespace mirrorball
