#include "mirrorball/trace/surroundings.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using testing::lightOf;
using testing::matt;
using testing::meanOf;
using testing::small;

constexpr float kPi = std::numbers::pi_v<float>;

Proxy placed(const std::string& written) {
  return *placedProxy(*parseProxy("proxy", written), testing::shapeOf("sphere", matt(1.0f)));
}

/// A lamp beside darkness.
Environment lampLight() {
  const glm::vec3 lamp = glm::normalize(glm::vec3(0.6f, 0.5f, 0.4f));
  return Environment([=](glm::vec3 d) { return glm::vec3(glm::dot(d, lamp) > 0.9f ? 20.0f : 0.1f); }, 256);
}

const std::vector<std::string> kEveryProxy{"box:-2,-1.5,-2,3,2,4", "sphere:0.5,0,0,3", "ground:1.5,9", "cube"};

class SurroundingsTest : public ::testing::Test {
 protected:
  Surroundings surroundings(const std::string& proxy, const TraceSettings& settings = {}) const {
    return Surroundings(environment_, lights_, placed(proxy), settings);
  }

  Environment environment_ = lampLight();
  LightSampler lights_ = *LightSampler::make(environment_);
};

// The integral of the density over all directions is 1, and a sample's density is what is seen of its direction.
TEST_F(SurroundingsTest, DensitiesAreThoseOfTheSamples) {
  const glm::vec3 origin(0.3f, -0.2f, 0.4f);
  for (const std::string& proxy : kEveryProxy) {
    const Surroundings around = surroundings(proxy);
    double integral = 0.0;
    constexpr int kCount = 40000;
    for (int i = 0; i < kCount; ++i) {
      SampleSequence numbers(7, static_cast<std::uint32_t>(i));
      const glm::vec2 u = numbers.next();
      const float y = 1.0f - 2.0f * u.x, radius = std::sqrt(1.0f - y * y), angle = 2.0f * kPi * u.y;
      integral += double(around.seen(origin, {radius * std::cos(angle), y, radius * std::sin(angle)}).pdf);
      if (i >= 200) continue;
      const LightSample sample = around.sample(origin, numbers.next());
      EXPECT_NEAR(around.seen(origin, sample.direction).pdf, sample.pdf, 2e-2f * sample.pdf) << proxy;
    }
    EXPECT_NEAR(integral * 4.0 * std::numbers::pi / kCount, 1.0, 0.04) << proxy;
  }
}

// A turned environment is seen turned, whatever it lies on.
TEST_F(SurroundingsTest, TheEnvironmentTurnsOnItsProxy) {
  TraceSettings settings;
  settings.environment_from_world = glm::mat3(glm::rotate(glm::mat4(1.0f), 1.0f, glm::vec3(0, 1, 0)));
  settings.environment_intensity = 2.0f;
  const Surroundings box = surroundings(kEveryProxy[0], settings);
  const Proxy proxy = placed(kEveryProxy[0]);
  const glm::vec3 d = glm::normalize(glm::vec3(0.2f, 0.5f, 0.8f));
  EXPECT_EQ(box.radiance(proxy.captured_at, d), 2.0f * environment_.radiance(settings.environment_from_world * d));
}

/// Within all of the proxies.
Scene smallBall(float albedo) {
  Scene scene = testing::shapeOf("sphere", matt(albedo));
  scene.instances[0].world_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(0.4f));
  return scene;
}

/// From above at an angle, so that ground and model fill the picture.
TracedPicture pictureOnGround(Scene scene, Environment environment, TraceSettings settings) {
  settings.proxy = *parseProxy("proxy", "ground:2");
  const Camera camera =
      makeCamera({.azimuth_deg = 20.0f, .elevation_deg = 50.0f, .distance = 3.0f}, boundingSphere(scene), 1.0f);
  return *PathTracer::make(std::move(scene), std::move(environment))->render(camera, settings);
}

Image tracedOnGround(Scene scene, Environment environment, const TraceSettings& settings) {
  return pictureOnGround(std::move(scene), std::move(environment), settings).radiance;
}

// Wherever its light comes from, all ways to find it find as much.
TEST(SurroundingsOfScenes, EveryStrategyFindsTheSameLight) {
  for (const std::string& proxy : kEveryProxy) {
    TraceSettings settings = small(144);
    settings.proxy = *parseProxy("proxy", proxy);
    settings.shows_environment = false;
    std::vector<float> means;
    for (const LightStrategy strategy : {LightStrategy::both, LightStrategy::light, LightStrategy::surface}) {
      settings.strategy = strategy;
      means.push_back(meanOf(testing::traced(smallBall(0.8f), lampLight(), settings)));
    }
    EXPECT_NEAR(means[1], means[0], 0.025f * means[0]) << proxy;
    EXPECT_NEAR(means[2], means[0], 0.025f * means[0]) << proxy;
  }
}

// Through a hole light comes from far away, and counts once.
TEST(SurroundingsOfScenes, WhatIsSeenThroughAHoleCountsOnce) {
  TraceSettings settings = small(400);
  settings.proxy = *parseProxy("proxy", "plane");
  settings.proxy.captured_at = glm::vec3(0.3f, 1.0f, 0.2f);
  settings.shows_environment = false;
  const float both = meanOf(testing::traced(smallBall(0.8f), lampLight(), settings));
  settings.strategy = LightStrategy::surface;
  EXPECT_NEAR(meanOf(testing::traced(smallBall(0.8f), lampLight(), settings)), both, 0.02f * both);
}

// Of a ground that is left out the shadow is alpha: the share of its light that is missing.
TEST(SurroundingsOfScenes, AShadowAloneIsWhatTheGroundLacks) {
  TraceSettings settings = small(16);
  const auto onGround = [&] { return tracedOnGround(smallBall(0.2f), lightOf(0.5f), settings); };
  const Image whole = onGround();
  settings.shows_environment = false;
  const Image alone = onGround();
  settings.background = glm::vec3(2.0f);
  const Image on_page = onGround();
  int shadowed = 0;
  for (int y = 0; y < alone.height(); ++y)
    for (int x = 0; x < alone.width(); ++x) {
      const float* shadow = alone.texel(x, y);
      // Beside the ball, of which the pixel may hold a part.
      if (shadow[1] != 0.0f || shadow[3] == 1.0f) continue;
      shadowed += shadow[3] > 0.1f;
      EXPECT_NEAR(shadow[3], std::clamp(1.0f - whole.texel(x, y)[1] / 0.5f, 0.0f, 1.0f), 1e-4f) << x << ", " << y;
      EXPECT_NEAR(on_page.texel(x, y)[1], 2.0f * (1.0f - shadow[3]), 1e-4f) << x << ", " << y;
    }
  EXPECT_GT(shadowed, 10);
}

// A shadow that stands alone has an error, too, and paths are spent on it.
TEST(SurroundingsOfScenes, TheNoiseOfAShadowAloneCounts) {
  TraceSettings settings = small(64);
  const auto noise = [&] { return pictureOnGround(smallBall(0.2f), lampLight(), settings).noise; };
  const float shown = noise();
  settings.shows_environment = false;
  const float alone = noise();
  EXPECT_GT(alone, 0.5f * shown);
  settings.background = glm::vec3(1.0f);
  EXPECT_EQ(noise(), alone) << "the page itself has none";
}

TEST(SurroundingsOfScenes, TheFurnaceIsWhiteOnEveryProxy) {
  for (const std::string& proxy : kEveryProxy) {
    TraceSettings settings = small(64);
    settings.bounces = 64;
    settings.proxy = *parseProxy("proxy", proxy);
    const Image image = testing::traced(smallBall(1.0f), lightOf(1.0f), settings);
    testing::expectWhite(image, 4e-3, proxy);
  }
}

// Without anything on it the photographed ground is the photograph.
TEST(SurroundingsOfScenes, AnEmptyGroundIsItsPhotograph) {
  const Image image = tracedOnGround({}, lampLight(), small(16));
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ASSERT_EQ(image.texel(x, y)[0], 0.1f) << x << ", " << y;
}

// A polished ground shows a ball in a dark room as far as Fresnel says, where the mirrored ray meets it, over the light
// that the ball throws on it.
TEST(SurroundingsOfScenes, APolishedGroundMirrorsAShiningBall) {
  TraceSettings settings = small(512);
  settings.size = {32, 32};
  settings.strategy = LightStrategy::surface;  // a lamp so large and near is found best by chance
  settings.proxy = *parseProxy("proxy", "ground:20");
  Material lamp = matt(0.0f);
  lamp.emission = glm::vec3(1.0f);
  const Scene scene = testing::shapeOf("sphere", lamp);
  const Camera camera = makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 40.0f, .orthographic_height = 4.0f},
                                   boundingSphere(scene), 1.0f);
  const auto tracer = PathTracer::make(scene, lightOf(1e-4f));
  const Image matt_ground = tracer->render(camera, settings)->radiance;
  settings.proxy.ground_roughness = 0.0f;
  const Image polished = tracer->render(camera, settings)->radiance;
  const auto added = [&](int begin, int end, int y) {
    double sum = 0.0;
    for (int x = begin; x < end; ++x) sum += double(polished.texel(x, y)[1] - matt_ground.texel(x, y)[1]);
    return sum / (end - begin);
  };
  // Row 27 is 1.4 below the middle: the mirrored ray passes the ball's centre at |2 cos 40° − 1.4|.
  const double share = double(formula::fresnelDielectric(std::sin(glm::radians(40.0f)), formula::kGroundIor));
  EXPECT_NEAR(added(12, 20, 27), share, 0.1 * share);
  EXPECT_NEAR(added(0, 3, 27), 0.0, 0.2 * share) << "beside the ball's image";
}

// The ground darkens by the light that a black ball hides: below it nearly all, far beside it nothing.
TEST(SurroundingsOfScenes, ABlackBallHidesTheLightOfTheGround) {
  TraceSettings settings = small(400);
  for (const LightStrategy strategy : {LightStrategy::both, LightStrategy::light, LightStrategy::surface}) {
    settings.strategy = strategy;
    settings.size = {64, 64};
    settings.samples = 64;
    settings.proxy = *parseProxy("proxy", "ground:2");
    Scene scene = testing::shapeOf("sphere", matt(0.0f));
    // Of a ball of radius 1 that stands on the ground, at a place that is c beside the point of contact: a ball seen
    // at the angle θ from the vertical with the half-angle β hides sin²β cos θ of a level ground's light, as long as
    // all of it is above the horizon.
    const Camera camera =
        makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 90.0f, .distance = 8.0f, .orthographic_height = 8.0f},
                   boundingSphere(scene), 1.0f);
    const Image image = PathTracer::make(std::move(scene), lightOf(1.0f))->render(camera, settings)->radiance;
    for (const int pixel : {50, 56, 60}) {
      double seen = 0.0;  // the mean over places as far away on four sides
      const int other = 63 - pixel;
      for (const auto& [x, y] : {std::pair(pixel, 32), {other, 31}, {31, pixel}, {32, other}})
        seen += 0.25 * double(image.texel(x, y)[1]);
      const double beside = (pixel - 31.5) / 8.0;
      const double away = std::sqrt(beside * beside + 1.0);
      EXPECT_NEAR(seen, 1.0 - 1.0 / (away * away) / away, 0.03) << pixel;
    }
  }
}

}  // namespace
}  // namespace mirrorball
