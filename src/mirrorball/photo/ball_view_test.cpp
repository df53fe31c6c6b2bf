#include "mirrorball/photo/ball_view.h"

#include <gtest/gtest.h>

#include "mirrorball/photo/photo_testing.h"

namespace mirrorball {
namespace {

using testing::BallScene;

/// The view of a scene whose rim is known, from points of its outline.
BallView viewOf(const BallScene& scene) {
  const Pinhole pinhole{glm::dvec2(scene.size) / 2.0, scene.focal_px};
  // Three points make the circle; the rest of the outline must lie on it (see LensTest).
  const auto outline = scene.outline(3);
  const glm::dvec2 a = pinhole.planeFromPicture(outline[0]), b = pinhole.planeFromPicture(outline[1]),
                   c = pinhole.planeFromPicture(outline[2]);
  const glm::dmat2 rows(b - a, c - a);
  const glm::dvec2 m =
      glm::inverse(glm::transpose(rows)) * (0.5 * glm::dvec2(glm::dot(b - a, b - a), glm::dot(c - a, c - a)));
  return {pinhole, {a + m, glm::length(m)}};
}

BallScene besideTheMiddle() {
  BallScene scene;
  scene.focal_px = 420.0;
  scene.center = {2.6, -1.6, -7.0};
  return scene;
}

TEST(Pinhole, PlaneAndPictureAreInverse) {
  const Pinhole pinhole{{240.0, 180.0}, 300.0};
  for (const glm::dvec2 position : {glm::dvec2(240.0, 180.0), glm::dvec2(0.0, 0.0), glm::dvec2(479.0, 20.0)})
    EXPECT_NEAR(glm::distance(pinhole.pictureFromPlane(pinhole.planeFromPicture(position)), position), 0.0, 1e-9);
}

TEST(Pinhole, TheRimOfABallBesideTheMiddleIsACircleInThePlane) {
  const BallScene scene = besideTheMiddle();
  const BallView view = viewOf(scene);
  for (const glm::dvec2 position : scene.outline(90)) EXPECT_NEAR(view.fromRim_px(position), 0.0, 1e-6);
  for (const glm::dvec2 position : view.outline(16)) EXPECT_NEAR(view.fromRim_px(position), 0.0, 1e-6);
}

TEST(BallView, KnowsWhereTheBallStands) {
  const BallScene scene = besideTheMiddle();
  const BallView view = viewOf(scene);
  EXPECT_NEAR(view.distance(), scene.distance(), 1e-6);
  EXPECT_NEAR(glm::distance(view.axis(), glm::normalize(scene.center)), 0.0, 1e-9);
  EXPECT_NEAR(view.blindHalfAngle_rad(), std::asin(1.0 / scene.distance()), 1e-9);
}

TEST(BallView, SeesWhatTracedRaysSee) {
  // The environment is the direction itself, so that a traced pixel tells where its light came from.
  for (BallScene scene : {BallScene{}, besideTheMiddle()}) {
    scene.environment = [](glm::vec3 d) { return d; };
    scene.reflectance = 1.0;
    const BallView view = viewOf(scene);
    int on_ball = 0;
    for (double y = 0.5; y < scene.size.y; y += 7.0)
      for (double x = 0.5; x < scene.size.x; x += 7.0) {
        if (view.fromRim_px({x, y}) < 0.5) continue;
        ++on_ball;
        const glm::dvec3 traced(scene.lightAt({x, y}));
        // Floats, and a grazing ray's direction turns fast: 1e-4 rad is a hundredth of a pixel at the rim.
        EXPECT_NEAR(glm::distance(*view.directionAt({x, y}), traced), 0.0, 1e-4);
        const auto seen = view.seenAt(traced);
        ASSERT_TRUE(seen);
        EXPECT_NEAR(glm::distance(seen->position_px, glm::dvec2(x, y)), 0.0, 1e-3);
        const glm::dvec3 normal = glm::normalize(traced - view.pinhole().rayThrough({x, y}));
        EXPECT_NEAR(seen->facing, -glm::dot(view.pinhole().rayThrough({x, y}), normal), 1e-3);
      }
    EXPECT_GT(on_ball, 100);
  }
}

TEST(BallView, ParallelRaysMakeASphereMap) {
  const BallView view(Pinhole{{100.0, 100.0}, 0.0}, {{60.0, 70.0}, 40.0});
  EXPECT_TRUE(std::isinf(view.distance()));
  EXPECT_EQ(view.blindHalfAngle_rad(), 0.0);
  // Light from +X is reflected where the normal stands 45° to the right.
  const auto seen = view.seenAt({1.0, 0.0, 0.0});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->position_px.x, 60.0 + 40.0 * std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(seen->position_px.y, 70.0, 1e-4);
  EXPECT_NEAR(seen->facing, std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(glm::distance(*view.directionAt(seen->position_px), glm::dvec3(1.0, 0.0, 0.0)), 0.0, 1e-5);
  EXPECT_FALSE(view.directionAt({10.0, 10.0}));
}

TEST(BallView, TheBlindConeIsNotSeen) {
  BallScene scene;
  scene.center = {0.0, 0.0, -2.0};
  const BallView view = viewOf(scene);
  EXPECT_NEAR(glm::degrees(view.blindHalfAngle_rad()), 30.0, 1e-6);
  const auto at = [&](double angle_deg) {
    const double angle = glm::radians(angle_deg);
    return view.seenAt({std::sin(angle), 0.0, -std::cos(angle)});
  };
  EXPECT_FALSE(at(29.9));
  EXPECT_TRUE(at(30.1));
  // A margin widens it; its edge is seen at the margin.
  const double unseen_deg = glm::degrees(view.unseenHalfAngle_rad(3.0));
  EXPECT_GT(unseen_deg, 31.0);
  EXPECT_NEAR(at(unseen_deg)->from_rim_px, 3.0, 1e-3);
}

}  // namespace
}  // namespace mirrorball
