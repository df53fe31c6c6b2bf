#include "mirrorball/photo/unwrap.h"

#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/fill.h"
#include "mirrorball/photo/find_ball.h"
#include "mirrorball/photo/photo_testing.h"

namespace mirrorball {
namespace {

using testing::BallScene;
using testing::psnr;
using testing::smoothRadiance;

/// A scene of smooth light, whose ball stands beside the middle.
BallScene smoothScene() {
  BallScene scene;
  scene.environment = [](glm::vec3 d) { return 0.4f * smoothRadiance(d); };
  scene.background = [](glm::vec3) { return glm::vec3(0.02f); };
  scene.reflectance = 1.0;
  scene.center = {0.9, 0.5, -8.0};
  return scene;
}

/// What the scene's own ball shows, found in its photograph.
BallPhotograph found(const BallScene& scene, const Image& photograph) {
  const auto ball = findBall(photograph, {.distance = 0.0, .focal_px = scene.focal_px});
  EXPECT_TRUE(ball) << ball.error().message;
  return {photograph, ball->view, scene.turn_deg};
}

Environment truthOf(const BallScene& scene) { return Environment(scene.environment, 512); }

TEST(Unwrap, GivesTheEnvironmentBack) {
  const BallScene scene = smoothScene();
  const BallPhotograph photograph = found(scene, scene.photograph());
  const double unseen = photograph.view.unseenHalfAngle_rad(3.0 * rimMargin_px(photograph.view));
  const glm::vec3 axis(photograph.view.axis());
  const auto unwrapped = unwrapBall({photograph});
  ASSERT_TRUE(unwrapped);
  const auto isSeen = [&](glm::vec3 d) { return std::acos(glm::clamp(glm::dot(d, axis), -1.0f, 1.0f)) > unseen; };
  // Outside a cone of 39° around the blind direction (1.4 sr of 12.6), which is seen in the outermost 4.5 of 112
  // pixels: what 0.3 px of error in the rim and bilinear look-ups leave of light between 0 and 0.8.
  EXPECT_LT(glm::degrees(unseen), 40.0);
  const double seen_db = psnr(unwrapped->environment, truthOf(scene), isSeen);
  RecordProperty("psnr_seen_db", std::to_string(seen_db));
  EXPECT_GT(seen_db, 45.0);
  // The continued cone, too, is no farther off than smooth light varies across it.
  EXPECT_GT(psnr(unwrapped->environment, truthOf(scene), [&](glm::vec3 d) { return !isSeen(d); }), 20.0);
  // The cone that the ball hides, and the margin along the rim.
  EXPECT_GT(unwrapped->filled_sr, formula::kTwoPi * (1.0 - std::cos(photograph.view.blindHalfAngle_rad())));
  EXPECT_LT(unwrapped->filled_sr, formula::kTwoPi * (1.0 - std::cos(unseen)));
}

// Edges as sharp as a room's, noise, and JPEG: the floor is for light clipped to [0, 1], as a picture shows it.
TEST(Unwrap, ARoomThroughACameraAndJpeg) {
  BallScene scene;
  scene.size = {640, 480};
  scene.focal_px = 1600.0;
  scene.center = {0.4, -0.3, -9.0};
  scene.environment = [studio = *builtinEnvironment("studio")](glm::vec3 d) {
    return glm::clamp(studio.radiance(d), 0.0f, 1.0f);
  };
  scene.reflectance = 0.8;
  scene.background = [](glm::vec3) { return glm::vec3(0.03f, 0.05f, 0.04f); };
  Image light = scene.photograph();
  testing::addNoise(light, 0.01f, 0.002f);
  const Image photograph = decodeJpeg(*encodeJpeg(pictureFromLinear(light, 3), {}))->image;
  const auto unwrapped = unwrapBall({found(scene, photograph)});
  ASSERT_TRUE(unwrapped);
  const Environment truth([&](glm::vec3 d) { return 0.8f * scene.environment(d); }, 512);
  const double in_front = psnr(unwrapped->environment, truth, [](glm::vec3 d) { return d.z > 0.0f; });
  const double to_60_deg = psnr(unwrapped->environment, truth, [](glm::vec3 d) { return d.z > -0.87f; });
  RecordProperty("psnr_front_db", std::to_string(in_front));
  RecordProperty("psnr_beyond_30_degrees_of_the_blind_direction_db", std::to_string(to_60_deg));
  EXPECT_GT(in_front, 30.0);
  EXPECT_GT(to_60_deg, 24.0);
}

TEST(Unwrap, ASecondPhotographFillsTheBlindCone) {
  const BallScene first = smoothScene();
  BallScene second = smoothScene();
  second.turn_deg = 90.0;
  second.center = {-0.5, 0.2, -7.0};
  // The second photograph is exposed half as long.
  Image darker = second.photograph();
  for (float& sample : darker.samples()) sample *= 0.5f;
  BallPhotograph second_found = found(second, darker);
  const BallPhotograph first_found = found(first, first.photograph());
  const auto unwrapped = unwrapBall({first_found, second_found});
  ASSERT_TRUE(unwrapped);
  EXPECT_EQ(unwrapped->gains[0], 1.0);
  EXPECT_NEAR(unwrapped->gains[1], 2.0, 0.01);
  EXPECT_EQ(unwrapped->filled_sr, 0.0);
  const glm::vec3 axis(first_found.view.axis());
  const auto everywhere = [](glm::vec3) { return true; };
  const auto behind = [&](glm::vec3 d) { return glm::dot(d, axis) > std::cos(0.5f); };
  EXPECT_GT(psnr(unwrapped->environment, truthOf(first), everywhere), 45.0);
  EXPECT_GT(psnr(unwrapped->environment, truthOf(first), behind), 45.0);
  // The first photograph alone does not know what is there.
  EXPECT_LT(psnr(unwrapBall({first_found})->environment, truthOf(first), behind), 40.0);
}

TEST(Unwrap, TurnedTheWrongWayItWouldShow) {
  const BallScene first = smoothScene();
  BallScene second = smoothScene();
  second.turn_deg = 90.0;
  BallPhotograph wrong = found(second, second.photograph());
  wrong.turn_deg = -90.0;
  const auto unwrapped = unwrapBall({found(first, first.photograph()), wrong});
  EXPECT_LT(psnr(unwrapped->environment, truthOf(first), [](glm::vec3) { return true; }), 25.0);
}

TEST(Unwrap, ABallCutByTheBorderIsContinuedToo) {
  BallScene scene = smoothScene();
  scene.center = {1.9, 0.0, -8.0};
  const auto unwrapped = unwrapBall({found(scene, scene.photograph())});
  ASSERT_TRUE(unwrapped);
  EXPECT_GT(unwrapped->filled_sr, 0.5);
  const auto map = convert(unwrapped->environment, Projection::cube, 32);
  for (int face = 0; face < 6; ++face)
    for (const float sample : map->face(face).samples()) {
      EXPECT_GT(sample, 0.0f);
      EXPECT_LT(sample, 1.0f);
    }
}

// cos φ around the edge of a cap continues as the harmonic function (tan θ/2 / tan θ₀/2) cos φ.
TEST(Fill, ACapIsTheMembrane) {
  const float edge = std::cos(0.6f);
  const auto known = [&](glm::vec3 d) -> std::optional<glm::vec3> {
    if (d.z > edge) return {};
    const float sideways = std::hypot(d.x, d.y);
    return glm::vec3(2.0f + (sideways > 0.0f ? d.x / sideways : 0.0f), 1.0f, 3.0f);
  };
  const auto filled = continueSmoothly(known, 64);
  ASSERT_TRUE(filled);
  for (const float theta : {0.0f, 0.2f, 0.4f, 0.5f})
    for (const float phi : {0.0f, 1.0f, 2.5f}) {
      const glm::vec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      const float expected = 2.0f + std::tan(theta / 2.0f) / std::tan(0.3f) * std::cos(phi);
      // The edge is a staircase of texels of 1.4° on a cap of 34°.
      EXPECT_NEAR(filled->radiance(d).x, expected, 0.08f) << theta << " " << phi;
      EXPECT_NEAR(filled->radiance(d).y, 1.0f, 1e-4f);
    }
}

TEST(Fill, NothingKnownIsAnError) {
  const auto filled = continueSmoothly([](glm::vec3) -> std::optional<glm::vec3> { return {}; }, 8);
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, ErrorCode::bad_shape);
}

}  // namespace
}  // namespace mirrorball
