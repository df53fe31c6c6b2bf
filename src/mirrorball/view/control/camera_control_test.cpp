#include "mirrorball/view/control/camera_control.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

constexpr glm::ivec2 kSize{320, 200};
constexpr BoundingSphere kBounds{{3.0f, -1.0f, 2.0f}, 2.5f};

/// Where a camera shows a place of the world [pixels].
glm::vec2 shownAt(const CameraOptions& options, glm::vec3 place) {
  const Camera camera = makeCamera(options, kBounds, float(kSize.x) / float(kSize.y));
  const glm::vec4 clip = camera.clip_from_view * camera.view_from_world * glm::vec4(place, 1.0f);
  const glm::vec2 ndc = glm::vec2(clip) / clip.w;
  return (glm::vec2(ndc.x, -ndc.y) * 0.5f + 0.5f) * glm::vec2(kSize);
}

/// What lies at the target's depth at a place of the picture.
glm::vec3 placeUnder(const CameraOptions& options, glm::vec2 pixel) {
  const Camera camera = makeCamera(options, kBounds, float(kSize.x) / float(kSize.y));
  const glm::vec4 target_clip =
      camera.clip_from_view * camera.view_from_world * glm::vec4(options.target.value_or(kBounds.center), 1.0f);
  const glm::vec2 ndc = glm::vec2(1.0f, -1.0f) * (pixel / glm::vec2(kSize) * 2.0f - 1.0f);
  const glm::vec4 world = glm::inverse(camera.clip_from_view * camera.view_from_world) *
                          glm::vec4(ndc, target_clip.z / target_clip.w, 1.0f);
  return glm::vec3(world) / world.w;
}

/// Cameras all around, some of them parallel.
std::vector<CameraOptions> someCameras() {
  std::vector<CameraOptions> cameras;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(-1.0f, 1.0f);
  for (int i = 0; i < 40; ++i) {
    CameraOptions camera{.azimuth_deg = 180.0f * share(random),
                         .elevation_deg = 80.0f * share(random),
                         .distance = 3.0f + 2.0f * share(random),
                         .target = kBounds.center + glm::vec3(share(random), share(random), share(random))};
    if (i % 4 == 0) camera.orthographic_height = 2.0f + share(random);
    cameras.push_back(camera);
  }
  return cameras;
}

void expectNear(glm::vec2 a, glm::vec2 b, float most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
}

TEST(CameraControl, WhatIsUnderTheHandStaysThereWhileItPans) {
  for (const CameraOptions& camera : someCameras()) {
    const glm::vec2 from(70, 50), to(201, 133);
    const glm::vec3 held = placeUnder(camera, from);
    expectNear(shownAt(camera, held), from, 0.05f);
    expectNear(shownAt(panned(camera, kBounds, to - from, kSize), held), to, 0.2f);
  }
}

TEST(CameraControl, WhatIsUnderThePointerStaysThereWhileItZooms) {
  for (const CameraOptions& camera : someCameras()) {
    const glm::vec2 pointer(250, 30);
    const glm::vec3 held = placeUnder(camera, pointer);
    for (const float factor : {0.8f, 1.25f}) {
      const CameraOptions nearer = zoomed(camera, kBounds, factor, pointer, kSize);
      expectNear(shownAt(nearer, held), pointer, 0.2f);
      if (!camera.orthographic_height)
        EXPECT_NEAR(*nearer.distance, *camera.distance * factor, 1e-4f);
      else
        EXPECT_NEAR(*nearer.orthographic_height, *camera.orthographic_height * factor, 1e-4f);
    }
  }
}

TEST(CameraControl, ZoomsWithinLimitsHoweverOftenItIsAsked) {
  for (const float factor : {0.5f, 2.0f}) {
    CameraOptions camera = someCameras()[1];
    for (int i = 0; i < 200; ++i) camera = zoomed(camera, kBounds, factor, {10, 10}, kSize);
    EXPECT_FLOAT_EQ(*camera.distance, factor < 1.0f ? 1e-3f : 1e3f);
    EXPECT_TRUE(std::isfinite(glm::length(*camera.target)));
  }
}

// The nearest point of the model moves to the right with the hand, and down.
TEST(CameraControl, TheModelTurnsWithTheHand) {
  const CameraOptions camera{.azimuth_deg = 20.0f, .elevation_deg = 10.0f, .distance = 4.0f, .target = kBounds.center};
  const glm::vec3 backward = makeCamera(camera, kBounds, 1.6f).forward * -1.0f;
  const glm::vec3 nearest = kBounds.center + kBounds.radius * backward;
  const glm::vec2 before = shownAt(camera, nearest);
  EXPECT_GT(shownAt(orbited(camera, {12, 0}, kSize), nearest).x, before.x + 5.0f);
  EXPECT_GT(shownAt(orbited(camera, {0, 12}, kSize), nearest).y, before.y + 5.0f);
  EXPECT_FLOAT_EQ(orbited(camera, {-200, 0}, kSize).azimuth_deg, -160.0f) << "half a turn for the shorter side";
  EXPECT_FLOAT_EQ(orbited(camera, {0, 1000}, kSize).elevation_deg, 90.0f);
  EXPECT_FLOAT_EQ(orbited(camera, {0, -1000}, kSize).elevation_deg, -90.0f);
}

TEST(CameraControl, FliesAheadAndLooksAroundFromWhereItStands) {
  const float aspect = 1.6f;
  for (const CameraOptions& camera : someCameras()) {
    if (camera.orthographic_height) continue;
    const Camera before = makeCamera(camera, kBounds, aspect);
    const Camera ahead = makeCamera(flown(camera, kBounds, {0, 0, 0.5f}), kBounds, aspect);
    EXPECT_LT(glm::distance(ahead.position, before.position + 0.5f * kBounds.radius * before.forward), 1e-3f);
    const Camera around = makeCamera(lookedAround(camera, kBounds, {30, 7}, kSize), kBounds, aspect);
    EXPECT_LT(glm::distance(around.position, before.position), 1e-3f);
    EXPECT_LT(glm::dot(around.forward, before.forward), 0.999f);
  }
}

TEST(CameraControl, APlacedCameraShowsTheSamePicture) {
  const Scene teapot = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(teapot);
  for (const bool is_parallel : {false, true}) {
    CameraOptions options;
    if (is_parallel) options.orthographic_height = 0.0f;
    const CameraOptions placed = placedCamera(teapot, bounds, options, 1.6f);
    EXPECT_TRUE(placed.target);
    const Camera given = *framedCamera(teapot, bounds, options, {320, 200});
    const Camera told = *framedCamera(teapot, bounds, placed, {320, 200});
    EXPECT_EQ(given.view_from_world, told.view_from_world);
    EXPECT_EQ(given.clip_from_view, told.clip_from_view);
  }
}

TEST(CameraControl, APlacedCameraLeavesTheGroundThatItHeld) {
  const Scene teapot = *loadModel("teapot");
  const CameraOptions options{
      .ground_reach = 0.5f, .ground_light = glm::vec3(0.6f, 0.8f, 0.0f), .ground_light_turns = true};
  const CameraOptions placed = placedCamera(teapot, boundingSphere(teapot), options, 1.6f);
  EXPECT_EQ(placed.ground_reach, 0.0f);
  EXPECT_EQ(placed.ground_light, glm::vec3(0.0f));
  EXPECT_FALSE(placed.ground_light_turns);
}

TEST(CameraControl, LooksAlongAnAxisAndHoldsAll) {
  const CameraOptions camera = alongAxis(someCameras()[2], AxisView::right);
  EXPECT_FLOAT_EQ(camera.azimuth_deg, 90.0f);
  EXPECT_FALSE(camera.target || camera.distance);
  EXPECT_FLOAT_EQ(alongAxis(camera, AxisView::top).elevation_deg, 90.0f);
}

TEST(CameraControl, AParallelCameraThatLooksAroundGoesRound) {
  CameraOptions parallel{.target = kBounds.center};
  parallel.orthographic_height = 2.0f;
  EXPECT_EQ(lookedAround(parallel, kBounds, {9, 4}, kSize), orbited(parallel, {9, 4}, kSize));
}

TEST(CameraControl, ADistanceBeyondItsLimitsComesBackFromThere) {
  CameraOptions far{.distance = 5000.0f, .target = kBounds.center};
  EXPECT_FLOAT_EQ(*zoomed(far, kBounds, 0.9f, {10, 10}, kSize).distance, 4500.0f);
  EXPECT_FLOAT_EQ(*zoomed(far, kBounds, 1.1f, {10, 10}, kSize).distance, 5000.0f);
}

TEST(CameraControl, ACameraOfTheModelStandsStill) {
  const CameraOptions camera{.name = "door"};
  EXPECT_EQ(orbited(camera, {5, 5}, kSize), camera);
  EXPECT_EQ(panned(camera, kBounds, {5, 5}, kSize), camera);
  EXPECT_EQ(zoomed(camera, kBounds, 2.0f, {5, 5}, kSize), camera);
  EXPECT_EQ(flown(camera, kBounds, {1, 1, 1}), camera);
  EXPECT_TRUE(framingAll(camera).name.empty()) << "but it is left to show all";
}

}  // namespace
}  // namespace mirrorball
