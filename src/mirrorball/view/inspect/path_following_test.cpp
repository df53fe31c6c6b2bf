#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/view/inspect/inspect_testing.h"
#include "mirrorball/view/inspect/inspector.h"

namespace mirrorball {
namespace {

using testing::addPart;
using testing::addSheet;
using testing::clearGlass;
using testing::lightAround;
using testing::lightFrom;
using testing::mirrorOf;
using testing::parallelCamera;
using testing::risingBy;
using testing::surfaceAt;

Scene sheetOf(const Material& material) {
  Scene scene;
  addSheet(scene, material, 0.0f);
  return scene;
}

/// A level slab of glass, half a unit thick.
Scene slabOf(const Material& material) {
  Scene scene;
  addPart(scene, cubeMesh(), material, glm::scale(glm::mat4(1.0f), std::sqrt(3.0f) * glm::vec3(50.0f, 0.25f, 50.0f)));
  return scene;
}

/// Two level mirrors, at heights 0 and 2, that face each other.
Scene mirrorsOf(const Material& lower, const Material& upper) {
  Scene scene;
  addSheet(scene, lower, 0.0f);
  addSheet(scene, upper, 2.0f, true);
  return scene;
}

void expectNear(glm::vec3 found, glm::vec3 expected, float tolerance) {
  EXPECT_LT(glm::distance(found, expected), tolerance) << found.x << ", " << found.y << ", " << found.z << " not "
                                                       << expected.x << ", " << expected.y << ", " << expected.z;
}

TEST(PathFollowing, AMirrorShowsTheMirroredDirection) {
  const auto surface = surfaceAt(sheetOf(mirrorOf(0.5f)), parallelCamera(0.0f, 30.0f));
  ASSERT_TRUE(surface.reflected);
  EXPECT_FALSE(surface.refracted);
  const RayPath& path = *surface.reflected;
  EXPECT_EQ(path.end, PathEnd::environment);
  ASSERT_EQ(path.segments.size(), 1u);
  expectNear(path.segments[0].from, glm::vec3(0.0f), 1e-4f);
  expectNear(glm::normalize(path.segments[0].to - path.segments[0].from), risingBy(30.0f), 1e-5f);
  expectNear(path.direction, risingBy(30.0f), 1e-5f);
  expectNear(path.radiance, lightFrom(path.direction), 1e-6f);
  // Schlick at 60°: f0 + (1 − f0) / 2⁵.
  EXPECT_NEAR(path.segments[0].share.y, 0.5f + 0.5f / 32.0f, 1e-5f);
  EXPECT_TRUE(path.lobe.empty()) << "it is smooth";
}

TEST(PathFollowing, TheEnvironmentIsTurnedAndScaled) {
  LightAround around = lightAround();
  around.intensity = 3.0f;
  around.environment_from_world = glm::mat3(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0));
  const auto surface = surfaceAt(sheetOf(mirrorOf(0.5f)), parallelCamera(0.0f, 30.0f), 0.0f, around);
  const glm::vec3 direction(std::cos(glm::radians(30.0f)), 0.5f, 0.0f);
  expectNear(surface.reflected->direction, direction, 1e-5f);
  expectNear(surface.reflected->radiance, 3.0f * lightFrom(direction), 1e-5f);
}

TEST(PathFollowing, AProxyIsSeenFromWhereItsMapWasCaptured) {
  LightAround around = lightAround();
  around.proxy.kind = ProxyKind::sphere;
  around.proxy.radius = 5.0f;
  const auto surface = surfaceAt(sheetOf(mirrorOf(0.5f)), parallelCamera(0.0f, 30.0f), 0.8f, around);
  // From (0.8, 0, 0) along a unit vector that is orthogonal to it: √(25 − 0.64) on.
  const glm::vec3 place = glm::vec3(0.8f, 0.0f, 0.0f) + std::sqrt(25.0f - 0.64f) * risingBy(30.0f);
  expectNear(surface.reflected->direction, place / 5.0f, 1e-4f);
}

TEST(PathFollowing, ASlabShiftsWhatIsSeenThroughIt) {
  Material glass = clearGlass();
  glass.attenuation_color = {0.25f, 0.5f, 1.0f};
  glass.attenuation_distance = 1.0f;
  const auto surface = surfaceAt(slabOf(glass), parallelCamera(0.0f, 45.0f));
  ASSERT_TRUE(surface.refracted);
  const RayPath& path = *surface.refracted;
  ASSERT_EQ(path.segments.size(), 2u);
  EXPECT_TRUE(path.segments[0].is_inside);
  EXPECT_FALSE(path.segments[1].is_inside);
  const float inside = std::asin(std::sin(glm::radians(45.0f)) / 1.5f);
  expectNear(path.segments[0].to - path.segments[0].from, {0.0f, -0.5f, -0.5f * std::tan(inside)}, 1e-4f);
  EXPECT_EQ(path.segments[0].to, path.segments[1].from);
  expectNear(path.direction, risingBy(-45.0f), 1e-5f);
  const float passes = 1.0f - formula::fresnelDielectric(std::cos(glm::radians(45.0f)), 1.5f);
  EXPECT_NEAR(path.segments[0].share.y, passes, 1e-5f);
  const float way = 0.5f / std::cos(inside);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(path.segments[1].share[channel], passes * passes * std::pow(glass.attenuation_color[channel], way),
                1e-4f);
}

// Two refractions turn a ray by twice the difference of both angles.
TEST(PathFollowing, ABallOfGlassTurnsTheRayTwice) {
  Scene scene;
  addPart(scene, sphereMesh(), clearGlass(), glm::mat4(1.0f));
  for (const float offset : {0.0f, 0.3f, 0.5f, 0.8f}) {
    const auto surface = surfaceAt(scene, parallelCamera(0.0f, 0.0f), offset);
    ASSERT_TRUE(surface.refracted);
    ASSERT_EQ(surface.refracted->segments.size(), 2u) << offset;
    const float turn = 2.0f * (std::asin(offset) - std::asin(offset / 1.5f));
    expectNear(surface.refracted->direction, {-std::sin(turn), 0.0f, -std::cos(turn)}, 4e-3f);
  }
}

TEST(PathFollowing, LightIsTotallyReflectedWithinACube) {
  Scene scene;
  addPart(scene, cubeMesh(), clearGlass(), glm::mat4(1.0f));
  // Meets the face +Z at x = −0.2, from there −X at 62° from its normal, and leaves by −Z.
  const float half = 1.0f / std::sqrt(3.0f);
  const auto surface = surfaceAt(scene, parallelCamera(45.0f, 0.0f), (-0.2f - half) * std::sqrt(0.5f));
  expectNear(surface.picked.position, {-0.2f, 0.0f, half}, 1e-4f);
  const RayPath& path = *surface.refracted;
  ASSERT_EQ(path.segments.size(), 3u);
  EXPECT_EQ(path.segments[0].turn, RayTurn::refracted);
  EXPECT_EQ(path.segments[1].turn, RayTurn::totally_reflected);
  EXPECT_TRUE(path.segments[1].is_inside);
  EXPECT_EQ(path.segments[1].share, path.segments[0].share);
  EXPECT_EQ(path.segments[2].turn, RayTurn::refracted);
  EXPECT_NEAR(path.segments[1].from.x, -half, 1e-4f);
  EXPECT_NEAR(path.segments[2].from.z, -half, 1e-4f);
  const float s = std::sqrt(0.5f);
  expectNear(path.direction, {s, 0.0f, -s}, 1e-4f);
}

TEST(PathFollowing, AThinWallLetsLightGoStraightOn) {
  Material sheet = clearGlass();
  sheet.thin_walled = true;
  sheet.base_color = {0.5f, 1.0f, 1.0f};
  sheet.perceptual_roughness = 0.4f;
  const auto surface = surfaceAt(sheetOf(sheet), parallelCamera(0.0f, 30.0f));
  ASSERT_TRUE(surface.refracted && surface.reflected);
  ASSERT_EQ(surface.refracted->segments.size(), 1u);
  EXPECT_FALSE(surface.refracted->segments[0].is_inside);
  expectNear(surface.refracted->direction, risingBy(-30.0f), 1e-5f);
  const float passes = 1.0f - formula::fresnelDielectric(0.5f, 1.5f);
  expectNear(surface.refracted->segments[0].share, passes * sheet.base_color, 1e-5f);
  // What it lets through is as wide as what it reflects.
  ASSERT_EQ(surface.refracted->lobe.size(), surface.reflected->lobe.size());
  for (std::size_t i = 0; i < surface.reflected->lobe.size(); ++i)
    expectNear(surface.refracted->lobe[i], glm::vec3(1, -1, 1) * surface.reflected->lobe[i], 1e-5f);
  Scene two = sheetOf(sheet);
  addSheet(two, sheet, -1.0f);
  const auto through_both = surfaceAt(two, parallelCamera(0.0f, 30.0f));
  EXPECT_EQ(through_both.refracted->segments.size(), 2u);
  expectNear(through_both.refracted->direction, risingBy(-30.0f), 1e-5f);
  EXPECT_TRUE(through_both.refracted->lobe.empty()) << "another surface is in the way";
}

TEST(PathFollowing, AmongBodiesInBodiesTheGreaterPriorityCounts) {
  for (const int priority : {1, 0}) {
    Material outer = clearGlass(1.5f);
    outer.priority = priority;
    Scene scene;
    addPart(scene, sphereMesh(), outer, glm::mat4(1.0f));
    addPart(scene, sphereMesh(), clearGlass(2.4f), glm::mat4(glm::mat3(0.5f)));
    const auto surface = surfaceAt(scene, parallelCamera(0.0f, 0.0f));
    EXPECT_EQ(surface.refracted->segments.size(), priority == 1 ? 2u : 4u);
  }
}

TEST(PathFollowing, APathEndsWhereItIsToldTo) {
  const Camera camera = parallelCamera(0.0f, 30.0f);
  const Scene endless = mirrorsOf(mirrorOf(1.0f), mirrorOf(1.0f));
  const auto long_one = surfaceAt(endless, camera);
  EXPECT_EQ(long_one.reflected->end, PathEnd::limit);
  EXPECT_EQ(long_one.reflected->segments.size(), 16u);
  const auto short_one = surfaceAt(endless, camera, 0.0f, lightAround(), {.most_segments = 3});
  EXPECT_EQ(short_one.reflected->end, PathEnd::limit);
  EXPECT_EQ(short_one.reflected->segments.size(), 3u);
  EXPECT_EQ(short_one.reflected->radiance, glm::vec3(0.0f));
  const auto least = surfaceAt(endless, camera, 0.0f, lightAround(), {.most_segments = 0});
  EXPECT_EQ(least.reflected->segments.size(), 1u);
  // 0.1 + 0.9 / 32 at each: after the fourth, less than a thousandth.
  const auto faint = surfaceAt(mirrorsOf(mirrorOf(0.1f), mirrorOf(0.1f)), camera);
  EXPECT_EQ(faint.reflected->end, PathEnd::faint);
  EXPECT_EQ(faint.reflected->segments.size(), 3u);
}

TEST(PathFollowing, AFurtherMattSurfaceEndsThePath) {
  Material unlit = mirrorOf(1.0f);
  unlit.unlit = true;
  for (const Material& upper : {mirrorOf(1.0f, 1.0f), unlit}) {
    const auto surface = surfaceAt(mirrorsOf(mirrorOf(1.0f), upper), parallelCamera(0.0f, 30.0f));
    EXPECT_EQ(surface.reflected->end, PathEnd::matt);
    ASSERT_EQ(surface.reflected->segments.size(), 1u);
    expectNear(surface.reflected->segments[0].to, 4.0f * risingBy(30.0f), 1e-3f);
    EXPECT_TRUE(surface.reflected->lobe.empty());
  }
  const auto first = surfaceAt(sheetOf(mirrorOf(1.0f, 1.0f)), parallelCamera(0.0f, 30.0f));
  EXPECT_EQ(first.reflected->end, PathEnd::environment) << "of the first surface the way is always shown";
  EXPECT_FALSE(surfaceAt(sheetOf(unlit), parallelCamera(0.0f, 30.0f)).reflected);
}

// Half of the facets that are seen along the normal lean by less than atan(alpha).
TEST(PathFollowing, ARoughMirrorHasALobeAroundItsDirection) {
  const auto surface = surfaceAt(sheetOf(mirrorOf(0.5f, 0.5f)), parallelCamera(0.0f, 90.0f));
  ASSERT_FALSE(surface.reflected->lobe.empty());
  for (const glm::vec3 direction : surface.reflected->lobe)
    EXPECT_NEAR(std::acos(direction.y), 2.0f * std::atan(0.25f), 1e-3f);
}

}  // namespace
}  // namespace mirrorball
