#include "mirrorball/rays/scene_occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/interreflection.h"

namespace mirrorball {
namespace {

using ::testing::Each;
using ::testing::SizeIs;

Material matt(float albedo) {
  Material material;
  material.base_color = glm::vec3(albedo);
  material.specular = 0.0f;
  return material;
}

/// A scene whose occlusion has been found.
Scene withOcclusion(Scene scene, int rays) {
  const auto geometry = Geometry::make(scene);
  EXPECT_TRUE(geometry);
  EXPECT_TRUE(findOcclusion(scene, *geometry, {.rays = rays}));
  return scene;
}

/// Squares from −half to half on the plane y = 0, its normal upwards.
Mesh gridMesh(float half, int squares) {
  Mesh mesh;
  for (int z = 0; z <= squares; ++z)
    for (int x = 0; x <= squares; ++x) {
      const glm::vec2 at = half * (2.0f * glm::vec2(x, z) / static_cast<float>(squares) - 1.0f);
      mesh.vertices.push_back({.position = {at.x, 0.0f, at.y}, .normal = {0.0f, 1.0f, 0.0f}});
    }
  const auto row = static_cast<std::uint32_t>(squares) + 1;
  for (std::uint32_t z = 0; z + 1 < row; ++z)
    for (std::uint32_t x = 0; x + 1 < row; ++x) {
      const std::uint32_t a = z * row + x;
      for (const std::uint32_t corner : {a, a + row, a + 1, a + 1, a + row, a + row + 1})
        mesh.indices.push_back(corner);
    }
  return mesh;
}

/// A plane and a ball of that radius above it.
Scene ballOverPlane(float radius, float height, Material of_ball = matt(0.0f)) {
  Scene scene = meshScene(gridMesh(2.0f, 20), matt(0.0f));
  Mesh ball = sphereMesh(24, 48);
  ball.material = 1;
  scene.materials.push_back(std::move(of_ball));
  scene.meshes.push_back(std::move(ball));
  const glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, height, 0.0f));
  scene.instances.push_back({.mesh = 1, .world_from_object = glm::scale(place, glm::vec3(radius))});
  return scene;
}

// A sphere all above a plane hides the share (R / d)² cos θ of its light, d from its middle, θ from the plane's normal.
TEST(SceneOcclusion, ABallHidesItsFormFactorFromAPlane) {
  constexpr float kRadius = 0.5f, kHeight = 0.75f;
  const Scene scene = withOcclusion(ballOverPlane(kRadius, kHeight), 1024);
  const std::vector<Vertex>& vertices = scene.meshes[0]->vertices;
  ASSERT_THAT(scene.instances[0].occlusion, SizeIs(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::vec3 way = glm::vec3(0.0f, kHeight, 0.0f) - vertices[i].position;
    const float distance = glm::length(way);
    const float hidden = kRadius * kRadius * kHeight / (distance * distance * distance);
    EXPECT_NEAR(scene.instances[0].occlusion[i].open, 1.0f - hidden, 0.012f) << i;
    // What is hidden is towards the ball.
    if (hidden < 0.1f) continue;
    EXPECT_GT(glm::dot(glm::normalize(scene.instances[0].occlusion[i].occluded), way / distance), 0.97f) << i;
  }
}

// A two-sided plane with a ball below: its back sees what the plane above would see of a ball above it.
TEST(SceneOcclusion, ABackSeesItsOwnSide) {
  constexpr float kRadius = 0.5f, kHeight = 0.75f;
  for (const bool is_clockwise : {false, true}) {
    Scene scene = ballOverPlane(kRadius, -kHeight);
    scene.materials[0].double_sided = true;
    if (is_clockwise) std::reverse(scene.meshes[0].edit().indices.begin(), scene.meshes[0].edit().indices.end());
    scene = withOcclusion(std::move(scene), 1024);
    const std::vector<Vertex>& vertices = scene.meshes[0]->vertices;
    const std::vector<VertexOcclusion>& occlusion = scene.instances[0].occlusion;
    ASSERT_TRUE(knowsBacks(scene, 0));
    ASSERT_THAT(occlusion, SizeIs(2 * vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const glm::vec3 way = glm::vec3(0.0f, -kHeight, 0.0f) - vertices[i].position;
      const float distance = glm::length(way);
      const float hidden = kRadius * kRadius * kHeight / (distance * distance * distance);
      EXPECT_EQ(occlusion[is_clockwise ? vertices.size() + i : i].open, 1.0f) << i;
      const VertexOcclusion& below = occlusion[is_clockwise ? i : vertices.size() + i];
      EXPECT_NEAR(below.open, 1.0f - hidden, 0.015f) << i;
      if (hidden < 0.1f) continue;
      EXPECT_GT(glm::dot(glm::normalize(below.occluded), way / distance), 0.97f) << i;
    }
  }
}

// What closes a body sees nothing from behind, so that its backs need no rays.
TEST(SceneOcclusion, AClosedBodyHasNoBacks) {
  Scene scene = ballOverPlane(0.5f, 0.75f);
  for (Material& material : scene.materials) material.double_sided = true;
  scene = withOcclusion(std::move(scene), 16);
  EXPECT_TRUE(knowsBacks(scene, 0));
  EXPECT_FALSE(knowsBacks(scene, 1));
}

// Between a white sheet and a black floor below it, close to each other, hardly any light arrives: none that falls on
// the sheet's upper side comes through to the lower one.
TEST(SceneOcclusion, ASheetLetsNoLightThrough) {
  Scene scene = meshScene(gridMesh(2.0f, 20), matt(0.0f));
  scene.meshes.push_back(gridMesh(2.0f, 20));
  scene.meshes[1].edit().material = 1;
  scene.materials.push_back(matt(0.9f));
  scene.materials[1].double_sided = true;
  scene.instances.push_back({.mesh = 1, .world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0.1f, 0))});
  scene = withOcclusion(std::move(scene), 64);
  const std::size_t middle = scene.meshes[0]->vertices.size() / 2;
  EXPECT_LT(scene.instances[0].occlusion[middle].interreflected.x, 0.02f);
}

// All of the inside of a hollow ball sees the same share of its opening, and each light is the same at all places
// (Jacquez & Kuppenheim 1955): E = s + ρ (1 − s) E.
TEST(SceneOcclusion, ABowlsInsideSeesItsOpeningAndItself) {
  constexpr float kAlbedo = 0.6f;
  Scene bowl = bowlScene();
  bowl.materials[0] = matt(kAlbedo);
  bowl = withOcclusion(std::move(bowl), 64);
  const float light = kBowlOpenShare / (1.0f - kAlbedo * (1.0f - kBowlOpenShare));
  std::size_t inside = 0;
  double open = 0.0;
  for (std::size_t i = 0; i < bowl.meshes[0]->vertices.size(); ++i) {
    const Vertex& vertex = bowl.meshes[0]->vertices[i];
    const VertexOcclusion& occlusion = bowl.instances[0].occlusion[i];
    if (glm::dot(vertex.position, vertex.normal) < -0.5f) {  // not on the rim
      ++inside;
      open += occlusion.open;
      EXPECT_NEAR(occlusion.open, kBowlOpenShare, 0.07f) << i;
      EXPECT_NEAR(occlusion.interreflected.x, light - kBowlOpenShare, 0.07f) << i;
    } else if (glm::dot(vertex.position, vertex.normal) > 0.9f) {  // outside
      EXPECT_EQ(occlusion.open, 1.0f) << i;
      EXPECT_EQ(occlusion.occluded, glm::vec3(0.0f)) << i;
    }
  }
  ASSERT_GT(inside, 1000u);
  EXPECT_NEAR(open / static_cast<double>(inside), kBowlOpenShare, 0.003);
}

// A ball that shines sends its radiance times its form factor: large and near, where rays meet it, and small and far,
// where few do.
TEST(SceneOcclusion, ABallThatShinesSendsItsFormFactor) {
  const glm::vec3 radiance(2.0f, 1.0f, 4.0f);
  for (const auto& [radius, height] : {std::pair(0.5f, 0.75f), std::pair(0.02f, 0.5f)}) {
    Scene scene = ballOverPlane(radius, height);
    for (Material& material : scene.materials) material = matt(0.0f);
    scene.materials[1].emission = radiance;
    scene = withOcclusion(std::move(scene), 64);
    const std::vector<Vertex>& vertices = scene.meshes[0]->vertices;
    const float brightest = radius * radius / (height * height);
    float sum = 0.0f, sum_of_shares = 0.0f;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const float distance = glm::distance(glm::vec3(0.0f, height, 0.0f), vertices[i].position);
      const float share = radius * radius * height / (distance * distance * distance);
      const glm::vec3 emitted = scene.instances[0].occlusion[i].emitted;
      EXPECT_NEAR(emitted.x / radiance.x, share, 0.25f * brightest) << radius << ", " << i;
      sum += emitted.x / radiance.x;
      sum_of_shares += share;
      EXPECT_NEAR(emitted.z / radiance.z, emitted.x / radiance.x, 1e-4f * brightest);
    }
    EXPECT_NEAR(sum, sum_of_shares, 0.02f * sum_of_shares) << radius;
  }
}

// In a bowl whose inside shines all light is the same everywhere: E = (1 − s) (L + ρ E).
TEST(SceneOcclusion, WhatShinesIsReflected) {
  constexpr float kAlbedo = 0.6f;
  Scene bowl = bowlScene();
  bowl.materials[0] = matt(kAlbedo);
  bowl.materials[0].emission = glm::vec3(0.5f);
  bowl = withOcclusion(std::move(bowl), 64);
  const float closed = 1.0f - kBowlOpenShare;
  const float light = closed * 0.5f / (1.0f - kAlbedo * closed);
  double sum = 0.0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < bowl.meshes[0]->vertices.size(); ++i) {
    const Vertex& vertex = bowl.meshes[0]->vertices[i];
    if (glm::dot(vertex.position, vertex.normal) >= -0.5f) continue;
    ++inside;
    sum += bowl.instances[0].occlusion[i].emitted.y;
    EXPECT_NEAR(bowl.instances[0].occlusion[i].emitted.y, light, 0.12f * light) << i;
  }
  ASSERT_GT(inside, 1000u);
  EXPECT_NEAR(sum / static_cast<double>(inside), light, 0.02f * light);
}

/// A floor of 2 × 2, and above it a panel of as much that faces it and shines.
Scene panelOverFloor(Material panel, float height) {
  Scene scene = meshScene(gridMesh(1.0f, 8), matt(0.0f));
  Mesh mesh;
  for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    mesh.vertices.push_back({.position = {at.x, height, at.y}, .normal = {0.0f, -1.0f, 0.0f}});
    mesh.vertices.back().uv[0] = 0.5f * at + 0.5f;
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = 1;
  scene.materials.push_back(std::move(panel));
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = 1});
  return scene;
}

// What is cut away does not shine, found by rays and by chosen places alike; half of what is half transparent does.
TEST(SceneOcclusion, WhatIsCutAwayDoesNotShine) {
  const auto emittedBy = [](AlphaMode mode, float opacity) {
    Material panel = matt(0.0f);
    panel.emission = glm::vec3(10.0f);
    panel.alpha_mode = mode;
    panel.opacity = opacity;
    panel.double_sided = true;
    const Scene scene = withOcclusion(panelOverFloor(panel, 0.7f), 64);
    double sum = 0.0;
    for (const VertexOcclusion& occlusion : scene.instances[0].occlusion) sum += occlusion.emitted.x;
    return sum;
  };
  const double whole = emittedBy(AlphaMode::opaque, 1.0f);
  EXPECT_GT(whole, 100.0);
  EXPECT_EQ(emittedBy(AlphaMode::mask, 0.1f), 0.0);
  EXPECT_NEAR(emittedBy(AlphaMode::blend, 0.5f), 0.5 * whole, 0.03 * whole);
}

// A panel of two triangles that is dark but for a window, which none of the places that are asked first sees: its
// radiance L over the area A, at the height h, makes L A h² / (π d⁴).
TEST(SceneOcclusion, ASmallWindowOfATextureShines) {
  constexpr float kHeight = 0.5f, kRadiance = 20.0f;
  Material panel = matt(0.0f);
  panel.emission = glm::vec3(kRadiance);
  panel.emission_map.texture = 0;
  Scene scene = panelOverFloor(panel, kHeight);
  Texture texture{.image = Image8(16, 16, 4)};
  texture.nearest = true;
  for (int channel = 0; channel < 3; ++channel) texture.image.edit().texel(9, 4)[channel] = 255;
  scene.textures.push_back(texture);
  scene = withOcclusion(std::move(scene), 1024);
  const glm::vec3 window(2.0f * 9.5f / 16.0f - 1.0f, kHeight, 2.0f * 4.5f / 16.0f - 1.0f);
  double sum = 0.0, expected = 0.0;
  for (std::size_t i = 0; i < scene.meshes[0]->vertices.size(); ++i) {
    const float distance = glm::distance(scene.meshes[0]->vertices[i].position, window);
    expected += kRadiance * (4.0f / 256.0f) * kHeight * kHeight / (formula::kPi * std::pow(distance, 4.0f));
    sum += scene.instances[0].occlusion[i].emitted.x;
  }
  EXPECT_NEAR(sum, expected, 0.15 * expected);
}

// A floor in front of a wall is shown the wall's front, which is lit from in front and from above.
TEST(SceneOcclusion, WhatIsShownIsLitFromWhereItIsOpen) {
  Scene scene = meshScene(gridMesh(1.0f, 20), matt(0.5f));
  const glm::mat4 upright = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
  scene.instances.push_back(
      {.mesh = 0, .world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(0, 1, -1)) * upright});
  scene = withOcclusion(std::move(scene), 256);
  std::size_t compared = 0;
  for (const VertexOcclusion& occlusion : scene.instances[0].occlusion) {
    EXPECT_LE(glm::length(occlusion.lit_from), occlusion.interreflected.y * 1.001f + 1e-6f);
    if (occlusion.interreflected.y < 0.05f) continue;
    ++compared;
    const glm::vec3 from = glm::normalize(occlusion.lit_from);
    EXPECT_GT(from.z, 0.5f);
    EXPECT_GT(from.y, 0.05f);
  }
  EXPECT_GT(compared, 20u);
}

// The flat triangles of a coarse ball lie below the horizon of its smooth normals.
TEST(SceneOcclusion, ACoarseBallHidesNothingFromItself) {
  const Scene ball = withOcclusion(meshScene(sphereMesh(6, 12), matt(0.5f)), 256);
  for (const VertexOcclusion& occlusion : ball.instances[0].occlusion) EXPECT_EQ(occlusion.open, 1.0f);
}

// Where walls meet, a wall's corners see what its places near by see: half of the sky at a right angle.
TEST(SceneOcclusion, AWallHidesHalfFromTheFloorBesideIt) {
  Scene scene = meshScene(gridMesh(1.0f, 20), matt(0.0f));
  const glm::mat4 upright = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
  scene.instances.push_back({.mesh = 0,
                             .world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(0, 1, -1)) *
                                                  glm::scale(upright, glm::vec3(20.0f, 1.0f, 1.0f))});
  scene = withOcclusion(std::move(scene), 1024);
  for (std::size_t i = 0; i < scene.meshes[0]->vertices.size(); ++i) {
    const glm::vec3 at = scene.meshes[0]->vertices[i].position;
    // Of a wall of height h at the distance x, infinitely long: (1 − x / √(x² + h²)) / 2 of the light is hidden.
    const float from_wall = at.z + 1.0f;
    const float hidden = 0.5f * (1.0f - from_wall / std::hypot(from_wall, 2.0f));
    EXPECT_NEAR(scene.instances[0].occlusion[i].open, 1.0f - hidden, 0.03f) << at.x << " " << at.z;
  }
}

TEST(SceneOcclusion, AWhiteSceneIsWhiteUnderAWhiteSky) {
  Scene bowl = bowlScene();
  bowl.materials[0] = Material{};
  bowl.materials[0].base_color = glm::vec3(1.0f);
  bowl = withOcclusion(std::move(bowl), 16);
  for (const VertexOcclusion& occlusion : bowl.instances[0].occlusion)
    EXPECT_NEAR(occlusion.open + occlusion.interreflected.x, 1.0f, 1e-5f);
}

TEST(SceneOcclusion, GlassAndWhatIsCutAwayHideNothing) {
  Material glass = matt(0.5f);
  glass.transmission = 1.0f;
  Material hole = matt(0.5f);
  hole.alpha_mode = AlphaMode::mask;
  hole.opacity = 0.0f;
  Material veil = matt(0.5f);
  veil.alpha_mode = AlphaMode::blend;
  veil.opacity = 0.5f;
  veil.double_sided = true;
  const auto underBall = [](const Material& of_ball) {
    const Scene scene = withOcclusion(ballOverPlane(0.5f, 0.5f, of_ball), 512);
    return scene.instances[0].occlusion[10 * 21 + 10].open;  // where it stands
  };
  const float solid = underBall(matt(0.5f));
  EXPECT_LT(solid, 0.1f);
  EXPECT_EQ(underBall(glass), 1.0f);
  EXPECT_EQ(underBall(hole), 1.0f);
  // A ray meets the ball twice.
  EXPECT_NEAR(underBall(veil), 1.0f - 0.75f * (1.0f - solid), 0.05f);
}

// glTF's rule: the back of a surface that has only a front is not drawn, so it hides nothing either. A sheet hides the
// floor that its front faces, and not one that it turns its back to.
TEST(SceneOcclusion, ABackThatIsNotDrawnHidesNothing) {
  const auto openBelow = [](bool faces_floor, bool double_sided) {
    Scene scene = meshScene(gridMesh(2.0f, 20), matt(0.0f));
    Material sheet = matt(0.0f);
    sheet.double_sided = double_sided;
    scene.materials.push_back(sheet);
    scene.meshes.push_back(gridMesh(2.0f, 20));
    scene.meshes[1].edit().material = 1;
    glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.3f, 0.0f));
    if (faces_floor) place = glm::rotate(place, glm::pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
    scene.instances.push_back({.mesh = 1, .world_from_object = place});
    return withOcclusion(std::move(scene), 256).instances[0].occlusion[10 * 21 + 10].open;
  };
  EXPECT_LT(openBelow(true, false), 0.1f);
  EXPECT_LT(openBelow(true, true), 0.1f);
  EXPECT_LT(openBelow(false, true), 0.1f);
  EXPECT_EQ(openBelow(false, false), 1.0f);
}

// A ball of so many triangles that its vertices share their rays hides from a floor what one of few does, and no vertex
// of it knows something else than those beside it.
TEST(SceneOcclusion, AFinelyCutBallKnowsWhatACoarseOneDoes) {
  const auto touchingBalls = [](int rings) {
    Scene scene = meshScene(sphereMesh(rings, 2 * rings), matt(0.5f));
    for (const float x : {-0.52f, 0.52f}) {
      const glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(x, 0.0f, 0.0f));
      scene.instances.push_back({.mesh = 0, .world_from_object = glm::scale(place, glm::vec3(0.5f))});
    }
    scene.instances.erase(scene.instances.begin());
    return withOcclusion(std::move(scene), 0);
  };
  const Scene fine = touchingBalls(200);
  const std::vector<Vertex>& vertices = fine.meshes[0]->vertices;
  const std::vector<VertexOcclusion>& occlusion = fine.instances[0].occlusion;
  ASSERT_GT(vertices.size(), 80'000u);
  // A ball of radius 1 whose middle lies at the distance d, at the angle a from the normal, and that is all above the
  // horizon hides cos a / d².
  std::vector<float> errors(vertices.size(), NAN);
  double square = 0.0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::vec3 to_other = glm::vec3(2.08f, 0.0f, 0.0f) - vertices[i].position;
    const float distance = glm::length(to_other);
    const float cosine = glm::dot(to_other, vertices[i].normal) / distance;
    if (cosine * distance < 1.0f) continue;
    errors[i] = occlusion[i].open - 1.0f + cosine / (distance * distance);
    EXPECT_LT(std::abs(errors[i]), 0.06f) << i;
    square += std::pow(errors[i], 2.0);
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(vertices.size())), 0.006);
  float largest_step = 0.0f;
  const std::vector<std::uint32_t>& indices = fine.meshes[0]->indices;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const float step = std::abs(errors[indices[i + k]] - errors[indices[i + (k + 1) % 3]]);
      if (step > largest_step) largest_step = step;
    }
  EXPECT_GT(largest_step, 0.0f);
  EXPECT_LT(largest_step, 0.06f);
}

TEST(SceneOcclusion, AMeshIsHiddenDifferentlyAtEachPlace) {
  Scene scene = ballOverPlane(0.5f, 0.6f);
  scene.instances.push_back({.mesh = 0, .world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(0, 9, 0))});
  scene = withOcclusion(std::move(scene), 64);
  const std::size_t middle = 10 * 21 + 10;
  EXPECT_LT(scene.instances[0].occlusion[middle].open, 0.4f);
  EXPECT_EQ(scene.instances[2].occlusion[middle].open, 1.0f);
}

TEST(SceneOcclusion, IsTheSameForAnyNumberOfThreads) {
  const int threads = threadLimit();
  Scene shining = bowlScene();
  shining.materials[0].emission = glm::vec3(1.0f, 2.0f, 3.0f);
  const Scene many = withOcclusion(shining, 16);
  setThreadLimit(1);
  const Scene one = withOcclusion(shining, 16);
  setThreadLimit(threads);
  const auto& a = many.instances[0].occlusion;
  const auto& b = one.instances[0].occlusion;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(VertexOcclusion)), 0);
}

// Of what no file should have, nothing is hidden, and nothing is no number.
TEST(SceneOcclusion, TakesMeshesThatAreNotSound) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = gridMesh(1.0f, 2);
  mesh.vertices[0].normal = glm::vec3(0.0f);
  mesh.vertices[1].normal = glm::vec3(nan);
  mesh.vertices[2].position.x = nan;
  mesh.vertices[3].position = mesh.vertices[4].position;  // triangles without area
  mesh.vertices.push_back({});                            // of no triangle
  Material shining = matt(0.5f);
  shining.emission = glm::vec3(1.0f);
  const Scene scene = withOcclusion(meshScene(std::move(mesh), shining), 64);
  for (const VertexOcclusion& occlusion : scene.instances[0].occlusion) {
    EXPECT_EQ(occlusion.open, 1.0f);
    EXPECT_EQ(occlusion.occluded, glm::vec3(0.0f));
    EXPECT_EQ(occlusion.interreflected, glm::vec3(0.0f));
    EXPECT_EQ(occlusion.lit_from, glm::vec3(0.0f));
    EXPECT_EQ(occlusion.emitted, glm::vec3(0.0f));
  }
  EXPECT_TRUE(withOcclusion(Scene(), 0).instances.empty());
  EXPECT_THAT(withOcclusion(meshScene(Mesh(), matt(0.5f)), 0).instances[0].occlusion, SizeIs(0));
}

TEST(SceneOcclusion, StopsWhenTold) {
  Scene bowl = bowlScene();
  const auto geometry = Geometry::make(bowl);
  ASSERT_TRUE(geometry);
  const auto stopped = findOcclusion(bowl, *geometry, {}, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  EXPECT_TRUE(bowl.instances[0].occlusion.empty());
}

// A texture of two halves: what lies in one of them looks as that does, and on their border between both.
TEST(SceneOcclusion, LooksAreWhatTexturesHoldAroundAVertex) {
  Scene scene = meshScene(gridMesh(1.0f, 4), matt(0.5f));
  for (Vertex& vertex : scene.meshes[0].edit().vertices)
    vertex.uv[0] = 0.5f + 0.5f * glm::vec2(vertex.position.x, vertex.position.z);
  Texture halves{.image = Image8(64, 1, 4)};
  for (int x = 0; x < 64; ++x)
    for (int channel = 0; channel < 4; ++channel) halves.image.edit().texel(x, 0)[channel] = x < 32 ? 0 : 255;
  scene.textures.push_back(std::move(halves));
  scene.materials[0].base_color_map.texture = 0;
  scene.materials[0].emission = glm::vec3(3.0f);
  const auto geometry = Geometry::make(scene);
  ASSERT_TRUE(geometry);
  ASSERT_TRUE(findOcclusion(scene, *geometry, {.rays = 1, .finds_materials = true}));
  ASSERT_THAT(scene.instances[0].vertex_materials, SizeIs(scene.meshes[0]->vertices.size()));
  for (std::size_t v = 0; v < scene.meshes[0]->vertices.size(); ++v) {
    const VertexMaterial& material = scene.instances[0].vertex_materials[v];
    const float x = scene.meshes[0]->vertices[v].position.x;
    const float expected = x < -0.1f ? 0.0f : (x > 0.1f ? 0.5f : 0.25f);
    EXPECT_NEAR(material.base_color.x, expected, x > -0.1f && x < 0.1f ? 0.13f : 0.01f) << x;
    EXPECT_EQ(material.emission, glm::vec3(3.0f));
  }
}

}  // namespace
}  // namespace mirrorball
