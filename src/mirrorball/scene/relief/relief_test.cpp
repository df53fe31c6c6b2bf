#include "mirrorball/scene/relief/relief.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "formula/grid_random.h"
#include "mirrorball/height_field/height_field_testing.h"
#include "mirrorball/scene/relief/relief_surface.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

Scene planeOf(HeightKind kind, float scale) {
  Material material;
  material.height = kind;
  material.height_scale = scale;
  material.height_frequency = 1.0f;
  return meshScene(planeMesh(), material);
}

TEST(PrepareRelief, TurnsHeightsOverWhereTheScaleIsBelowZero) {
  Scene scene = planeOf(HeightKind::brick, -0.1f);
  scene.materials.push_back(planeOf(HeightKind::brick, 0.1f).materials[0]);
  scene.materials.push_back(scene.materials[0]);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  ASSERT_EQ(scene.height_textures.size(), 2u);
  EXPECT_EQ(scene.materials[0].height_texture, scene.materials[2].height_texture);
  for (const Material& material : scene.materials) EXPECT_EQ(material.height_scale, 0.1f);
  const Image& over = scene.height_textures[std::size_t(scene.materials[0].height_texture)]->heights;
  const Image& upright = scene.height_textures[std::size_t(scene.materials[1].height_texture)]->heights;
  for (int x = 0; x < over.width(); ++x) EXPECT_EQ(over.texel(x, 77)[0], 1.0f - upright.texel(x, 77)[0]) << x;
  // The last level bounds all.
  const HeightTexture& texture = scene.height_textures[std::size_t(scene.materials[0].height_texture)];
  const glm::ivec2 last = formula::placeOfLevel(heightMapOf(texture), 9);
  EXPECT_GT(texture.picture.texel(last.x, last.y)[0], 0.9f);
}

TEST(PrepareRelief, ChangesNothingTheSecondTime) {
  Scene scene = planeOf(HeightKind::waves, -0.1f);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  const float height = scene.height_textures[0]->heights.texel(3, 4)[0];
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  EXPECT_EQ(scene.height_textures.size(), 1u);
  EXPECT_EQ(scene.height_textures[0]->heights.texel(3, 4)[0], height);
}

TEST(PrepareRelief, GivesTexturesOnlyToWhatReadsThem) {
  for (const ReliefKind kind : {ReliefKind::none, ReliefKind::bump}) {
    Scene scene = planeOf(HeightKind::orange, -0.1f);
    ASSERT_TRUE(prepareRelief(scene, kind));
    EXPECT_TRUE(scene.height_textures.empty());
    EXPECT_EQ(scene.materials[0].height_scale, -0.1f);
  }
  Scene without_map = planeOf(HeightKind::map, 0.1f);
  ASSERT_TRUE(prepareRelief(without_map, ReliefKind::exact));
  EXPECT_TRUE(without_map.height_textures.empty());
  Scene bumps = planeOf(HeightKind::weave, 0.1f);
  ASSERT_TRUE(prepareRelief(bumps, ReliefKind::bump));
  EXPECT_EQ(bumps.height_textures.size(), 1u);
}

TEST(PrepareRelief, WarnsWhereHeightsLieOverCoordinatesThatAMeshDoesNotHave) {
  const auto warningsOf = [](HeightKind height, ReliefKind kind) {
    Scene scene = planeOf(height, 0.1f);
    for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] = glm::vec2(0.0f);
    EXPECT_TRUE(prepareRelief(scene, kind));
    return scene.warnings.size();
  };
  EXPECT_EQ(warningsOf(HeightKind::orange, ReliefKind::bump), 0u) << "a function of the place";
  EXPECT_EQ(warningsOf(HeightKind::orange, ReliefKind::exact), 1u) << "a tile like the others";
  EXPECT_EQ(warningsOf(HeightKind::brick, ReliefKind::bump), 1u);
  EXPECT_EQ(warningsOf(HeightKind::brick, ReliefKind::none), 0u);
}

Scene reliefOfSide(int side) {
  Scene scene = planeOf(HeightKind::map, 0.1f);
  scene.height_textures.push_back(HeightTexture{.heights = Image(side, side, 1, 0.5f)});
  scene.materials[0].height_texture = 0;
  return scene;
}

// Before any work: nothing is made then.
TEST(PrepareRelief, RefusesSearchesThatTheDriverCannotRead) {
  Scene scene = reliefOfSide(1400);
  const auto prepared = prepareRelief(scene, ReliefKind::cone, [] { return 2048; });
  ASSERT_FALSE(prepared);
  EXPECT_EQ(prepared.error().code, ErrorCode::too_large);
  EXPECT_NE(prepared.error().message.find("at most 1364 texels a side"), std::string::npos);
  EXPECT_TRUE(scene.height_textures[0]->picture.empty());
}

TEST(PrepareRelief, AsksForTheDriverOnlyWhereItMatters) {
  int asked = 0;
  const auto largest = [&] {
    ++asked;
    return 2100;
  };
  Scene small = reliefOfSide(512), large = reliefOfSide(1500), fits = reliefOfSide(1400);
  EXPECT_TRUE(prepareRelief(small, ReliefKind::exact, largest));
  EXPECT_TRUE(prepareRelief(large, ReliefKind::bump, largest));
  EXPECT_TRUE(large.height_textures[0]->picture.empty()) << "bumps need no searches";
  EXPECT_EQ(asked, 0);
  EXPECT_TRUE(prepareRelief(fits, ReliefKind::parallax, largest));
  EXPECT_EQ(asked, 1);
  // To be traced: no driver takes part.
  EXPECT_TRUE(prepareRelief(large, ReliefKind::exact));
  EXPECT_FALSE(large.height_textures[0]->picture.empty());
}

TEST(PrepareRelief, KeepsNoHeightsThatWereTurnedOver) {
  Scene scene = reliefOfSide(8);
  scene.materials[0].height_scale = -0.1f;
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::exact));
  EXPECT_EQ(scene.height_textures.size(), 1u);
  EXPECT_EQ(scene.materials[0].height_texture, 0);
}

// Heights along u as a ramp: each triangle of a plane has its part of them.
TEST(HeightsBelow, AreThoseOfATriangle) {
  constexpr int kWidth = 512;
  Image heights(kWidth, 1, 1);
  for (int x = 0; x < kWidth; ++x) heights.texel(x, 0)[0] = static_cast<float>(x) / (kWidth - 1);
  const auto texture = heightTexture(std::move(heights), MapEdges::clamped);
  ASSERT_TRUE(texture);
  Material material;
  material.height_frequency = 1.0f;
  const Mesh sphere = sphereMesh(32, 16);
  for (std::size_t first = 0; first < sphere.indices.size(); first += 3) {
    float low = 1.0f, high = 0.0f;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float u = std::clamp(sphere.vertices[sphere.indices[first + corner]].uv[0].x, 0.0f, 1.0f);
      low = std::min(low, u);
      high = std::max(high, u);
    }
    const glm::vec2 found =
        heightsBelow(reliefPrism(sphere, first, material, *texture), texture->bounds, reachOf(sphere));
    EXPECT_LE(found.x, low + 0.001f);
    EXPECT_GE(found.y, high - 0.001f);
    EXPECT_LT(found.y - found.x, high - low + 0.03f);
  }
}

// Where rays are rounded by all of a relief they are looked for in all of it.
TEST(HeightsBelow, AreAllOfAReliefThinnerThanDigits) {
  const auto texture = heightTexture(Image(4, 4, 1, 0.5f), MapEdges::tiled);
  ASSERT_TRUE(texture);
  const Mesh sphere = sphereMesh(8, 16);
  const auto below = [&](float depth) {
    Material material;
    material.height_scale = depth;
    return heightsBelow(reliefPrism(sphere, 0, material, *texture), texture->bounds, reachOf(sphere));
  };
  EXPECT_EQ(below(1e-6f), glm::vec2(0.0f, 1.0f));
  EXPECT_EQ(below(0.0f), glm::vec2(0.0f, 1.0f));
  EXPECT_NEAR(below(0.1f).x, 0.5f, 1e-3f);
  EXPECT_NEAR(below(0.1f).y, 0.5f, 1e-3f);
}

/// As shaders read it: heights and cones in one picture.
struct HeightsAndCones {
  const HeightTexture& texture;
};

glm::vec4 fetchMap(const HeightsAndCones& map, glm::ivec2 texel, int level) {
  return {fetchMap(map.texture, texel, level).x, map.texture.cones.texel(texel.x, texel.y)[0], 0.0f, 1.0f};
}

// Between texels the nearest one's cone is cut by the surface: with it 23 to 59 % of these rays passed through.
TEST(ConeDepth, PassesThroughNoSurface) {
  constexpr int kSide = 64;
  constexpr int kRays = 2000;
  constexpr int kSteps = 1000;
  auto texture = heightTexture(testing::randomHeights(kSide, kSide), MapEdges::tiled);
  ASSERT_TRUE(texture && makeCones(*texture));
  const formula::HeightMap map = heightMapOf(*texture);
  for (const float run : {3.0f, 10.0f, 40.0f}) {
    int early = 0;
    for (int i = 0; i < kRays; ++i) {
      const glm::vec3 random = formula::gridRandom(glm::ivec3(i, 1, 7));
      const float azimuth = 6.2831853f * random.z;
      const glm::vec2 from = glm::vec2(random) * float(kSide);
      const glm::vec2 way = run * glm::vec2(std::cos(azimuth), std::sin(azimuth));
      const float met = formula::exactSearch(*texture, map, glm::vec3(from, 1.0f), glm::vec3(from + way, 0.0f), false);
      const float depth = formula::coneDepth(HeightsAndCones{*texture}, map, formula::ReliefRay{from, way}, kSteps);
      ASSERT_LT(depth, met + 0.01f) << "ray " << i << ", run " << run;
      early += depth < std::min(met, 1.0f) - 0.01f ? 1 : 0;
    }
    EXPECT_LT(early, kRays / 500) << "run " << run;
  }
}

TEST(ReliefNormal, LeansAwayFromTheWayUp) {
  Image heights(4, 1, 1);
  for (int x = 0; x < 4; ++x) heights.texel(x, 0)[0] = 0.25f * static_cast<float>(x);
  const auto texture = heightTexture(std::move(heights), MapEdges::clamped);
  ASSERT_TRUE(texture);
  const Mesh plane = planeMesh();
  Material material;
  material.height_scale = 0.5f;
  material.height_frequency = 1.0f;
  const formula::ReliefPrism prism = reliefPrism(plane, 0, material, *texture);
  // The middle of the plane: over its side √2 the heights would rise by 1, so the surface by 0.5.
  const Vertex& a = plane.vertices[plane.indices[0]];
  const glm::vec3 along_u = glm::normalize(glm::vec3(a.tangent));
  const glm::vec3 expected = glm::normalize(a.normal - 0.5f / std::sqrt(2.0f) * along_u);
  const glm::vec3 normal = reliefNormal(*texture, prism, material.height_scale, {0.5f, 0.0f});
  const glm::vec3 middle = reliefNormal(*texture, prism, material.height_scale, {0.0f, 0.5f});
  const bool x_is_diagonal = prism.texel_along_x.x != 0.0f && prism.texel_along_x.y != 0.0f;
  EXPECT_LT(glm::distance(x_is_diagonal ? normal : middle, expected), 1e-5f);
}

}  // namespace
}  // namespace mirrorball
