#include "mirrorball/render/light/ground_caustics.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/render/light/count_smoothing.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball {
namespace {

constexpr int kSize = 128;
constexpr float kHalf = 4.0f;  // of the picture's side

Material glassOf(float ior) {
  Material glass;
  glass.base_color = glm::vec3(1.0f);
  glass.perceptual_roughness = 0.0f;
  glass.transmission = 1.0f;
  glass.ior = ior;
  return glass;
}

/// A ball of radius 1 around the world's middle.
Scene ballOf(const Material& material) {
  Scene scene;
  testing::addBall(scene, glm::vec3(0.0f), 1.0f, material, 64);
  return scene;
}

/// Its light on the ground at height −1, around the world's middle.
Image causticsOf(const Scene& scene, const Environment& sky) {
  const auto geometry = Geometry::make(scene);
  const auto sampler = LightSampler::make(sky, {}, 512);
  const std::vector<Box> boxes(scene.instances.size(), Box{glm::vec3(-1.0f), glm::vec3(1.0f)});
  return groundCaustics({scene, *geometry, boxes}, {sky, *sampler, glm::mat3(1.0f)}, -1.0f, {0.0f, 0.0f, kHalf}, kSize);
}

Environment sunAt(glm::vec3 towards) {
  return Environment([=](glm::vec3 d) { return glm::vec3(glm::dot(d, towards) > std::cos(0.01f) ? 1e5f : 0.0f); },
                     1024);
}

/// The mean of what is within a distance of a place, x and z.
float meanAround(const Image& image, glm::vec2 place, float radius, int channel = 1) {
  float sum = 0.0f;
  int count = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 at = (glm::vec2(x, y) + 0.5f) * (2.0f * kHalf / float(kSize)) - kHalf;
      if (glm::distance(at, place) > radius) continue;
      sum += image.texel(x, y)[channel];
      ++count;
    }
  return sum / float(count);
}

const glm::vec3 kTowards = glm::normalize(glm::vec3(0.5f, 1.0f, 0.25f));
const glm::vec2 kBelow = -glm::vec2(kTowards.x, kTowards.z) / kTowards.y;  // where the ray through the middle lands

// A body that does not bend light throws no shadow: what its picture lacks comes back in the same place.
TEST(GroundCaustics, ABodyLikeAirSendsAllLightStraightOn) {
  const Image image = causticsOf(ballOf(glassOf(1.0f)), sunAt(kTowards));
  EXPECT_NEAR(meanAround(image, kBelow, 0.8f), 1.0f, 0.03f);
  EXPECT_NEAR(meanAround(image, -3.0f * kBelow, 0.2f), 0.0f, 0.01f);
}

// A ball is a lens: what falls on its middle meets near its focus, 1.5 radii from there, and is bright around it.
TEST(GroundCaustics, ABallOfGlassGathersASun) {
  const Image image = causticsOf(ballOf(glassOf(1.5f)), sunAt(kTowards));
  EXPECT_GT(meanAround(image, kBelow, 0.2f), 4.0f);
  EXPECT_LT(meanAround(image, 1.7f * kBelow, 0.1f), 0.6f);
  // No light is lost but what is reflected upwards: 9.2 % of what falls on a ball at its first surface.
  const float disc = formula::kPi / kTowards.y;
  const float all = meanAround(image, glm::vec2(0.0f), kHalf) * formula::kPi * kHalf * kHalf / disc;
  EXPECT_GT(all, 0.85f);
  EXPECT_LT(all, 0.95f);
}

TEST(GroundCaustics, GlassThatAbsorbsColoursItsLight) {
  Material red = glassOf(1.5f);
  red.base_color = glm::vec3(1.0f, 0.25f, 0.0f);
  const Image image = causticsOf(ballOf(red), sunAt(kTowards));
  const auto atFocus = [&](int channel) { return meanAround(image, kBelow, 0.2f, channel); };
  EXPECT_NEAR(atFocus(1) / atFocus(0), 0.0625f, 0.01f) << "by two surfaces";
  EXPECT_LT(atFocus(2) / atFocus(0), 0.01f);
}

TEST(GroundCaustics, WhatIsSolidSendsNone) {
  Material matt;
  Scene scene = ballOf(matt);
  EXPECT_FALSE(hasCaustics(scene));
  testing::addBall(scene, glm::vec3(0.0f), 0.5f, glassOf(1.5f), 32);
  EXPECT_TRUE(hasCaustics(scene));
  const Image image = causticsOf(scene, sunAt(kTowards));
  for (const float light : image.samples()) EXPECT_EQ(light, 0.0f) << "the glass lies within what is solid";
}

TEST(CountSmoothing, LeavesWhatIsDenseAndSpreadsWhatIsSparse) {
  Image picture(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 32; ++x) {
      picture.texel(x, y)[1] = x % 2 == 0 ? 1.0f : 3.0f;
      picture.texel(x, y)[3] = 100.0f;
    }
  picture.texel(48, 32)[1] = 64.0f;  // one ray
  picture.texel(48, 32)[3] = 1.0f;
  Image smooth = picture;
  smoothByCount(smooth);
  for (int x = 0; x < 28; ++x) EXPECT_EQ(smooth.texel(x, 32)[1], picture.texel(x, 32)[1]) << x;
  EXPECT_LT(smooth.texel(48, 32)[1], 1.0f);
  EXPECT_GT(smooth.texel(52, 32)[1], 0.01f);
}

}  // namespace
}  // namespace mirrorball
