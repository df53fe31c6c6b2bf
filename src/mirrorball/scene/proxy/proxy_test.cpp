#include "mirrorball/scene/proxy/proxy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/prefilter.h"
#include "mirrorball/scene/mesh_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

ProxyOptions parsed(std::string_view written) { return parseProxy("--proxy", written).value(); }

Proxy placed(std::string_view written, const Scene& scene = {}) { return placedProxy(parsed(written), scene).value(); }

/// Directions all around.
std::vector<glm::vec3> directions() {
  std::vector<glm::vec3> all;
  for (int i = 0; i < 200; ++i) {
    const glm::vec2 u = formula::sampleOffset(i, 200);
    const float y = 1.0f - 2.0f * u.x;
    const float angle = 6.2831853f * u.y;
    all.emplace_back(std::sqrt(1.0f - y * y) * std::cos(angle), y, std::sqrt(1.0f - y * y) * std::sin(angle));
  }
  return all;
}

constexpr std::string_view kEveryProxy[] = {"box:-2,-1,-3,4,3,2", "sphere:0.5,0,0,3", "ground:1.5,9", "cube"};

TEST(Proxy, IsWrittenAsItIsRead) {
  for (const std::string_view written :
       {"none", "box:-2,0,-2,2,3,2", "sphere:0,1,0,5", "ground", "ground:1.6", "ground:1.6,20", "room.glb"})
    EXPECT_EQ(writtenProxy(parsed(written)), written);
}

TEST(Proxy, SaysWhatItTakes) {
  for (const auto& [written, says] : std::vector<std::pair<std::string_view, std::string_view>>{
           {"box:1,2,3", "6 numbers"},
           {"box:1,0,0,0,1,1", "from its lower to its higher corner"},
           {"sphere:0,0,0,-1", "a radius above 0"},
           {"ground:-1", "above the ground"},
           {"ground:2,1", "larger than the height"},
           {"", "takes box"}}) {
    const auto proxy = parseProxy("--proxy", written);
    ASSERT_FALSE(proxy) << written;
    EXPECT_THAT(proxy.error().message, HasSubstr(says));
    EXPECT_EQ(proxy.error().message.find('\n'), std::string::npos);
  }
}

TEST(Proxy, ARayMeetsItOnItsWay) {
  const glm::vec3 origin(0.2f, 0.1f, -0.3f);
  for (const std::string_view written : kEveryProxy) {
    const Proxy proxy = placed(written);
    for (const glm::vec3& d : directions()) {
      const formula::ProxyHit hit = hitOf(proxy, origin, d);
      EXPECT_NEAR(glm::distance(hit.place, origin + hit.distance * d), 0.0f, 1e-5f) << written;
      EXPECT_NEAR(glm::length(hit.normal), 1.0f, 1e-5f) << written;
      EXPECT_GT(hit.distance, 0.0f) << written;
    }
  }
}

TEST(Proxy, FromTheCaptureTheMapIsAsItIs) {
  for (const std::string_view written : kEveryProxy) {
    const Proxy proxy = placed(written);
    for (const glm::vec3& d : directions()) {
      const formula::ProxySight sight = sightFrom(proxy, proxy.captured_at, d);
      EXPECT_NEAR(glm::distance(sight.direction, d), 0.0f, 2e-6f) << written;
      EXPECT_NEAR(sight.enlargement, 1.0f, 1e-4f) << written;
    }
  }
}

// The solid angle of a small triangle of directions, here and there.
TEST(Proxy, SolidAnglesGrowAsItSays) {
  const auto solidAngle = [](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return 0.5f * glm::length(glm::cross(b - a, c - a));
  };
  const glm::vec3 origin(0.3f, -0.2f, 0.4f);
  for (const std::string_view written : kEveryProxy) {
    const Proxy proxy = placed(written);
    int compared = 0;
    for (const glm::vec3& d : directions()) {
      constexpr float kStep = 2e-3f;
      const glm::vec3 across = glm::normalize(glm::cross(d, glm::vec3(0.3f, 0.5f, -0.7f)));
      const glm::vec3 b = glm::normalize(d + kStep * across);
      const glm::vec3 c = glm::normalize(d + kStep * glm::cross(d, across));
      const auto seen = [&](glm::vec3 direction) { return sightFrom(proxy, origin, direction); };
      // At an edge the three see different sides.
      if (hitOf(proxy, origin, d).normal != hitOf(proxy, origin, b).normal && proxy.kind != ProxyKind::sphere) continue;
      if (hitOf(proxy, origin, d).normal != hitOf(proxy, origin, c).normal && proxy.kind != ProxyKind::sphere) continue;
      const float there = solidAngle(seen(d).direction, seen(b).direction, seen(c).direction);
      EXPECT_NEAR(there / solidAngle(d, b, c), seen(d).enlargement, 0.02f * seen(d).enlargement) << written;
      ++compared;
    }
    EXPECT_GT(compared, proxy.kind == ProxyKind::ground ? 50 : 150) << written;
  }
}

TEST(Proxy, TrianglesOfABoxAreTheBox) {
  const Proxy box = placed("box:-1,-1,-1,1,1,1");
  const Proxy cube = placed("cube");
  const Box sides = boundingBox(meshScene(cubeMesh()));
  const glm::vec3 half = sides.high;
  const glm::vec3 origin(0.1f, 0.3f, -0.2f);
  for (const glm::vec3& d : directions())
    EXPECT_NEAR(glm::distance(hitOf(box, origin / half, d).place * half, hitOf(cube, origin, d).place), 0.0f, 2e-5f);
}

TEST(Proxy, AHoleIsInfinitelyFarAway) {
  ProxyOptions options = parsed("plane");
  options.captured_at = glm::vec3(0.0f, 1.0f, 0.0f);
  const Proxy plane = placedProxy(options, {}).value();
  const glm::vec3 upwards = glm::normalize(glm::vec3(0.3f, 0.8f, 0.1f));
  EXPECT_EQ(sightFrom(plane, glm::vec3(0.2f, 2.0f, 0.1f), upwards).direction, upwards);
}

TEST(Proxy, APlaceOutsideCountsAsTheNearestWithin) {
  const Proxy box = placed("box:-1,-1,-1,1,1,1");
  const glm::vec3 d = glm::normalize(glm::vec3(-1.0f, 0.2f, 0.1f));
  EXPECT_EQ(sightFrom(box, {5.0f, 0.5f, 0.25f}, d).direction, sightFrom(box, {1.0f, 0.5f, 0.25f}, d).direction);
  EXPECT_FALSE(box.holds({5.0f, 0.5f, 0.25f}));
  EXPECT_TRUE(box.holds({0.9f, 0.5f, 0.25f}));
}

TEST(Proxy, TheModelStandsOnTheGround) {
  Scene scene = meshScene(sphereMesh());
  scene.instances[0].world_from_object[3] = glm::vec4(3.0f, 5.0f, 1.0f, 1.0f);
  const Proxy ground = placed("ground:2", scene);
  EXPECT_NEAR(ground.ground, 4.0f, 1e-5f);
  EXPECT_NEAR(glm::distance(ground.captured_at, glm::vec3(3.0f, 6.0f, 1.0f)), 0.0f, 1e-5f);
  EXPECT_FLOAT_EQ(ground.radius, 20.0f);
  // Below the dome's edge straight lines on the ground stay straight: the panorama lies on it undistorted.
  const formula::ProxyHit below = hitOf(ground, {0.0f, 10.0f, 0.0f}, glm::normalize(glm::vec3(1.0f, -2.0f, 0.5f)));
  EXPECT_TRUE(below.is_ground);
  EXPECT_NEAR(glm::distance(below.place, glm::vec3(3.0f, 4.0f, 1.5f)), 0.0f, 1e-5f);
}

TEST(Proxy, TheMapIsCapturedWithin) {
  ProxyOptions options = parsed("box:-1,-1,-1,1,1,1");
  options.captured_at = glm::vec3(0.0f, 2.0f, 0.0f);
  const auto proxy = placedProxy(options, {});
  ASSERT_FALSE(proxy);
  EXPECT_THAT(proxy.error().message, HasSubstr("not within its proxy box:-1,-1,-1,1,1,1"));
  options = parsed("ground:1");
  options.captured_at = glm::vec3(0.0f, -2.0f, 0.0f);
  EXPECT_THAT(placedProxy(options, {}).error().message, HasSubstr("not above the ground"));
  EXPECT_FALSE(placedProxy(parsed("no_such_model.glb"), {}));
}

}  // namespace
}  // namespace mirrorball
