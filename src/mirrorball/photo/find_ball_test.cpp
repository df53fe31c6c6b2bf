#include "mirrorball/photo/find_ball.h"

#include <algorithm>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/photo/find_ball_testing.h"
#include "mirrorball/photo/rim_fit.h"

namespace mirrorball {
namespace {

using testing::BallScene;
using testing::builtin;
using testing::clutter;
using testing::expectFound;
using ::testing::HasSubstr;
using testing::kPromised_px;
using testing::outlineError_px;
using testing::throughJpeg;

TEST(FindBall, FarBesideTheMiddleTheRimIsAnEllipse) {
  BallScene scene;
  scene.focal_px = 420.0;
  scene.center = {2.6, -1.6, -7.0};
  scene.environment = builtin("studio");
  scene.background = clutter(3);
  const Image photograph = throughJpeg(scene.photograph());
  expectFound(scene, photograph);
  // The ellipse's axes differ by 8 %: 5 px on the radius of 60 px, which no circle in the picture follows.
  const auto as_circle = findBall(photograph, {});
  ASSERT_TRUE(as_circle);
  EXPECT_GT(outlineError_px(scene, *as_circle), 1.0);
}

TEST(FindBall, DistanceTellsTheFieldOfView) {
  BallScene scene;
  scene.focal_px = 500.0;
  scene.center = {1.3, 0.9, -5.0};
  scene.environment = builtin("sky");
  const auto found = findBall(throughJpeg(scene.photograph()), {.distance = scene.distance(), .focal_px = 0.0});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(outlineError_px(scene, *found), kPromised_px);
  EXPECT_NEAR(found->view.distance(), scene.distance(), 1e-3);
  // 0.3 px of a radius of 98 px.
  EXPECT_NEAR(found->view.pinhole().focal_px, scene.focal_px, 0.003 * scene.focal_px);
}

TEST(FindBall, PartOfTheRimIsHiddenByAStand) {
  BallScene scene;
  scene.environment = builtin("studio");
  scene.background = clutter(9);
  // A stand that is broader than half the ball, over the lowest sixth of its rim.
  scene.foreground = [](glm::dvec2 p) -> std::optional<glm::vec3> {
    if (p.y > 262.0 && std::abs(p.x - 240.0) < 75.0) return glm::vec3(0.05f);
    return {};
  };
  expectFound(scene, throughJpeg(scene.photograph()));
}

TEST(FindBall, CrossesTheBorder) {
  BallScene scene;
  scene.environment = builtin("studio");
  scene.center = {(1.25 * 240.0 - scene.focal_px / 8.0) / scene.focal_px * 8.0, 0.0, -8.0};
  double visible = 1.0;
  // A quarter of the diameter lies outside, where the error of the rest of the rim is extrapolated.
  expectFound(scene, throughJpeg(scene.photograph()), 0.6, &visible);
  EXPECT_LT(visible, 1.0);
}

TEST(FindBall, LowContrastOnOneSide) {
  BallScene scene;
  scene.environment = builtin("studio");
  // To the left the background is as bright as what the rim mirrors, to the right it is not.
  scene.background = [&scene](glm::vec3 ray) {
    const float share = glm::smoothstep(-0.05f, 0.05f, ray.x);
    return glm::mix(scene.environment(ray), glm::vec3(0.9f), share);
  };
  expectFound(scene, throughJpeg(scene.photograph()), 0.5);
}

TEST(FindBall, IsSureOfOneBallAndNotOfOneOfTwo) {
  BallScene scene;
  scene.size = {300, 300};
  scene.environment = builtin("sky");
  const Image one = scene.photograph();
  const auto alone = findBall(one, {});
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_TRUE(alone->isSure()) << alone->confidence;
  // The same ball twice, beside each other.
  Image two(600, 300, 3);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 600; ++x) std::copy_n(one.texel(x % 300, y), 3, two.texel(x, y));
  const auto either = findBall(two, {});
  ASSERT_TRUE(either) << either.error().message;
  EXPECT_FALSE(either->isSure()) << either->confidence;
  ASSERT_TRUE(either->rival);
  const Circle found = circleInPicture(either->view);
  EXPECT_NEAR(std::abs(either->rival->center_px.x - found.center_px.x), 300.0, 3.0);
  EXPECT_NEAR(either->rival->radius_px, found.radius_px, 3.0);
}

TEST(FindBall, IsTheSameEveryTime) {
  BallScene scene;
  scene.environment = builtin("uv");
  const Image photograph = scene.photograph();
  const auto first = findBall(photograph, {}), second = findBall(photograph, {});
  EXPECT_EQ(first->view.rim().center_px, second->view.rim().center_px);
  EXPECT_EQ(first->view.rim().radius_px, second->view.rim().radius_px);
}

TEST(FindBall, PicturesWithoutABallAreRefused) {
  const auto expectRefused = [](const Image& image, const char* what) {
    SCOPED_TRACE(what);
    const auto found = findBall(image, {});
    ASSERT_FALSE(found) << "share " << found->share << " radius " << found->view.rim().radius_px;
    EXPECT_EQ(found.error().code, ErrorCode::bad_shape);
    EXPECT_EQ(found.error().fix_hint, FixHint::give_circle);
    EXPECT_EQ(found.error().message.find('\n'), std::string::npos);
  };
  expectRefused(Image(200, 150, 3, 0.5f), "flat grey");
  expectRefused(Image(1, 1, 3, 0.5f), "one pixel");
  Image noise(320, 240, 3, 0.3f);
  testing::addNoise(noise, 0.2f, 0.05f);
  expectRefused(noise, "noise");
  BallScene scene;
  scene.center = {100.0, 0.0, -8.0};
  scene.environment = builtin("studio");
  expectRefused(scene.photograph(), "a room");
  for (unsigned seed = 1; seed <= 5; ++seed) {
    scene.background = clutter(seed, false);
    expectRefused(throughJpeg(scene.photograph()), "clutter");
  }
}

TEST(FindBall, AGivenCircleIsTaken) {
  const auto ball = ballOfCircle({{100.0, 80.0}, 50.0}, {200, 150}, {});
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->view.rim().center_px, glm::dvec2(100.0, 80.0));
  EXPECT_EQ(ball->view.rim().radius_px, 50.0);
  const auto near = ballOfCircle({{100.0, 75.0}, 50.0}, {200, 150}, {.distance = 4.0, .focal_px = 0.0});
  EXPECT_NEAR(near->view.distance(), 4.0, 1e-6);
  // In the middle the rim stays the circle: the radius is focal · tan(asin 1/4).
  EXPECT_NEAR(near->view.pinhole().focal_px, 50.0 * std::sqrt(15.0), 1e-4);
  for (const glm::dvec2 position : near->view.outline(16))
    EXPECT_NEAR(glm::distance(position, glm::dvec2(100.0, 75.0)), 50.0, 1e-4);
  EXPECT_EQ(ballOfCircle({{400.0, 80.0}, 50.0}, {200, 150}, {}).error().code, ErrorCode::usage);
  EXPECT_EQ(ballOfCircle({{100.0, 80.0}, 0.0}, {200, 150}, {}).error().code, ErrorCode::usage);
}

TEST(RimFit, CircleThroughThreePoints) {
  const auto circle = circleThrough({3.0, 1.0}, {1.0, 3.0}, {-1.0, 1.0});
  ASSERT_TRUE(circle);
  EXPECT_NEAR(glm::distance(circle->center_px, glm::dvec2(1.0, 1.0)), 0.0, 1e-12);
  EXPECT_NEAR(circle->radius_px, 2.0, 1e-12);
  EXPECT_FALSE(circleThrough({0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}));
}

TEST(RimFit, FitsAnArcWithoutBias) {
  // A third of a circle with noise of 0.5 px: Kåsa's fit alone would make it smaller by some 1 %.
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0.0, 0.5);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2.0 * i / 2000.0;
    points.push_back(glm::dvec2(40.0, -7.0) + (60.0 + normal(random)) * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  const auto circle = fitCircle(points, std::vector<double>(points.size(), 1.0));
  ASSERT_TRUE(circle);
  // Five standard deviations of the radius' estimate, about 0.03 px.
  EXPECT_NEAR(circle->radius_px, 60.0, 0.2);
}

}  // namespace
}  // namespace mirrorball
