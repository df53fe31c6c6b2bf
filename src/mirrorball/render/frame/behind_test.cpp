// What is seen through glass.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/bsdf.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

constexpr float kIor = 1.5f;
constexpr float kGlassWide = 2.6f;  ///< what pictures show, in world units

struct LampBehind {
  glm::vec3 middle;
  float radius;
  glm::vec3 light;
};

/// Behind the unit ball of glass, and beside its refracted picture.
const std::vector<LampBehind> kLamps{{{0.5f, 0.3f, -2.6f}, 0.9f, {2.0f, 0.3f, 0.1f}},
                                     {{-0.9f, -0.5f, -2.2f}, 0.5f, {0.1f, 0.4f, 2.0f}}};

/// The distance to a ball from outside, or from inside if it is at the origin of the ray; infinite: it is not met.
float distanceTo(glm::vec3 middle, float radius, glm::vec3 origin, glm::vec3 d) {
  const glm::vec3 to = origin - middle;
  const float along = glm::dot(to, d);
  const float root = along * along - glm::dot(to, to) + radius * radius;
  if (root <= 0.0f) return INFINITY;
  for (const float distance : {-along - std::sqrt(root), -along + std::sqrt(root)})
    if (distance > 1e-4f) return distance;
  return INFINITY;
}

glm::vec3 lightOutside(glm::vec3 origin, glm::vec3 d) {
  float nearest = INFINITY;
  glm::vec3 light = testing::smoothRadiance(d);
  for (const LampBehind& lamp : kLamps) {
    const float distance = distanceTo(lamp.middle, lamp.radius, origin, d);
    if (distance >= nearest) continue;
    nearest = distance;
    light = lamp.light;
  }
  return light;
}

/// The light that comes through the ball of glass along a ray in it, and what it reflects to and fro.
glm::vec3 lightInside(glm::vec3 origin, glm::vec3 d, int bounces) {
  const glm::vec3 place = origin + distanceTo(glm::vec3(0.0f), 1.0f, origin, d) * d;
  const glm::vec3 n = -glm::normalize(place);
  const float fresnel = formula::fresnelDielectric(-glm::dot(d, n), 1.0f / kIor);
  glm::vec3 light(0.0f);
  if (fresnel < 1.0f) light += (1.0f - fresnel) * lightOutside(place, glm::refract(d, n, kIor));
  if (bounces > 0) light += fresnel * lightInside(place, glm::reflect(d, n), bounces - 1);
  return light;
}

/// What the eye sees of the ball in a parallel ray; nothing beside it.
glm::vec3 lightOfBall(glm::vec2 across) {
  const glm::vec3 n(across, std::sqrt(1.0f - glm::dot(across, across)));
  const glm::vec3 d(0, 0, -1);
  const float fresnel = formula::fresnelDielectric(n.z, kIor);
  return fresnel * lightOutside(n, glm::reflect(d, n)) +
         (1.0f - fresnel) * lightInside(n, glm::refract(d, n, 1.0f / kIor), 4);
}

Scene glassBeforeLamps() {
  Scene scene;
  Material glass;
  glass.base_color = glm::vec3(1.0f);
  glass.transmission = 1.0f;
  glass.perceptual_roughness = 0.0f;
  glass.ior = kIor;
  testing::addBall(scene, glm::vec3(0.0f), 1.0f, glass, 48);
  for (const LampBehind& lamp : kLamps) {
    Material shining;
    shining.base_color = glm::vec3(0.0f);
    shining.specular = 0.0f;
    shining.perceptual_roughness = 1.0f;
    shining.emission = lamp.light;
    testing::addBall(scene, lamp.middle, lamp.radius, shining, 48);
  }
  return scene;
}

FrameSettings frontOfGlass(const Renderer& renderer) { return testing::frontOf(renderer, 64, kGlassWide); }

class BehindTest : public gl::GlTest {};

MIRRORBALL_WITH_BOTH_APIS(BehindTest);

/// Of the ball but for its rim.
double psnrToGlassTruth(const Image& image) {
  double squares = 0.0;
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const auto placeOf = [&](glm::vec2 within) {
        return ((glm::vec2(x, image.height() - 1 - y) + within) / float(image.width()) - 0.5f) * kGlassWide;
      };
      if (glm::length(placeOf(glm::vec2(0.5f))) > 0.9f) continue;
      glm::vec3 truth(0.0f);
      for (int sample = 0; sample < 16; ++sample)
        truth += lightOfBall(placeOf((glm::vec2(sample % 4, sample / 4) + 0.5f) / 4.0f)) / 16.0f;
      const glm::vec3 difference = rgbAt(image, x, y) - truth;
      squares += double(glm::dot(difference, difference)) / 3.0;
      ++count;
    }
  return -10.0 * std::log10(squares / count);
}

TEST_P(BehindTest, GlassShowsWhatIsBehindIt) {
  Renderer renderer = testing::rendererFor(glassBeforeLamps(), Environment(testing::smoothRadiance, 256));
  FrameSettings settings = frontOfGlass(renderer);
  testing::set(settings, "refraction", "image-space");
  testing::set(settings, "probe-size", "64");
  testing::set(settings, "probe-bounces", "1");
  const auto psnr = [&](const char* behind, const char* probes) {
    testing::set(settings, "behind", behind);
    testing::set(settings, "probes", probes);
    const auto image = renderer.renderRadiance(settings);
    EXPECT_TRUE(image) << image.error().message;
    return psnrToGlassTruth(*image);
  };
  EXPECT_LT(psnr("probes", "0"), 3.0) << "without probes, what is far away";
  EXPECT_LT(psnr("far", "1"), 3.0);
  EXPECT_GT(psnr("probes", "1"), 16.5);
  EXPECT_GT(psnr("screen", "0"), 24.0);
}

// Towards its rim Newton's method takes more steps to the back faces, none of which may be halved.
TEST_P(BehindTest, TheSearchForABallsBackFacesEndsOnThem) {
  Scene scene = glassBeforeLamps();
  scene.instances.resize(1);
  Renderer renderer = testing::rendererFor(scene, Environment(testing::smoothRadiance, 64));
  FrameSettings settings = frontOfGlass(renderer);
  settings.samples = 1;
  settings.inner_bounces = 1;
  settings.refraction = RefractionKind::image_space;
  const auto searched = renderer.renderRadiance(settings);
  settings.refraction = RefractionKind::traced;
  const auto traced = renderer.renderRadiance(settings);
  ASSERT_TRUE(searched && traced);
  float largest = 0.0f;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      if (glm::length((glm::vec2(x, y) + 0.5f) / 64.0f - 0.5f) * kGlassWide < 0.98f)
        largest = std::max(largest, glm::distance(rgbAt(*searched, x, y), rgbAt(*traced, x, y)));
  EXPECT_LT(largest, 5e-3f);
}

// Beside the picture there is nothing that a copy of it could show.
TEST_P(BehindTest, WhatIsNotInThePictureIsNotSeenThroughGlass) {
  Renderer renderer = testing::rendererFor(glassBeforeLamps(), Environment(testing::smoothRadiance, 64));
  FrameSettings settings = frontOfGlass(renderer);
  settings.size = {24, 24};
  settings.camera.orthographic_height = 0.3f / renderer.bounds().radius;
  settings.camera.target = glm::vec3(-0.1f, 0.7f, 0.0f);
  settings.camera.elevation_deg = 20.0f;
  testing::set(settings, "refraction", "image-space");
  const auto far = renderer.renderRadiance(settings);
  testing::set(settings, "behind", "screen");
  const auto screen = renderer.renderRadiance(settings);
  ASSERT_TRUE(far && screen);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      ASSERT_LT(glm::distance(rgbAt(*far, x, y), rgbAt(*screen, x, y)), 1e-5f) << x << ", " << y;
}

/// The middle of a picture of a ball of glass in white light, with another half as large in it.
glm::vec3 middleWithin(const Material& inner, const char* behind) {
  Scene scene = glassBeforeLamps();
  scene.instances.resize(1);
  testing::addBall(scene, glm::vec3(0.0f), 0.5f, inner, 48);
  Renderer renderer = testing::rendererFor(scene, Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64));
  FrameSettings settings = frontOfGlass(renderer);
  settings.size = {33, 33};
  testing::set(settings, "refraction", "image-space");
  testing::set(settings, "behind", behind);
  const auto image = renderer.renderRadiance(settings);
  EXPECT_TRUE(image) << image.error().message;
  return rgbAt(*image, 16, 16);
}

TEST_P(BehindTest, GlassShowsWhatIsInIt) {
  Material shining;
  shining.base_color = glm::vec3(0.0f);
  shining.specular = 0.0f;
  shining.perceptual_roughness = 1.0f;
  shining.emission = {3.0f, 0.0f, 0.0f};
  EXPECT_NEAR(middleWithin(shining, "far").g, 1.0f, 1e-2f) << "which the picture alone knows of";
  const glm::vec3 lit = middleWithin(shining, "screen");
  const float fresnel = formula::fresnelDielectric(1.0f, kIor);
  EXPECT_NEAR(lit.r, fresnel + (1.0f - fresnel) * 3.0f, 2e-2f);
  EXPECT_NEAR(lit.g, fresnel, 1e-2f);
}

// As water in a glass: it is drawn first, though it is no nearer.
TEST_P(BehindTest, ABodyIsSeenThroughTheOneThatItLiesIn) {
  Material red;
  red.base_color = glm::vec3(1.0f);
  red.transmission = 1.0f;
  red.perceptual_roughness = 0.0f;
  red.ior = kIor;  // so that nothing is reflected between the two
  red.attenuation_color = {0.5f, 0.1f, 0.1f};
  red.attenuation_distance = 1.0f;
  EXPECT_NEAR(middleWithin(red, "far").g, 1.0f, 1e-2f);
  const glm::vec3 seen = middleWithin(red, "screen");
  const float fresnel = formula::fresnelDielectric(1.0f, kIor);
  EXPECT_NEAR(seen.r, fresnel + (1.0f - fresnel) * 0.5f, 2e-2f);
  EXPECT_NEAR(seen.g, fresnel + (1.0f - fresnel) * 0.1f, 2e-2f);
}

/// It reflects, and lets nothing through.
Material darkWater() {
  Material water;
  water.base_color = glm::vec3(0.0f);
  water.transmission = 1.0f;
  water.perceptual_roughness = 0.0f;
  water.ior = 1.33f;
  return water;
}

// What a surface reflects depends on what light meets it from: water in glass reflects a fifth of what it does in air.
TEST_P(BehindTest, ABodyIsMetFromTheOneThatItLiesIn) {
  const Material dark_water = darkWater();
  const glm::vec3 seen = middleWithin(dark_water, "screen");
  const float of_glass = formula::fresnelDielectric(1.0f, kIor);
  const float of_water = formula::fresnelDielectric(1.0f, dark_water.ior / kIor);
  EXPECT_NEAR(seen.g, of_glass + (1.0f - of_glass) * of_water, 2e-3f);
}

TEST_P(BehindTest, ABodyThatHasLeftAnotherOneIsMetFromAir) {
  const Material dark_water = darkWater();
  Scene scene = glassBeforeLamps();
  scene.instances.resize(1);
  testing::addBall(scene, glm::vec3(0.0f), 0.5f, dark_water, 48);
  Renderer renderer = testing::rendererFor(scene, Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64));
  FrameSettings settings = frontOfGlass(renderer);
  settings.size = {33, 33};
  testing::set(settings, "refraction", "image-space");
  testing::set(settings, "behind", "screen");
  ASSERT_TRUE(renderer.renderRadiance(settings));
  std::vector<Instance> apart = scene.instances;
  apart[0].world_from_object[3].x = 10.0f;
  ASSERT_TRUE(renderer.moveInstances(apart));
  settings.camera.orthographic_height = kGlassWide / renderer.bounds().radius;
  const auto image = renderer.renderRadiance(settings);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_NEAR(rgbAt(*image, 16, 16).g, formula::fresnelDielectric(1.0f, dark_water.ior), 2e-3f);
}

// All there is to be seen lies in one plane, and so does its box.
TEST_P(BehindTest, AFlatWallIsSeenWithoutHoles) {
  Scene scene = glassBeforeLamps();
  scene.instances.resize(1);
  Material shining = scene.materials[1];
  shining.emission = glm::vec3(2.0f);
  shining.double_sided = true;
  Mesh wall = planeMesh();
  wall.material = static_cast<int>(scene.materials.size());
  for (Vertex& vertex : wall.vertices) vertex.position = {4.0f * vertex.position.x, 4.0f * vertex.position.z, -2.0f};
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::mat4(1.0f)});
  scene.meshes.push_back(std::move(wall));
  scene.materials.push_back(shining);
  Renderer renderer = testing::rendererFor(scene, Environment([](glm::vec3) { return glm::vec3(0.0f); }, 64));
  FrameSettings settings = frontOfGlass(renderer);
  settings.behind = BehindKind::screen;
  settings.refraction = RefractionKind::image_space;
  const auto picture = renderer.renderRadiance(settings);
  ASSERT_TRUE(picture) << picture.error().message;
  for (int y = 26; y < 38; ++y)
    for (int x = 26; x < 38; ++x) ASSERT_GT(picture->texel(x, y)[0], 1.6f) << x << ", " << y;
}

TEST_P(BehindTest, TheFurnaceIsWhite) {
  Scene scene = glassBeforeLamps();
  for (std::size_t i = 1; i < scene.materials.size(); ++i) scene.materials[i].emission = glm::vec3(1.0f);
  for (const float roughness : {0.0f, 0.5f}) {
    scene.materials[0].perceptual_roughness = roughness;
    Renderer renderer = testing::rendererFor(scene, Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64));
    FrameSettings settings = frontOfGlass(renderer);
    settings.size = {32, 32};
    testing::set(settings, "behind", "screen");
    testing::set(settings, "refraction", "image-space");
    testing::expectFurnaceWhite(*renderer.renderRadiance(settings), "roughness " + std::to_string(roughness), 3e-3f);
  }
}

}  // namespace
}  // namespace mirrorball
