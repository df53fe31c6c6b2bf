#include "mirrorball/scene/camera/framing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/mesh_file/positions.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// What a picture shows of a scene, from −1 to 1 on each axis.
struct Outline {
  glm::dvec2 min{1e9};
  glm::dvec2 max{-1e9};
  bool is_before_camera = true;

  double halfExtent() const { return std::max({-min.x, -min.y, max.x, max.y}); }
};

void add(Outline& outline, const Scene& scene, const Camera& camera) {
  const glm::dmat4 clip_from_world = glm::dmat4(camera.clip_from_view) * glm::dmat4(camera.view_from_world);
  forEachPosition(scene, glm::dmat4(1.0), [&](glm::dvec3 position) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(position, 1.0);
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    outline.min = glm::min(outline.min, ndc);
    outline.max = glm::max(outline.max, ndc);
    outline.is_before_camera = outline.is_before_camera && std::abs(clip.z) <= clip.w;
  });
}

Outline outlineOf(const Scene& scene, const CameraOptions& options, float aspect) {
  const BoundingSphere bounds = boundingSphere(scene);
  Outline outline;
  add(outline, scene, makeCamera(framed(scene, bounds, options, aspect), bounds, aspect));
  return outline;
}

/// Expects that it touches the border on one axis, stays inside of it on the other, and lies in the middle.
void expectFilled(const Outline& outline, const std::string& what) {
  EXPECT_NEAR(outline.halfExtent(), 15.0 / 16.0, 2e-4) << what;
  EXPECT_NEAR(outline.min.x, -outline.max.x, 2e-4) << what;
  EXPECT_NEAR(outline.min.y, -outline.max.y, 2e-4) << what;
  EXPECT_TRUE(outline.is_before_camera) << what;
}

Scene moved(Scene scene) {
  glm::mat4 place(1.0f);
  place[0] = glm::vec4(3, 0, 0, 0);  // three times as wide
  place[3] = glm::vec4(100, -50, 30, 1);
  for (Instance& instance : scene.instances) instance.world_from_object = place * instance.world_from_object;
  return scene;
}

TEST(Framed, EveryModelFillsThePictureFromEverywhere) {
  for (const char* name : {"teapot", "cube", "plane", "showcase"}) {
    const Scene scene = *loadModel(name);
    for (const float aspect : {16.0f / 9.0f, 1.0f, 0.4f})
      for (const glm::vec2 angles : {glm::vec2(30, 15), glm::vec2(0, 0), glm::vec2(200, -60), glm::vec2(77, 90)})
        for (const float fov : {5.0f, 35.0f, 80.0f}) {
          const CameraOptions options{.azimuth_deg = angles.x, .elevation_deg = angles.y, .fov_deg = fov};
          const std::string what = std::string(name) + " " + std::to_string(aspect) + " " + std::to_string(angles.x) +
                                   " " + std::to_string(fov);
          expectFilled(outlineOf(scene, options, aspect), what);
          expectFilled(outlineOf(moved(scene), options, aspect), what + " moved");
        }
  }
}

TEST(Framed, AParallelProjectionIsFilledToo) {
  const Scene scene = moved(*loadModel("teapot"));
  CameraOptions options{.azimuth_deg = 40.0f, .elevation_deg = 25.0f};
  options.orthographic_height = 0.0f;
  for (const float aspect : {16.0f / 9.0f, 0.4f}) expectFilled(outlineOf(scene, options, aspect), "parallel");
}

TEST(Framed, ATargetIsInTheMiddleAndTheModelInThePicture) {
  const Scene scene = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(scene);
  CameraOptions options;
  options.target = bounds.center + glm::vec3(0.5f, 0.2f, 0.0f);
  EXPECT_NEAR(outlineOf(scene, options, 1.5f).halfExtent(), 15.0 / 16.0, 1e-4);
  // The same float, which is written with fewer digits.
  EXPECT_EQ(glm::vec3(*framed(scene, bounds, options, 1.5f).target), glm::vec3(*options.target));
  // Before the model, and behind it: the camera still looks at it.
  for (const float side : {-5.0f, 5.0f}) {
    options = {.azimuth_deg = 0.0f, .elevation_deg = 0.0f};
    options.target = bounds.center + glm::vec3(0, 0, side);
    const CameraOptions chosen = framed(scene, bounds, options, 1.5f);
    EXPECT_GT(*chosen.distance, 0.0f);
    EXPECT_LE(outlineOf(scene, options, 1.5f).halfExtent(), 15.0 / 16.0 + 1e-4);
  }
}

TEST(Framed, WhatIsToldStaysAsItIs) {
  const Scene scene = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(scene);
  CameraOptions options;
  options.distance = 3.0f;
  EXPECT_EQ(framed(scene, bounds, options, 1.0f).distance, 3.0f);
  EXPECT_FALSE(framed(scene, bounds, options, 1.0f).target.has_value());
  options.distance = {};
  options.orthographic_height = 2.0f;
  EXPECT_EQ(framed(scene, bounds, options, 1.0f).orthographic_height, 2.0f);
  EXPECT_FALSE(framed(Scene{}, {}, CameraOptions{}, 1.0f).distance.has_value()) << "there is nothing to fill it with";
}

// From no azimuth does a turntable's model leave the picture, and from some it touches the border.
TEST(Framed, AWholeTurnHasOneFraming) {
  const Scene scene = moved(*loadModel("teapot"));
  const BoundingSphere bounds = boundingSphere(scene);
  for (const float elevation : {0.0f, 20.0f, -70.0f, 90.0f})
    for (const bool is_parallel : {false, true}) {
      CameraOptions options{.elevation_deg = elevation};
      if (is_parallel) options.orthographic_height = 0.0f;
      options = framed(scene, bounds, options, 1.5f, FramingOf::whole_turn);
      Outline outline;
      for (int degree = 0; degree < 360; ++degree) {
        options.azimuth_deg = static_cast<float>(degree);
        add(outline, scene, makeCamera(options, bounds, 1.5f));
      }
      EXPECT_NEAR(outline.halfExtent(), 15.0 / 16.0, 1e-3) << elevation;
      EXPECT_NEAR(outline.min.x, -outline.max.x, 2e-3) << elevation;
      EXPECT_NEAR(outline.min.y, -outline.max.y, 2e-3) << elevation;
    }
}

/// Where the scene's points throw their shadows on the ground below it, in the
/// picture of a camera.
Outline shadowIn(const Camera& camera, const Scene& scene, glm::dvec3 towards_light) {
  const glm::dmat4 clip_from_world = glm::dmat4(camera.clip_from_view) * glm::dmat4(camera.view_from_world);
  const double ground = double(boundingBox(scene).low.y);
  Outline outline;
  forEachPosition(scene, glm::dmat4(1.0), [&](glm::dvec3 position) {
    position -= towards_light * ((position.y - ground) / towards_light.y);
    const glm::dvec4 clip = clip_from_world * glm::dvec4(position, 1.0);
    outline.min = glm::min(outline.min, glm::dvec2(clip) / clip.w);
    outline.max = glm::max(outline.max, glm::dvec2(clip) / clip.w);
  });
  return outline;
}

glm::vec3 lightAt(float azimuth_deg, float elevation_deg) {
  const float a = glm::radians(azimuth_deg), e = glm::radians(elevation_deg);
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

TEST(Framed, ALowSunsShadowIsInThePicture) {
  const Scene scene = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(scene);
  for (const float aspect : {0.5f, 1.0f, 1.78f})
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
      CameraOptions options{.ground_reach = 0.5f, .ground_light = lightAt(float(azimuth), 20.0f)};
      const glm::dvec3 light(options.ground_light);
      const Camera camera = makeCamera(framed(scene, bounds, options, aspect), bounds, aspect);
      EXPECT_LE(shadowIn(camera, scene, light).halfExtent(), 0.9376) << azimuth;
      options.ground_light = glm::vec3(0.0f);
      const Camera without = makeCamera(framed(scene, bounds, options, aspect), bounds, aspect);
      if (azimuth % 180 == 120) EXPECT_GT(shadowIn(without, scene, light).halfExtent(), 1.0) << "from the side";
    }
}

TEST(Framed, AHighSunOrOneBelowChangesNothing) {
  const Scene scene = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(scene);
  const CameraOptions without{.ground_reach = 0.5f};
  for (const float elevation : {90.0f, 75.0f, 0.0f, -20.0f}) {
    CameraOptions options = without;
    options.ground_light = lightAt(100.0f, elevation);
    EXPECT_EQ(framed(scene, bounds, options, 1.5f).distance, framed(scene, bounds, without, 1.5f).distance);
    EXPECT_EQ(framed(scene, bounds, options, 1.5f).target, framed(scene, bounds, without, 1.5f).target);
  }
}

TEST(Framed, ALowSunDoesNotMakeTheModelADot) {
  const Scene scene = *loadModel("teapot");
  const BoundingSphere bounds = boundingSphere(scene);
  const float without = *framed(scene, bounds, {.ground_reach = 0.5f}, 1.5f).distance;
  for (const bool light_turns : {false, true}) {
    const CameraOptions options{
        .ground_reach = 0.5f, .ground_light = lightAt(120.0f, 5.0f), .ground_light_turns = light_turns};
    const float distance = *framed(scene, bounds, options, 1.5f).distance;
    EXPECT_GT(distance, 1.2f * without);
    EXPECT_LT(distance, 3.0f * without);
  }
}

/// A box upon the ground.
Scene boxScene(glm::vec3 half_extents) {
  Scene scene = *loadModel("cube");
  const Box box = boundingBox(scene);
  const glm::vec3 scale = 2.0f * half_extents / (box.high - box.low);
  for (Instance& instance : scene.instances)
    instance.world_from_object = glm::scale(glm::mat4(1.0f), scale) * instance.world_from_object;
  return scene;
}

// By steps of a fiftieth of a degree, none is more than a fiftieth of the distance.
TEST(Framed, ASunThatSetsMovesTheCameraWithoutAJump) {
  const Scene scene = boxScene({0.8f, 0.6f, 0.5f});
  const BoundingSphere bounds = boundingSphere(scene);
  for (const bool light_turns : {false, true}) {
    CameraOptions options{.ground_reach = 0.5f, .ground_light_turns = light_turns};
    CameraOptions before = framed(scene, bounds, options, 1.5f);
    const auto step_to = [&](float elevation_deg) {
      options.ground_light = lightAt(120.0f, elevation_deg);
      const CameraOptions now = framed(scene, bounds, options, 1.5f);
      EXPECT_NEAR(*now.distance / *before.distance, 1.0f, 0.02f) << elevation_deg;
      EXPECT_LT(glm::distance(*now.target, *before.target), 0.05f * bounds.radius) << elevation_deg;
      before = now;
    };
    for (const float elevation : {-1.0f, 0.0f, 1e-30f, 1e-3f}) step_to(elevation);
    for (int step = 1; step < 600; ++step) step_to(0.02f * float(step));
  }
}

// As in turntables of the camera and of the environment; a thin box throws its longest shadow past the border when the
// light comes from another side than at first.
TEST(Framed, AShadowStaysInThePictureOfAWholeTurn) {
  for (const Scene& scene : {*loadModel("teapot"), boxScene({1.0f, 0.5f, 0.1f}), boxScene({2.0f, 0.5f, 0.05f})}) {
    const BoundingSphere bounds = boundingSphere(scene);
    for (const float first : {0.0f, 70.0f, 90.0f}) {
      CameraOptions options{.elevation_deg = 40.0f, .ground_reach = 0.5f, .ground_light = lightAt(first, 25.0f)};
      CameraOptions turned = framed(scene, bounds, options, 1.5f, FramingOf::whole_turn);
      options.ground_light_turns = true;
      const CameraOptions standing = framed(scene, bounds, options, 1.5f);
      for (int degree = 0; degree < 360; degree += 15) {
        turned.azimuth_deg = float(degree);
        EXPECT_LE(shadowIn(makeCamera(turned, bounds, 1.5f), scene, options.ground_light).halfExtent(), 0.942)
            << degree;
        EXPECT_LE(shadowIn(makeCamera(standing, bounds, 1.5f), scene, lightAt(float(degree), 25.0f)).halfExtent(),
                  0.942)
            << degree;
      }
    }
  }
}

// As in a turntable of the model: camera and light go round it together.
TEST(Framed, AShadowStaysInThePictureOfAModelThatTurns) {
  const Scene scene = boxScene({2.0f, 0.5f, 0.05f});
  const BoundingSphere bounds = boundingSphere(scene);
  for (const float beside : {0.0f, 45.0f, 90.0f}) {
    const CameraOptions options{.azimuth_deg = 0.0f,
                                .elevation_deg = 40.0f,
                                .ground_reach = 0.5f,
                                .ground_light = lightAt(beside, 25.0f),
                                .ground_light_turns = true};
    CameraOptions turned = framed(scene, bounds, options, 1.5f, FramingOf::whole_turn);
    for (int degree = 0; degree < 360; degree += 5) {
      turned.azimuth_deg = float(degree);
      const glm::vec3 light = lightAt(float(degree) + beside, 25.0f);
      EXPECT_LE(shadowIn(makeCamera(turned, bounds, 1.5f), scene, light).halfExtent(), 0.942) << degree;
    }
  }
}

// To rounding: the sine of one elevation differs by azimuth.
TEST(Framed, ALightThatTurnsLeavesTheCameraWhereItIs) {
  const Scene scene = boxScene({2.0f, 0.5f, 0.05f});
  const BoundingSphere bounds = boundingSphere(scene);
  for (const FramingOf what : {FramingOf::still, FramingOf::whole_turn}) {
    CameraOptions options{.ground_reach = 0.5f, .ground_light = lightAt(0.0f, 15.0f), .ground_light_turns = true};
    const CameraOptions first = framed(scene, bounds, options, 1.5f, what);
    for (const float azimuth : {10.0f, 90.0f, 200.0f}) {
      options.ground_light = lightAt(azimuth, 15.0f);
      const CameraOptions other = framed(scene, bounds, options, 1.5f, what);
      EXPECT_NEAR(*other.distance, *first.distance, 1e-5f * *first.distance) << azimuth;
      EXPECT_LT(glm::distance(*other.target, *first.target), 1e-5f) << azimuth;
    }
  }
}

// A ball's radius is less than half of its box's diagonal, by √3.
TEST(Framed, HoldsALowSunsShadowAsFarAsItIsDrawn) {
  const Scene scene = *loadModel("sphere");
  const BoundingSphere bounds = boundingSphere(scene);
  const auto half_width = [&](bool light_turns) {
    CameraOptions options{.azimuth_deg = 0.0f,
                          .elevation_deg = 0.0f,
                          .ground_reach = 0.5f,
                          .ground_light = lightAt(90.0f, 6.0f),
                          .ground_light_turns = light_turns,
                          .orthographic_height = 0.0f};
    options.target = bounds.center;
    return *framed(scene, bounds, options, 1.0f).orthographic_height / 2.0f * (15.0f / 16.0f);
  };
  for (const bool light_turns : {false, true}) {
    EXPECT_LE(half_width(light_turns), 4.01f);
    EXPECT_GE(half_width(light_turns), 3.8f);
  }
}

TEST(Framed, WhatHasNoExtentIsStillBeforeTheCamera) {
  Mesh line;
  line.vertices.resize(3);
  line.vertices[1].position = glm::vec3(0, 0, 1);
  line.vertices[2].position = glm::vec3(0, 0, -1);
  line.indices = {0, 1, 2};
  const Scene scene = meshScene(line);
  const CameraOptions options{.azimuth_deg = 0.0f, .elevation_deg = 0.0f};
  EXPECT_GT(*framed(scene, boundingSphere(scene), options, 1.0f).distance, 1.0f);
  EXPECT_TRUE(outlineOf(scene, options, 1.0f).is_before_camera);
}

}  // namespace
}  // namespace mirrorball
