#include "mirrorball/scene/camera/camera.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/projection.h"

namespace mirrorball {
namespace {

glm::vec3 ndc(const Camera& camera, glm::vec3 world) {
  const glm::vec4 clip = camera.clip_from_view * camera.view_from_world * glm::vec4(world, 1.0f);
  return glm::vec3(clip) / clip.w;
}

void expectNear(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

TEST(Camera, AnglesStandWhereTheConventionSays) {
  const BoundingSphere unit;
  const auto at = [&](float azimuth, float elevation) {
    return makeCamera({.azimuth_deg = azimuth, .elevation_deg = elevation, .distance = 3.0f}, unit, 1.0f).position;
  };
  expectNear(at(0, 0), {0, 0, 3});
  expectNear(at(90, 0), {3, 0, 0});
  expectNear(at(0, 90), {0, 3, 0});
  expectNear(at(180, 0), {0, 0, -3});
}

TEST(Camera, OnPlusZHasPlusXOnTheRightAndPlusYUp) {
  const Camera camera = makeCamera({.azimuth_deg = 0, .elevation_deg = 0}, {}, 1.0f);
  EXPECT_GT(ndc(camera, {0.5f, 0, 0}).x, 0.1f);
  EXPECT_GT(ndc(camera, {0, 0.5f, 0}).y, 0.1f);
  expectNear(camera.forward, {0, 0, -1});
}

TEST(Camera, FromAboveAndBelowStillHasAnUp) {
  for (const float elevation : {90.0f, -90.0f}) {
    const Camera camera = makeCamera({.azimuth_deg = 0, .elevation_deg = elevation}, {}, 1.0f);
    EXPECT_GT(ndc(camera, {0, 0, elevation > 0 ? -0.5f : 0.5f}).y, 0.1f);
  }
}

TEST(Camera, DefaultFramesTheModelInBothOrientations) {
  const BoundingSphere bounds{{1, 2, 3}, 10.0f};
  for (const float aspect : {16.0f / 9.0f, 1.0f, 0.5f}) {
    const Camera camera = makeCamera({}, bounds, aspect);
    float widest = 0.0f;
    for (int step = 0; step < 720; ++step) {
      // The silhouette lies on the cone about the axis to the centre: its points nearest to the picture's sides count.
      const float angle = glm::radians(static_cast<float>(step) / 2.0f);
      const glm::vec3 right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 1, 0)));
      const glm::vec3 up = glm::cross(right, camera.forward);
      const glm::vec3 p = ndc(camera, bounds.center + bounds.radius * (right * std::cos(angle) + up * std::sin(angle)));
      widest = std::max({widest, std::abs(p.x), std::abs(p.y)});
      EXPECT_LT(std::abs(p.z), 1.0f) << "cut by the near or far plane";
    }
    EXPECT_LT(widest, 1.0f);
    EXPECT_GT(widest, 0.8f);
  }
}

TEST(Camera, OrthographicHeightTwoInscribesTheSphere) {
  const BoundingSphere bounds{{0, 1, 0}, 4.0f};
  CameraOptions options{.azimuth_deg = 0, .elevation_deg = 0};
  options.orthographic_height = 2.0f;
  const Camera camera = makeCamera(options, bounds, 1.0f);
  expectNear(ndc(camera, {4, 1, 0}), {1, 0, 0}, 1e-4f);
  expectNear(ndc(camera, {0, 5, 0}), {0, 1, 0}, 1e-4f);
}

TEST(Camera, WithoutAnOrthographicHeightTheBallFillsThePicture) {
  const BoundingSphere bounds{{0, 1, 0}, 4.0f};
  CameraOptions options{.azimuth_deg = 0, .elevation_deg = 0};
  options.orthographic_height = 0.0f;
  EXPECT_NEAR(ndc(makeCamera(options, bounds, 2.0f), {0, 5, 0}).y, 1.0f / 1.06f, 1e-5f);
  EXPECT_NEAR(ndc(makeCamera(options, bounds, 0.5f), {4, 1, 0}).x, 1.0f / 1.06f, 1e-5f);
}

// Upwards in OpenGL's pictures is down in ours, and t of its table: no face is mirrored, which would turn its triangles
// inside out.
TEST(CubeFaceCamera, SeesItsFaceWithTUpwards) {
  const glm::vec3 position(3, -4, 5);
  for (int face = 0; face < 6; ++face) {
    const Camera camera = cubeFaceCamera(face, position, {0.01f, 10.0f});
    EXPECT_NEAR(glm::determinant(glm::mat3(camera.view_from_world)), 1.0f, 1e-6f) << face;
    expectNear(camera.forward, formula::cubePoint(face, {0.5f, 0.5f}));
    for (const glm::vec2 st : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0.25f, 0.875f), glm::vec2(1, 1)}) {
      const glm::vec3 seen = ndc(camera, position + 2.0f * formula::cubePoint(face, st));
      expectNear(seen, {2.0f * st.x - 1.0f, 2.0f * st.y - 1.0f, seen.z});
      EXPECT_LT(std::abs(seen.z), 1.0f);
    }
  }
}

TEST(DepthsAround, HoldTheWholeScene) {
  const BoundingSphere bounds{{1, 2, 3}, 10.0f};
  const DepthRange inside = depthsAround({1, 2, 8}, bounds);
  EXPECT_GE(inside.farthest, 15.0f);
  EXPECT_NEAR(inside.nearest, inside.farthest * 1e-4f, 1e-6f);
  // In a corner of a face a point at distance 40 has the depth 40 / √3.
  const DepthRange outside = depthsAround({1, 2, 53}, bounds);
  EXPECT_GE(outside.farthest, 60.0f);
  EXPECT_LE(outside.nearest, 40.0f / std::sqrt(3.0f));
  EXPECT_GT(outside.nearest, 20.0f);
}

TEST(DepthsAround, BeginWhereTheyAreTold) {
  EXPECT_EQ(depthsAround({0, 0, 0}, {}, 0.25f).nearest, 0.25f);
  const DepthRange beyond = depthsAround({0, 0, 0}, {}, 100.0f);
  EXPECT_EQ(beyond.nearest, 100.0f);
  EXPECT_GT(beyond.farthest, beyond.nearest) << "nothing is seen, but the camera is a camera";
}

// A mirror image is seen at the pixel of what the mirror camera sees.
TEST(MirroredBelow, SeesEachPlaceWhereTheGroundShowsIt) {
  const BoundingSphere bounds{{0.5f, 1.0f, -0.25f}, 1.5f};
  constexpr float kGround = -0.5f;
  for (const bool is_orthographic : {false, true}) {
    CameraOptions options{.azimuth_deg = 20.0f, .elevation_deg = 25.0f};
    if (is_orthographic) options.orthographic_height = 3.0f;
    const Camera camera = makeCamera(options, bounds, 1.5f);
    const Camera below = mirroredBelow(camera, kGround, bounds);
    for (const glm::vec3 place : {glm::vec3(0.1f, 0.3f, 0.2f), glm::vec3(1.2f, 1.9f, -0.5f)}) {
      const glm::vec3 image(place.x, 2.0f * kGround - place.y, place.z);
      const auto pixel = [](const Camera& of, glm::vec3 at) {
        const glm::vec4 clip = of.clip_from_view * of.view_from_world * glm::vec4(at, 1.0f);
        return glm::vec3(clip) / clip.w;
      };
      EXPECT_NEAR(glm::distance(glm::vec2(pixel(below, place)), glm::vec2(pixel(camera, image))), 0.0f, 1e-5f);
      EXPECT_LT(std::abs(pixel(below, place).z), 1.0f) << "within its depths";
    }
  }
}

}  // namespace
}  // namespace mirrorball
