#include "mirrorball/trace/path_schedule.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

/// A tracer of a scene, and a camera that sees all of it.
struct Shot {
  PathTracer tracer;
  Camera camera;
};

Shot shotOf(Scene scene, Environment light, float aspect = 1.0f) {
  const Camera camera = makeCamera({}, boundingSphere(scene), aspect);
  return {*PathTracer::make(std::move(scene), std::move(light)), camera};
}

TEST(PathCounts, GrowWithSharesBetweenLeastAndMost) {
  const PathCounts even{.least = 5};
  EXPECT_EQ(even.at(3), 5);
  const PathCounts counts{.least = 8, .most = 100, .shares = {0.1f, 1.0f, 9.0f}, .scale = 20.0f};
  EXPECT_EQ(counts.at(0), 8);
  EXPECT_EQ(counts.at(1), 20);
  EXPECT_EQ(counts.at(2), 100);
}

// However many paths a half has, it counts as much as the other.
TEST(Film, IsTheMeanOfItsHalves) {
  Film film({1, 1}, 2, {});
  FilmPass pass({1, 1});
  pass.at(0) = {.light = glm::dvec4(1.0), .squares = glm::dvec4(1.0), .paths = 1};
  film.addPass(pass, 0, {.least = 1});
  EXPECT_EQ(film.radiance().texel(0, 0)[0], 1.0f) << "of the only half that has paths";
  pass.at(0) = {.light = glm::dvec4(6.0), .squares = glm::dvec4(20.0), .paths = 3};
  film.addPass(pass, 1, {.least = 3});
  EXPECT_EQ(film.radiance().texel(0, 0)[0], 1.5f);
  EXPECT_EQ(film.paths(), 4u);
  // Of the second half (20/3 − 4) / 2; of the mean a quarter of that and of the first's, which one path does not tell.
  EXPECT_NEAR(film.variance().texel(0, 0)[0], (20.0 / 3.0 - 4.0) / 2.0 / 4.0, 1e-6);
}

// Glass, gold and a mirror, before a background without noise.
TEST(PathSchedule, DrawsPathsWhereTheNoiseIsWithoutBias) {
  const auto [tracer, camera] = shotOf(*loadModel("showcase"), *builtinEnvironment("studio"), 1.5f);
  TraceSettings settings{.size = {48, 32}, .samples = 256};
  const auto even = tracer.render(camera, settings);
  ASSERT_TRUE(even);
  settings.noise = even->noise;
  settings.samples = 1 << 16;
  const auto aimed = tracer.render(camera, settings);
  ASSERT_TRUE(aimed);
  EXPECT_LE(aimed->noise, even->noise);
  EXPECT_LT(aimed->samples, 256 * 3 / 4);
  const glm::dvec3 a = testing::meansOf(even->radiance), b = testing::meansOf(aimed->radiance);
  EXPECT_NEAR(a.y, b.y, 0.004 * a.y);
  const auto again = tracer.render(camera, settings);
  ASSERT_TRUE(again);
  EXPECT_TRUE(std::ranges::equal(again->radiance.samples(), aimed->radiance.samples()));
}

// Pixels whose first paths are all of one dark kind get no fewer paths for it: by their own first paths they would, and
// would stay too dark. The surface's own choice meets this lamp with one path in forty.
TEST(PathSchedule, KeepsTheMeanOfRareLight) {
  const glm::vec3 lamp = glm::normalize(glm::vec3(0.3f, 1.0f, 0.5f));
  const Environment light([=](glm::vec3 d) { return glm::vec3(glm::dot(d, lamp) > 0.95f ? 10.0f : 0.05f); }, 64);
  const auto [tracer, camera] = shotOf(testing::shapeOf("sphere", testing::matt(0.8f)), light);
  TraceSettings settings{.size = {32, 32}, .samples = 4096, .strategy = LightStrategy::surface};
  const auto even = tracer.render(camera, settings);
  settings.noise = 0.03f;
  const auto aimed = tracer.render(camera, settings);
  ASSERT_TRUE(even && aimed);
  EXPECT_LT(aimed->samples, 1000);
  const double truth = testing::meansOf(even->radiance).y;
  EXPECT_NEAR(testing::meansOf(aimed->radiance).y, truth, 0.01 * truth);
}

// Light near the largest number has no error that a display could show.
TEST(PathSchedule, EndsUnderASunWithoutBounds) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.3f, 1.0f, 0.5f));
  const Environment light([=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > 0.999f ? 1e30f : 0.1f); }, 64);
  const auto [tracer, camera] = shotOf(testing::shapeOf("sphere", testing::matt(0.5f)), light);
  const auto picture = tracer.render(camera, {.size = {8, 8}, .samples = 64, .noise = 0.01f});
  ASSERT_TRUE(picture);
  EXPECT_GE(picture->samples, 16);
  EXPECT_TRUE(std::isfinite(picture->noise));
}

// Beside a disc there is nothing, whose paths count as those of others.
TEST(PathSchedule, CapturesDiscsToANoise) {
  const auto [tracer, camera] = shotOf(testing::shapeOf("sphere", testing::matt(0.5f)), *builtinEnvironment("studio"));
  const auto map = tracer.capture({.position = {0.0f, 0.0f, 3.0f}, .projection = Projection::angular, .size = 12},
                                  {.samples = 64, .noise = 0.001f});
  ASSERT_TRUE(map);
  EXPECT_EQ(map->state.samples, 64);
  EXPECT_EQ(map->map.face(0).texel(0, 0)[3], 0.0f);
}

TEST(PathSchedule, EndsWhereEachPixelHasAllThatItMayHave) {
  const auto [tracer, camera] = shotOf(testing::shapeOf("sphere", testing::matt(0.8f)), *builtinEnvironment("studio"));
  const auto picture = tracer.render(camera, {.size = {8, 8}, .samples = 32, .noise = 1e-5f});
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->samples, 32);
}

}  // namespace
}  // namespace mirrorball
