#include "mirrorball/render/frame/picking.h"

#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

class PickingTest : public testing::HeadlessTest {
 protected:
  static Renderer rendererFor(Scene scene) {
    return testing::rendererFor(std::move(scene), Environment([](glm::vec3 d) { return glm::vec3(2.0f + d.y); }, 32));
  }

  static std::optional<Picked> picked(Renderer& renderer, const FrameSettings& settings, glm::vec2 place) {
    EXPECT_TRUE(renderer.draw(settings));
    auto found = renderer.pick(place);
    EXPECT_TRUE(found) << found.error().message;
    return *found;
  }
};

/// Looks at a scene from +Z, two units high, in 64 × 64 pixels.
FrameSettings fromFront(const Renderer& renderer) {
  FrameSettings settings = testing::frontOf(renderer, 64, 2.5f);
  settings.samples = 1;
  return settings;
}

TEST_F(PickingTest, TellsWhatIsSeenThere) {
  Scene scene;
  Material matt, mirror;
  mirror.metallic = 1.0f;
  mirror.perceptual_roughness = 0.0f;
  testing::addBall(scene, {-0.6f, 0.0f, 0.0f}, 0.5f, matt);
  testing::addBall(scene, {0.6f, 0.0f, 0.0f}, 0.5f, mirror);
  Renderer renderer = rendererFor(std::move(scene));
  const FrameSettings settings = fromFront(renderer);
  const float per_unit = 64.0f / 2.5f;
  // Where the mirror's normal leans 30° to the right.
  const glm::vec2 place(32.0f + per_unit * (0.6f + 0.25f), 32.0f);
  const auto found = picked(renderer, settings, place);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->instance, 1u);
  EXPECT_EQ(found->material, 1u);
  const glm::vec3 normal(0.5f, 0.0f, std::sqrt(0.75f));
  EXPECT_LT(glm::distance(found->smooth_normal, normal), 0.02f);
  EXPECT_LT(glm::distance(found->normal, normal), 0.02f);
  EXPECT_LT(glm::distance(found->position, glm::vec3(0.6f, 0.0f, 0.0f) + 0.5f * normal), 0.01f);
  EXPECT_LT(glm::distance(found->reflected, glm::reflect(glm::vec3(0.0f, 0.0f, -1.0f), normal)), 0.04f);
  EXPECT_FALSE(found->refracted);
  const Image radiance = *renderer.radiance();
  EXPECT_EQ(found->radiance, rgbAt(radiance, static_cast<int>(place.x), static_cast<int>(place.y)));
  EXPECT_EQ(picked(renderer, settings, {32.0f - per_unit * 0.6f, 32.0f})->instance, 0u);
  EXPECT_FALSE(picked(renderer, settings, {32.0f, 32.0f})) << "between the balls";
  EXPECT_TRUE(found->triangle);
  EXPECT_FALSE(picked(renderer, settings, {-1.0f, 5.0f}));
  EXPECT_FALSE(picked(renderer, settings, {5.0f, 64.5f}));
}

TEST_F(PickingTest, WhatIsNotDrawnIsNotPicked) {
  // In front of a ball: a sheet that turns its back, one that is cut away, and one that is wholly clear.
  Scene scene;
  testing::addBall(scene, glm::vec3(0.0f), 0.5f, Material());
  const auto addSheet = [&](float z, const Material& material, bool turned) {
    Mesh sheet;
    for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
      sheet.vertices.push_back({.position = {at.x, at.y, 0.0f}, .normal = {0, 0, turned ? -1 : 1}});
    sheet.indices =
        turned ? std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2} : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    sheet.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.instances.push_back(
        {static_cast<int>(scene.meshes.size()), glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, z})});
    scene.meshes.push_back(std::move(sheet));
  };
  Material masked, clear;
  masked.alpha_mode = AlphaMode::mask;
  clear.alpha_mode = AlphaMode::blend;
  masked.opacity = clear.opacity = 0.0f;
  addSheet(0.7f, Material(), true);
  addSheet(0.8f, masked, false);
  addSheet(0.9f, clear, false);
  Renderer renderer = rendererFor(std::move(scene));
  const FrameSettings settings = fromFront(renderer);
  EXPECT_EQ(picked(renderer, settings, {32.5f, 32.5f})->instance, 0u);
  Material seen = renderer.scene().materials[3];
  seen.opacity = 0.5f;
  ASSERT_TRUE(renderer.stage().setMaterial(3, seen));
  EXPECT_EQ(picked(renderer, settings, {32.5f, 32.5f})->instance, 3u);
}

TEST_F(PickingTest, OfReliefThePlaceOfTheRelief) {
  Material bricks;
  bricks.height = HeightKind::brick;
  bricks.height_scale = 0.2f;
  bricks.height_frequency = 1.0f;
  Renderer renderer = rendererFor(meshScene(planeMesh(), bricks));
  FrameSettings settings = fromFront(renderer);
  testing::aim(settings, 20.0f, 50.0f);
  const auto flat = picked(renderer, settings, {30.5f, 30.5f});
  ASSERT_TRUE(flat);
  EXPECT_NEAR(flat->position.y, 0.0f, 1e-5f);
  testing::set(settings, "relief", "exact");
  float deepest = 0.0f;
  for (int y = 20; y < 44; ++y) {
    const auto deep = picked(renderer, settings, {30.5f, static_cast<float>(y) + 0.5f});
    ASSERT_TRUE(deep);
    EXPECT_LE(deep->position.y, 1e-4f);
    EXPECT_NEAR(glm::length(deep->normal), 1.0f, 1e-4f);
    deepest = std::min(deepest, deep->position.y);
  }
  EXPECT_LT(deepest, -0.1f) << "between bricks";
  testing::set(settings, "relief", "geometry");
  EXPECT_FALSE(picked(renderer, settings, {30.5f, 30.5f})->triangle) << "it is none of the plane's";
}

TEST_F(PickingTest, GlassRefractsBySnellsLaw) {
  Material glass = *materialNamed("glass");
  Scene scene = meshScene(sphereMesh(), glass);
  Renderer renderer = rendererFor(std::move(scene));
  const auto found = picked(renderer, fromFront(renderer), {32.0f + 0.5f * 64.0f / 2.5f, 32.0f});
  ASSERT_TRUE(found && found->refracted);
  const float sine = glm::length(glm::cross(found->normal, glm::vec3(0.0f, 0.0f, -1.0f)));
  const float refracted = glm::length(glm::cross(found->normal, *found->refracted));
  EXPECT_NEAR(refracted * glass.ior, sine, 1e-3f);
}

}  // namespace
}  // namespace mirrorball
