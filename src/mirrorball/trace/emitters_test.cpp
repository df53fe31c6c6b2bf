#include "mirrorball/trace/emitters.h"

#include <cmath>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using testing::lightOf;
using testing::matt;
using testing::meansOf;

void add(Scene& scene, Mesh mesh, const Material& material, const glm::mat4& world_from_object) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), world_from_object});
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(material);
}

void addFloor(Scene& scene, const Material& material) { add(scene, planeMesh(), material, glm::mat4(1.0f)); }

/// A square lamp that shines downwards, and is not there for rays from above.
void addLamp(Scene& scene, glm::vec3 middle, float side, float radiance) {
  Material material = matt(0.0f);
  material.emission = glm::vec3(radiance);
  const glm::mat4 at_middle = glm::translate(glm::mat4(1.0f), middle);
  const glm::mat4 turned = glm::rotate(at_middle, formula::kPi, glm::vec3(1.0f, 0.0f, 0.0f));
  add(scene, planeMesh(), material, glm::scale(turned, glm::vec3(side / std::sqrt(2.0f))));
}

Image picture(const Scene& scene, float surroundings, const CameraOptions& camera, const TraceSettings& settings) {
  const auto tracer = PathTracer::make(scene, lightOf(surroundings));
  EXPECT_TRUE(tracer) << tracer.error().message;
  auto traced = tracer->render(makeCamera(camera, boundingSphere(scene), 1.0f), settings);
  EXPECT_TRUE(traced) << traced.error().message;
  return std::move(traced->radiance);
}

/// Of a place of the floor alone, at an angle from above.
CameraOptions atOrigin() {
  return {.azimuth_deg = 0.0f, .elevation_deg = 40.0f, .target = glm::vec3(0.0f), .orthographic_height = 0.001f};
}

// A lamp of 2 cm one unit above a matt floor: below it, the irradiance is radiance · area / distance². One path in 8000
// meets it by chance; nearly all the noise that is left is of the place on the lamp.
TEST(Emitters, ASmallLampIsFoundByEveryPath) {
  Scene scene;
  addFloor(scene, matt(0.5f));
  constexpr float kRadiance = 500.0f;
  addLamp(scene, {0.0f, 1.0f, 0.0f}, 0.02f, kRadiance);
  const Image image = picture(scene, 0.0f, atOrigin(), {.size = {16, 16}, .samples = 4, .bounces = 2});
  const float expected = 0.5f / formula::kPi * kRadiance * 0.02f * 0.02f;
  EXPECT_NEAR(meansOf(image).y, expected, 0.01f * expected);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_NEAR(image.texel(x, y)[1], expected, 0.3f * expected) << x << ", " << y;
}

/// A ball and a floor between a lamp and even light, seen so that all are lit by both, as by each other.
Scene litByBoth(const Material& material) {
  Scene scene;
  addFloor(scene, material);
  addLamp(scene, {0.3f, 0.9f, 0.2f}, 0.9f, 15.0f);
  const glm::mat4 of_ball = glm::translate(glm::mat4(1.0f), glm::vec3(-0.3f, 0.3f, 0.0f));
  add(scene, sphereMesh(24, 48), material, glm::scale(of_ball, glm::vec3(0.3f)));
  return scene;
}

// A lamp of 10 000 triangles far from the origin, where floats are coarse: the ray to the chosen one meets it, not its
// neighbour, whose light would be lost.
TEST(Emitters, AFineLampFarAwayLosesNothing) {
  Scene scene;
  const glm::vec3 there(1000.0f, 0.0f, 0.0f);
  const auto addGrid = [&](glm::vec3 middle, float side, float radiance) {
    constexpr int kCells = 70;
    Mesh mesh;
    for (int z = 0; z <= kCells; ++z)
      for (int x = 0; x <= kCells; ++x)
        mesh.vertices.push_back(
            {.position = {float(x) / kCells - 0.5f, 0.0f, float(z) / kCells - 0.5f}, .normal = {0.0f, -1.0f, 0.0f}});
    for (std::uint32_t z = 0; z < kCells; ++z)
      for (std::uint32_t x = 0; x < kCells; ++x) {
        const std::uint32_t a = z * (kCells + 1) + x;
        for (const std::uint32_t corner : {a, a + 1, a + kCells + 1, a + 1, a + kCells + 2, a + kCells + 1})
          mesh.indices.push_back(corner);
      }
    Material material = matt(0.0f);
    material.emission = glm::vec3(radiance);
    add(scene, std::move(mesh), material, glm::scale(glm::translate(glm::mat4(1.0f), middle), glm::vec3(side)));
  };
  add(scene, planeMesh(), matt(0.5f), glm::translate(glm::mat4(1.0f), there));
  addGrid(there + glm::vec3(0.0f, 0.6f, 0.0f), 0.3f, 100.0f);
  TraceSettings settings{.size = {8, 8}, .bounces = 2};
  CameraOptions camera = atOrigin();
  camera.target = there;
  const auto meanBy = [&](LightStrategy strategy, int samples) {
    settings.strategy = strategy;
    settings.samples = samples;
    return meansOf(picture(scene, 0.0f, camera, settings)).y;
  };
  const double by_both = meanBy(LightStrategy::both, 128);
  EXPECT_GT(by_both, 0.5);
  EXPECT_NEAR(by_both, meanBy(LightStrategy::surface, 16384), 0.03 * by_both);
  EXPECT_NEAR(by_both, meanBy(LightStrategy::light, 128), 0.02 * by_both);
}

/// By paths that meet the lamp by chance, and by those that choose it.
void expectSameMeans(const Scene& scene, TraceSettings settings, const std::string& what) {
  settings.size = {24, 24};
  settings.shows_environment = false;
  const auto meanBy = [&](LightStrategy strategy, int samples) {
    settings.strategy = strategy;
    settings.samples = samples;
    return meansOf(picture(scene, 2.0f, {.azimuth_deg = 20.0f, .elevation_deg = 60.0f}, settings)).y;
  };
  const double by_surface = meanBy(LightStrategy::surface, 2048);
  EXPECT_NEAR(meanBy(LightStrategy::both, 128), by_surface, 0.02 * by_surface) << what;
}

TEST(Emitters, AreAsBrightByEachStrategy) {
  Material plastic = matt(0.7f);
  plastic.specular = 1.0f;
  plastic.perceptual_roughness = 0.3f;
  Material metal = plastic;
  metal.metallic = 1.0f;
  Material coated = matt(0.7f);
  coated.clearcoat = 1.0f;
  Material cloth = matt(0.3f);
  cloth.sheen_color = glm::vec3(0.8f);
  cloth.sheen_roughness = 0.5f;
  Material glass = plastic;
  glass.transmission = 1.0f;
  for (const auto& [name, material] : {std::pair("matt", matt(0.7f)),
                                       {"plastic", plastic},
                                       {"metal", metal},
                                       {"coated", coated},
                                       {"cloth", cloth},
                                       {"glass", glass}})
    expectSameMeans(litByBoth(material), {.bounces = 6}, name);
}

// On the ground of the environment, too, which shows none of it where something is in the way.
TEST(Emitters, LightTheGroundAsBrightByEachStrategy) {
  Scene scene;
  addLamp(scene, {0.0f, 0.9f, 0.0f}, 0.9f, 15.0f);
  const glm::mat4 of_ball = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.3f, 0.0f));
  add(scene, sphereMesh(24, 48), matt(0.5f), glm::scale(of_ball, glm::vec3(0.3f)));
  TraceSettings settings{.bounces = 4};
  settings.proxy.kind = ProxyKind::ground;
  expectSameMeans(scene, settings, "matt ground");
  settings.proxy.ground_roughness = 0.3f;
  expectSameMeans(scene, settings, "polished ground");
}

}  // namespace
}  // namespace mirrorball
