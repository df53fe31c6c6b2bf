// Environments that are near, on the GPU; their formulas are tested in scene/proxy/proxy_test.cpp, their light in
// trace/surroundings_test.cpp.

#include "mirrorball/scene/proxy/proxy.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/render/light/ground_shadow.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// A pattern on the walls of a room, smooth enough for texels.
glm::vec3 lightOfWall(glm::vec3 place) { return 0.5f + 0.4f * glm::sin(glm::vec3(2.0f, 1.7f, 2.3f) * place); }

constexpr glm::vec3 kLow(-2.0f, -1.5f, -2.5f);
constexpr glm::vec3 kHigh(3.0f, 2.0f, 2.0f);
constexpr glm::vec3 kCapturedAt(0.5f, 0.2f, -0.3f);
constexpr const char* kRoom = "box:-2,-1.5,-2.5,3,2,2";

/// The room as a map that was captured in it.
Environment capturedRoom() {
  return Environment([](glm::vec3 d) { return lightOfWall(formula::hitOfBox(kLow, kHigh, kCapturedAt, d).place); },
                     512);
}

Material mirrorOfProxy() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = 0.0f;
  return material;
}

/// A mirror ball of this radius at that place.
Scene ballAt(glm::vec3 place, float radius, const Material& material) {
  Scene scene = meshScene(sphereMesh(), material);
  scene.instances[0].world_from_object = glm::scale(glm::translate(glm::mat4(1.0f), place), glm::vec3(radius));
  return scene;
}

/// From +Z, 2.5 radii wide.
FrameSettings frontOf(int size) {
  FrameSettings settings;
  settings.size = {size, size};
  settings.samples = 4;
  settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .orthographic_height = 2.5f};
  settings.resolve = Resolve::radiance;
  settings.background = BackgroundKind::transparent;
  return settings;
}

class ProxyTest : public testing::HeadlessTest {
 protected:
  static Image drawn(Scene scene, Environment environment, const FrameSettings& settings) {
    Renderer renderer = testing::rendererFor(std::move(scene), std::move(environment));
    return testing::drawn(renderer, settings);
  }
};

// Against the room itself, met by each reflected ray.
TEST_F(ProxyTest, AMirrorBallBesideTheCaptureShowsTheRoom) {
  constexpr int kSize = 96;
  constexpr float kRadius = 0.6f;
  const glm::vec3 place(1.5f, -0.5f, 0.6f);
  FrameSettings settings = frontOf(kSize);
  testing::set(settings, "proxy", kRoom);
  testing::set(settings, "captured-at", "0.5,0.2,-0.3");
  const Image image = drawn(ballAt(place, kRadius, mirrorOfProxy()), capturedRoom(), settings);
  double squares = 0.0, of_far = 0.0;
  int count = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 across = (glm::vec2(x, kSize - 1 - y) + 0.5f) / float(kSize) * 2.5f - 1.25f;
      if (glm::length(across) > 0.95f) continue;
      const glm::vec3 n(across, std::sqrt(1.0f - glm::dot(across, across)));
      const glm::vec3 r = glm::reflect(glm::vec3(0, 0, -1), n);
      const glm::vec3 truth = lightOfWall(formula::hitOfBox(kLow, kHigh, place + kRadius * n, r).place);
      const glm::vec3 far = lightOfWall(formula::hitOfBox(kLow, kHigh, kCapturedAt, r).place);
      squares += double(glm::dot(rgbAt(image, x, y) - truth, rgbAt(image, x, y) - truth)) / 3.0;
      of_far += double(glm::dot(far - truth, far - truth)) / 3.0;
      ++count;
    }
  const auto psnr = [&](double sum) { return -10.0 * std::log10(sum / count); };
  EXPECT_GT(psnr(squares), 40.0);
  EXPECT_LT(psnr(of_far), 20.0) << "without its proxy the room looks as right: nothing was tested";
}

TEST_F(ProxyTest, TrianglesShowWhatTheBoxDoes) {
  FrameSettings settings = frontOf(48);
  testing::set(settings, "proxy", "cube");
  const Box sides = boundingBox(meshScene(cubeMesh()));
  const auto room = Environment([](glm::vec3 d) { return 0.5f + 0.5f * d; }, 128);
  const Image of_triangles = drawn(ballAt({0.1f, 0.1f, 0.0f}, 0.3f, mirrorOfProxy()), room, settings);
  const auto corner = [](glm::vec3 c) { return writeNumbers({&c.x, 3}); };
  testing::set(settings, "proxy", "box:" + corner(sides.low) + "," + corner(sides.high));
  const Image of_box = drawn(ballAt({0.1f, 0.1f, 0.0f}, 0.3f, mirrorOfProxy()), room, settings);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      EXPECT_NEAR(glm::distance(rgbaAt(of_triangles, x, y), rgbaAt(of_box, x, y)), 0.0f, 5e-3f) << x << ", " << y;
}

// The background's proxy and the surface's map were once in one texture unit, which made the ball black.
TEST_F(ProxyTest, ASphereMapShowsWhatIsInfinitelyFarAway) {
  FrameSettings settings = frontOf(32);
  settings.background = BackgroundKind::environment;
  settings.mapping = Mapping::sphere;
  const auto light = Environment([](glm::vec3 d) { return 0.6f + 0.3f * d; }, 64);
  const auto picture = [&](const char* proxy) {
    testing::set(settings, "proxy", proxy);
    return drawn(ballAt(glm::vec3(0.0f), 1.0f, mirrorOfProxy()), light, settings);
  };
  const Image far = picture("none");
  EXPECT_GT(rgbaAt(far, 16, 16).x, 0.5f);
  for (const char* proxy : {"ground:2", "cube", "box:-2,-2,-2,2,2,2"}) {
    const Image near = picture(proxy);
    for (int y = 12; y < 20; ++y)
      for (int x = 12; x < 20; ++x) EXPECT_EQ(rgbaAt(near, x, y), rgbaAt(far, x, y)) << proxy << " " << x << ", " << y;
  }
}

TEST_F(ProxyTest, TheFurnaceIsWhiteOnEveryProxy) {
  const auto white = Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64);
  for (const std::string proxy : {"box:-2,-2,-2,2,2,2", "sphere:0,0,0,2", "ground:2", "cube"})
    for (const float roughness : {0.0f, 0.4f}) {
      Material metal = mirrorOfProxy();
      metal.perceptual_roughness = roughness;
      FrameSettings settings = frontOf(32);
      testing::set(settings, "proxy", proxy);
      // On a ground the ball's own shadow is to be seen in it.
      const bool has_shadow = proxy == "ground:2";
      const Image image = drawn(ballAt(glm::vec3(0.0f), 0.3f, metal), white, settings);
      for (int y = 0; y < (has_shadow ? 12 : 32); ++y)
        for (int x = 0; x < 32; ++x) {
          const glm::vec4 texel = rgbaAt(image, x, y);
          if (texel.w < 1.0f) continue;
          EXPECT_NEAR(texel.x, 1.0f, 2e-3f) << proxy << " at " << x << ", " << y;
        }
    }
}

// A ray that passes a small sphere touches it at most: it sees the nearest place of it, as sharply as it is.
TEST_F(ProxyTest, BesideASmallSphereTheBackgroundIsSmooth) {
  constexpr int kSize = 48;
  const auto light = [](glm::vec3 d) { return 0.5f + 0.4f * glm::sin(glm::vec3(9.0f, 8.0f, 7.0f) * d); };
  FrameSettings settings = frontOf(kSize);
  settings.samples = 1;
  settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .distance = 4.0f, .fov_deg = 90.0f};
  settings.background = BackgroundKind::environment;
  testing::set(settings, "proxy", "sphere:0,0,0,0.5");
  const Image image = drawn(ballAt(glm::vec3(0.0f), 1.0f, mirrorOfProxy()), Environment(light, 256), settings);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 at = (glm::vec2(x, kSize - 1 - y) + 0.5f) / (0.5f * float(kSize)) - 1.0f;
      const glm::vec3 eye(0.0f, 0.0f, 4.0f);
      const glm::vec3 nearest = formula::nearestToCapture(eye, glm::normalize(glm::vec3(at, -1.0f)), glm::vec3(0.0f));
      if (glm::length(nearest) < 1.1f) continue;
      const glm::vec3 shown(image.texel(x, y)[0], image.texel(x, y)[1], image.texel(x, y)[2]);
      ASSERT_LT(glm::distance(shown, light(glm::normalize(nearest))), 0.02f) << x << ", " << y;
    }
}

/// The ground that a ball of radius 1 stands on, from above: an eighth of a unit a pixel.
FrameSettings groundFromAbove() {
  FrameSettings settings;
  settings.size = {64, 64};
  settings.samples = 1;
  settings.resolve = Resolve::radiance;
  settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 90.0f, .distance = 8.0f, .orthographic_height = 8.0f};
  testing::set(settings, "proxy", "ground:2");
  return settings;
}

// The share of a level ground's light that a ball hides, standing on it: sin² β cos θ, the ball being seen at the angle
// θ from the vertical with half-angle β.
TEST_F(ProxyTest, ABallThrowsItsShadowOnTheGround) {
  const auto white = Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64);
  const Image image = drawn(ballAt(glm::vec3(0.0f), 1.0f, mirrorOfProxy()), white, groundFromAbove());
  for (const int pixel : {44, 48, 52}) {
    double seen = 0.0;
    const int other = 63 - pixel;
    for (const auto& [x, y] : {std::pair(pixel, 32), {other, 31}, {31, pixel}, {32, other}})
      seen += 0.25 * double(image.texel(x, y)[1]);
    const double beside = (pixel - 31.5) / 8.0;
    const double away = std::sqrt(beside * beside + 1.0);
    EXPECT_NEAR(seen, 1.0 - 1.0 / (away * away * away), 0.04) << pixel;
  }
}

// A body that does not bend light hides nothing of the ground: what its shadow lacks, rays bring.
TEST_F(ProxyTest, ABodyLikeAirThrowsNoShadow) {
  const auto white = Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64);
  Material air;
  air.base_color = glm::vec3(1.0f);
  air.transmission = 1.0f;
  air.ior = 1.0f;
  air.perceptual_roughness = 0.0f;
  const Image image = drawn(ballAt(glm::vec3(0.0f), 1.0f, air), white, groundFromAbove());
  double sum = 0.0;
  for (int x = 40; x < 64; ++x) {
    EXPECT_NEAR(image.texel(x, 32)[1], 1.0f, 0.15f) << x;
    sum += double(image.texel(x, 32)[1]);
  }
  EXPECT_NEAR(sum / 24.0, 1.0, 0.03);
}

// Light passes the backs of what has only a front, in whatever direction it goes: as on the way to the eye.
TEST_F(ProxyTest, ASheetThrowsAShadowWhereTheGroundSeesItsFront) {
  const auto white = [] { return Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64); };
  const auto brightnessBelow = [&](bool faces_ground, bool is_double_sided) {
    Scene scene;
    Material material;
    material.double_sided = is_double_sided;
    const glm::mat4 above = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.5f, 0.0f));
    scene.meshes.push_back(planeMesh());
    scene.instances.push_back(
        {0, faces_ground ? glm::rotate(above, formula::kPi, glm::vec3(1.0f, 0.0f, 0.0f)) : above});
    scene.materials.push_back(material);
    // Foot of the scene, far away.
    scene.meshes.push_back(planeMesh());
    scene.instances.push_back(
        {1, glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(9.0f, 0.0f, 0.0f)), glm::vec3(0.01f))});
    scene.meshes[1].edit().material = 0;
    FrameSettings settings;
    settings.size = {33, 33};
    settings.samples = 1;
    settings.resolve = Resolve::radiance;
    settings.camera = {.azimuth_deg = 0.0f, .elevation_deg = 5.0f, .distance = 0.4f, .target = glm::vec3(0.0f)};
    testing::set(settings, "proxy", "ground:2");
    return drawn(std::move(scene), white(), settings).texel(16, 16)[1];
  };
  EXPECT_GT(brightnessBelow(false, false), 0.99f);
  const float below_front = brightnessBelow(true, false);
  EXPECT_LT(below_front, 0.6f);
  EXPECT_NEAR(brightnessBelow(true, true), below_front, 0.01f);
  EXPECT_NEAR(brightnessBelow(false, true), below_front, 0.01f);
}

// Texels of the shadow are no stairs, though most lights of a sun come from one direction.
TEST_F(ProxyTest, TheShadowOfAStraightEdgeIsStraight) {
  Scene scene;
  scene.materials.emplace_back().double_sided = true;
  scene.meshes.push_back(planeMesh());
  const glm::mat4 above = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 1.0f, 0.0f));
  scene.instances.push_back({0, glm::rotate(above, glm::radians(20.0f), glm::vec3(0.0f, 1.0f, 0.0f))});
  scene.meshes.push_back(planeMesh());  // foot of the scene, far away
  scene.instances.push_back(
      {1, glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(9.0f, 0.0f, 0.0f)), glm::vec3(0.01f))});
  const glm::vec3 sun = glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f));
  Environment sunny([=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > std::cos(0.01f) ? 1e5f : 0.01f); }, 512);
  FrameSettings settings;
  settings.size = {64, 64};
  settings.samples = 1;
  settings.resolve = Resolve::radiance;
  // 13 texels of the shadow, each of 5 pixels, around a place of its edge.
  const float radius = boundingSphere(scene).radius;
  const float texel = 2.0f * GroundShadow::kModelRadii * radius / GroundShadow::kSize;
  settings.camera = {.azimuth_deg = 0.0f,
                     .elevation_deg = 90.0f,
                     .target = glm::vec3(-1.316f, 0.0f, 1.179f),
                     .orthographic_height = 12.8f * texel / radius};
  testing::set(settings, "proxy", "ground:2");
  const Image image = drawn(std::move(scene), std::move(sunny), settings);
  // What is lit of each column.
  std::vector<double> lit(64, 0.0);
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 64; ++y) lit[std::size_t(x)] += double(image.texel(x, y)[1]) / 0.01;
  EXPECT_GT(lit[63] - lit[31], 8.0) << "the edge is there";
  for (std::size_t x = 32; x < 64; ++x) EXPECT_LT(std::abs(lit[x] - lit[x - 1]), 0.8) << x << ": a stair";
}

// Bad input is one line.
TEST_F(ProxyTest, AMapThatWasCapturedElsewhereIsRefused) {
  FrameSettings settings = frontOf(16);
  testing::set(settings, "proxy", kRoom);
  testing::set(settings, "captured-at", "9,0,0");
  Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 64);
  const auto prepared = testing::prepareOnce(white);
  auto renderer = testing::rendererOf(ballAt({}, 1.0f, mirrorOfProxy()), std::move(white), *prepared);
  const auto image = renderer->renderRadiance(settings);
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, ::testing::HasSubstr("not within its proxy"));
}

TEST(GroundLights, AreAllTheLightOfALevelGround) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.3f, 0.5f, 0.2f));
  const Environment environment(
      [=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > std::cos(0.01f) ? 3e4f : 1.0f); }, 2048);
  const auto sampler = LightSampler::make(environment);
  const GroundLights ground = groundLights(environment, *sampler, glm::mat3(1.0f), 256);
  glm::vec3 share(0.0f);
  float of_sun = 0.0f;
  for (const GroundLight& light : ground.lights) {
    share += light.share;
    EXPECT_GT(light.direction.y, 0.0f);
    if (glm::dot(light.direction, sun) > 0.999f) of_sun += light.share.y;
  }
  EXPECT_NEAR(share.x, 1.0f, 1e-4f);
  // E / π of the sky is 1, that of the sun its radiance times θ² times the cosine.
  const float from_sun = 3e4f * 0.01f * 0.01f * sun.y;
  EXPECT_NEAR(ground.irradiance.y, 1.0f + from_sun, 0.1f * (1.0f + from_sun));
  EXPECT_NEAR(of_sun, from_sun / (1.0f + from_sun), 0.1f);
  const auto elsewhere = std::count_if(ground.lights.begin(), ground.lights.end(), [&](const GroundLight& light) {
    return glm::dot(light.direction, sun) < 0.999f;
  });
  EXPECT_GT(elsewhere, 128) << "the sky's soft shadow is of many lights, too";
}

}  // namespace
}  // namespace mirrorball
