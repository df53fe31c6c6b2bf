#include "mirrorball/render/frame/turntable.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

FrameSettings settingsOf(float azimuth_deg) {
  FrameSettings settings;
  settings.camera.azimuth_deg = azimuth_deg;
  settings.camera.target = glm::vec3(10, 0, 0);
  settings.env_rotation_deg.x = 30.0f;
  settings.lights = {{.position = {10, 5, 2}}};
  return settings;
}

TEST(Turned, TheCameraOrTheEnvironmentAlone) {
  const FrameSettings camera = turned(settingsOf(20.0f), Turn::camera, 90.0f, BoundingSphere{});
  EXPECT_EQ(camera.camera.azimuth_deg, 110.0f);
  EXPECT_EQ(camera.env_rotation_deg.x, 30.0f);
  const FrameSettings environment = turned(settingsOf(20.0f), Turn::environment, 90.0f, BoundingSphere{});
  EXPECT_EQ(environment.camera.azimuth_deg, 20.0f);
  EXPECT_FLOAT_EQ(environment.env_rotation_deg.x, 120.0f);
  EXPECT_EQ(environment.lights[0].position, settingsOf(20.0f).lights[0].position);
}

// A model that turns by 90°, +Z towards +X, shows a camera on +Z what a camera on −X saw of it. The environment and the
// lights stay where the camera has them: the light that stood 2 towards the camera does so still.
TEST(Turned, TheModelBeforeCameraEnvironmentAndLights) {
  const FrameSettings model = turned(settingsOf(0.0f), Turn::model, 90.0f, BoundingSphere{});
  EXPECT_EQ(model.camera.azimuth_deg, -90.0f);
  EXPECT_FLOAT_EQ(model.env_rotation_deg.x, -60.0f);
  EXPECT_LT(glm::distance(model.lights[0].position, glm::dvec3(8, 5, 0)), 1e-5);
}

// A camera that has a distance and no target looks at the model's middle, which may be far from the file's origin.
TEST(Turned, TheModelAboutItsMiddleWithoutATarget) {
  FrameSettings settings = settingsOf(0.0f);
  settings.camera.target.reset();
  settings.camera.distance = 4.0f;
  settings.lights = {{.position = {4400010.0, 5.0, 2.0}}};
  const BoundingSphere bounds{.center = {10, 0, 0}, .radius = 1.0f, .origin = {4400000.0, 0.0, 0.0}};
  const FrameSettings model = turned(settings, Turn::model, 90.0f, bounds);
  EXPECT_LT(glm::distance(model.lights[0].position, glm::dvec3(4400008, 5, 0)), 1e-5);
}

TEST(Turned, TheShadowOfAllButTheCamera) {
  EXPECT_FALSE(turnsShadow(Turn::camera));
  for (const Turn what : {Turn::model, Turn::environment, Turn::object}) EXPECT_TRUE(turnsShadow(what));
}

// The camera and the ground stay where they are while the model grows by what goes round.
TEST(StandingStill, CameraAndGroundStayWhereTheyAre) {
  const Scene scene = meshScene(sphereMesh(8, 16));
  Scene grown = scene;
  grown.instances.push_back({0, glm::translate(glm::mat4(1.0f), glm::vec3(5, 0, 0))});
  FrameSettings settings;
  settings.camera.distance = 4.0f;
  settings.camera.target = glm::vec3(0.1f, 0.2f, 0.3f);
  settings.proxy = *parseProxy("proxy", "ground");
  const BoundingSphere bounds = boundingSphere(scene), others = boundingSphere(grown);
  const auto still = standingStill(settings, scene, bounds, others);
  ASSERT_TRUE(still) << still.error().message;
  EXPECT_LT(glm::distance(makeCamera(still->camera, others, 1.5f).position,
                          makeCamera(settings.camera, bounds, 1.5f).position),
            1e-4f);
  const Proxy before = *placedProxy(settings.proxy, scene), after = *placedProxy(still->proxy, grown);
  EXPECT_EQ(before.captured_at, after.captured_at);
  EXPECT_EQ(before.ground, after.ground);
  EXPECT_EQ(before.radius, after.radius);
  EXPECT_NE(before.captured_at, placedProxy(settings.proxy, grown)->captured_at) << "else nothing is tested";
}

// A ball 2 towards +Z goes to +X of the axis, with the smaller one in it; the other stays.
TEST(Orbited, OneObjectAndWhatLiesInIt) {
  Scene scene = meshScene(sphereMesh(8, 16));
  const auto at = [](glm::vec3 place, float size) {
    return glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(size));
  };
  scene.instances = {{0, at({1, 0, 2}, 1.0f)}, {0, at({1, 0.5f, 2.2f}, 0.3f)}, {0, at({4, 0, 2}, 1.0f)}};
  const std::vector<Instance> moved = orbited(scene, 0, {1, 7, 0}, 90.0f);
  const auto placeOf = [&](std::size_t i) { return glm::vec3(moved[i].world_from_object[3]); };
  EXPECT_LT(glm::distance(placeOf(0), glm::vec3(3, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(placeOf(1), glm::vec3(3.2f, 0.5f, 0)), 1e-5f);
  EXPECT_LT(glm::distance(placeOf(2), glm::vec3(4, 0, 2)), 1e-5f);
}

}  // namespace
}  // namespace mirrorball
