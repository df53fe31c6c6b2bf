#include "mirrorball/scene/bodies/body_tree.h"

#include <cmath>
#include <limits>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "formula/bodies.h"
#include "mirrorball/scene/mesh_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using testing::glassOf;

/// The same by trying each triangle.
formula::TriangleHit nearestOfAll(const BodyTree& tree, glm::vec3 origin, glm::vec3 direction) {
  const auto first = static_cast<int>(tree.words[0].y);
  const int count = (static_cast<int>(tree.words[0].z) - first) / formula::kTexelsOfTriangle;
  formula::TriangleHit best{formula::kBeyondAll, -1, {}};
  for (int i = 0; i < count; ++i)
    best = formula::nearestOfLeaf(tree, first, formula::leafOf(i, 1), origin, direction, 0.0f, -1,
                                  formula::kNarrowMargin, best);
  return best;
}

TEST(BodyTree, FindsTheNearestTriangle) {
  const auto tree = bodyTree(glassOf(knotMesh(60, 12)));
  ASSERT_TRUE(tree && *tree);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 origin(unit(random), unit(random), unit(random));
    const glm::vec3 direction = glm::normalize(glm::vec3(unit(random), unit(random), unit(random)));
    const auto found = formula::nearestTriangle(**tree, origin, direction, 0.0f, -1, formula::kNarrowMargin);
    const auto expected = nearestOfAll(**tree, origin, direction);
    EXPECT_EQ(found.triangle, expected.triangle);
    EXPECT_EQ(found.distance, expected.distance);
    met += found.triangle >= 0;
  }
  EXPECT_GT(met, 300);
  EXPECT_LT(met, 1900);
}

// Of rays towards the edges of a fine mesh some find no triangle within the narrow margin; with the wide one all do.
TEST(BodyTree, RaysThatSlipThroughAFineMeshAreCaughtByTheWideMargin) {
  const Mesh sphere = sphereMesh(256, 512);
  const auto tree = bodyTree(glassOf(sphere));
  ASSERT_TRUE(tree && *tree);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  int slipped = 0;
  for (std::size_t i = 0; i + 1 < sphere.indices.size(); i += 30) {
    const glm::vec3 origin = 0.55f * glm::vec3(unit(random), unit(random), unit(random));
    const glm::vec3 on_edge = glm::mix(sphere.vertices[sphere.indices[i]].position,
                                       sphere.vertices[sphere.indices[i + 1]].position, 0.5f + 0.4f * unit(random));
    const glm::vec3 direction = glm::normalize(on_edge - origin);
    if (formula::nearestTriangle(**tree, origin, direction, 0.0f, -1, formula::kNarrowMargin).triangle >= 0) continue;
    ++slipped;
    const auto hit = formula::nearestTriangle(**tree, origin, direction, 0.0f, -1, formula::kWideMargin);
    ASSERT_GE(hit.triangle, 0);
    EXPECT_NEAR(hit.distance, glm::distance(origin, on_edge), 1e-4f);
  }
  EXPECT_GT(slipped, 0) << "nothing was tried";
}

// No ray slips through between two triangles, also along axes and through vertices, where boxes have no width.
TEST(BodyTree, ASphereLetsNoRayOut) {
  const Mesh sphere = sphereMesh(16, 32);
  const auto tree = bodyTree(glassOf(sphere));
  ASSERT_TRUE(tree && *tree);
  const auto meets = [&](glm::vec3 direction) {
    return formula::nearestTriangle(**tree, glm::vec3(0.0f), glm::normalize(direction), 0.0f, -1,
                                    formula::kNarrowMargin)
               .triangle >= 0;
  };
  for (std::size_t i = 0; i < sphere.vertices.size(); i += 7) EXPECT_TRUE(meets(sphere.vertices[i].position));
  for (std::size_t i = 0; i < sphere.indices.size(); i += 30) {
    const glm::vec3 a = sphere.vertices[sphere.indices[i]].position;
    const glm::vec3 b = sphere.vertices[sphere.indices[i + 1]].position;
    for (float part = 0.05f; part < 1.0f; part += 0.1f) EXPECT_TRUE(meets(glm::mix(a, b, part)));
  }
}

TEST(BodyTree, TellsNormalAndBodyWhereTheInstanceIs) {
  Scene scene = glassOf(sphereMesh(64, 128));
  scene.materials[0] = *materialNamed("sf11");
  scene.materials[0].priority = -3;
  scene.instances.push_back(
      {.mesh = 0, .world_from_object = glm::scale(glm::translate(glm::mat4(1.0f), {4, 0, 0}), glm::vec3(1, 2, 1))});
  const auto tree = bodyTree(scene);
  ASSERT_TRUE(tree && *tree);
  const BodyTree& words = **tree;
  const glm::vec3 towards = glm::normalize(glm::vec3(0.0f, -2.0f, 1.0f));
  const auto hit = formula::nearestTriangle(words, glm::vec3(4.0f, 0.0f, 0.0f) - 5.0f * towards, towards, 0.0f, -1,
                                            formula::kNarrowMargin);
  ASSERT_GE(hit.triangle, 0);
  const formula::BodySurface surface = formula::bodySurfaceAt(words, hit);
  EXPECT_EQ(surface.body, 1);
  // Of the ellipsoid x² + y²/4 + z² = 1.
  const glm::vec3 place = (hit.distance - 5.0f) * towards;
  const glm::vec3 expected = glm::normalize(place / glm::vec3(1, 4, 1));
  EXPECT_LT(glm::distance(surface.normal, expected), 2e-3f);
  EXPECT_LT(glm::distance(surface.geometric_normal, expected), 0.06f);
  const formula::RefractiveIndex index = formula::bodyAt(words, 1).index;
  EXPECT_EQ(index.ior, scene.materials[0].ior);
  EXPECT_EQ(index.dispersion, scene.materials[0].dispersion);
  EXPECT_EQ(index.sellmeier_b, scene.materials[0].sellmeier_b);
  EXPECT_EQ(index.sellmeier_c, scene.materials[0].sellmeier_c);
  EXPECT_EQ(formula::bodyAt(words, 1).priority, -3);
}

TEST(BodyTree, HasBodiesAloneAndWhatIsFinite) {
  Scene scene = glassOf(sphereMesh(8, 16));
  scene.materials[0].thin_walled = true;
  const auto sheets = bodyTree(scene);
  ASSERT_TRUE(sheets);
  EXPECT_FALSE(*sheets) << "a sheet has no inside";
  ASSERT_TRUE(bodyTree(Scene()));

  scene.materials[0].thin_walled = false;
  for (Vertex& vertex : scene.meshes[0].edit().vertices)
    if (vertex.position.y > 0.5f) vertex.position.x = std::numeric_limits<float>::quiet_NaN();
  const auto damaged = bodyTree(scene);
  ASSERT_TRUE(damaged && *damaged);
  const BodyTree& words = **damaged;
  EXPECT_GE(formula::nearestTriangle(words, glm::vec3(0.0f), {0, -1, 0}, 0.0f, -1, formula::kNarrowMargin).triangle, 0);
  EXPECT_LT(formula::nearestTriangle(words, glm::vec3(0.0f), {0, 1, 0}, 0.0f, -1, formula::kNarrowMargin).triangle, 0);
}

/// A knot and a cube whose vertices each know something else; those of the cube have backs.
Scene withLooks() {
  Scene scene = meshScene(knotMesh(24, 8));
  scene.meshes.push_back(cubeMesh());
  scene.instances.push_back({.mesh = 1, .world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(3, 0, 0))});
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto any = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  for (Instance& instance : scene.instances)
    for (std::size_t v = 0; v < scene.meshes[std::size_t(instance.mesh)]->vertices.size(); ++v) {
      instance.occlusion.push_back({any(), unit(random), any(), any(), any()});
      instance.vertex_materials.push_back({any(), unit(random), 9.0f * any(), unit(random)});
    }
  for (std::size_t v = 0; v < scene.meshes[1]->vertices.size(); ++v)
    scene.instances[1].occlusion.push_back({any(), unit(random), any(), any(), any()});
  return scene;
}

void expectKnown(const formula::SceneSurface& met, const VertexOcclusion& occlusion, const VertexMaterial& material) {
  const float near = 0.02f;  // of values up to 1
  EXPECT_NEAR(glm::distance(glm::vec3(met.occluded), occlusion.occluded), 0.0f, near);
  EXPECT_NEAR(met.occluded.w, occlusion.open, near);
  EXPECT_NEAR(glm::distance(met.interreflected, occlusion.interreflected), 0.0f, near);
  EXPECT_NEAR(glm::distance(met.base_color, material.base_color), 0.0f, near);
  EXPECT_NEAR(glm::distance(met.lit_from, occlusion.lit_from), 0.0f, near);
  EXPECT_NEAR(glm::distance(met.emitted, occlusion.emitted), 0.0f, near);
  EXPECT_NEAR(glm::distance(met.emission, material.emission), 0.0f, 9.0f * near);
  EXPECT_NEAR(met.metallic, material.metallic, near);
  EXPECT_NEAR(met.perceptual_roughness, material.perceptual_roughness, near);
}

// What the tree tells at a corner of a triangle is what its vertex knows, as half floats hold it; from behind, what its
// back knows, or that all is open.
TEST(SceneTree, TellsWhatVerticesKnow) {
  const Scene scene = withLooks();
  const auto tree = sceneTree(scene);
  ASSERT_TRUE(tree && *tree);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    for (std::size_t first = 0; first < mesh.indices.size(); first += 30) {
      const auto corner = [&](std::size_t k) { return mesh.indices[first + k]; };
      const auto place = [&](std::size_t k) {
        return glm::vec3(instance.world_from_object * glm::vec4(mesh.vertices[corner(k)].position, 1.0f));
      };
      const glm::vec3 normal = glm::normalize(glm::cross(place(1) - place(0), place(2) - place(0)));
      const glm::vec3 beside_corner = glm::mix((place(0) + place(1) + place(2)) / 3.0f, place(2), 0.98f);
      for (const bool is_back : {false, true}) {
        const glm::vec3 direction = is_back ? normal : -normal;
        const auto hit = formula::nearestTriangle(**tree, beside_corner - 1e-3f * direction, direction, 0.0f, -1,
                                                  formula::kNarrowMargin);
        ASSERT_GE(hit.triangle, 0);
        const std::size_t known = corner(2) + (is_back ? mesh.vertices.size() : 0);
        expectKnown(formula::sceneSurfaceAt(**tree, hit, direction),
                    known < instance.occlusion.size() ? instance.occlusion[known] : VertexOcclusion(),
                    instance.vertex_materials[corner(2)]);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 10u);
}

// Rays go on through what has only a front where they come from behind, as the eye does.
TEST(SceneTree, RaysPassTheBacksOfWhatHasOnlyAFront) {
  for (const bool has_back : {false, true}) {
    Scene scene = withLooks();
    for (Material& material : scene.materials) material.double_sided = has_back;
    const auto tree = sceneTree(scene);
    ASSERT_TRUE(tree && *tree);
    const glm::vec3 direction(1.0f, 0.0f, 0.0f);
    const auto front =
        formula::nearestTriangle(**tree, glm::vec3(-9, 0, 0), direction, 0.0f, -1, formula::kNarrowMargin);
    ASSERT_GE(front.triangle, 0);
    EXPECT_FALSE(formula::passesTriangle(**tree, front, direction));
    EXPECT_EQ(formula::passesTriangle(**tree, front, -direction), !has_back);
  }
}

TEST(SceneTree, LeavesOutWhatIsSeenThroughAndWhatIsNotKnown) {
  Scene scene = withLooks();
  scene.instances[0].vertex_materials.clear();
  const auto of_cube = sceneTree(scene);
  ASSERT_TRUE(of_cube && *of_cube);
  const auto hit =
      formula::nearestTriangle(**of_cube, glm::vec3(-9, 0, 0), glm::vec3(1, 0, 0), 0.0f, -1, formula::kNarrowMargin);
  EXPECT_NEAR(hit.distance, 12.0f - 1.0f / std::sqrt(3.0f), 1e-4f);
  scene.materials[0].transmission = 1.0f;
  const auto nothing = sceneTree(scene);
  ASSERT_TRUE(nothing);
  EXPECT_FALSE(*nothing);
}

// A ball beside a knot that reaches around it: what a ray from the ball meets is the same without the ball's own part.
TEST(SceneTree, KeepsApartWhatABallDoesNotSeeOfItself) {
  Scene scene = meshScene(sphereMesh(48, 96), Material{});
  scene.meshes.push_back(knotMesh(60, 12));
  scene.instances.push_back({.mesh = 1, .world_from_object = glm::translate(glm::mat4(1.0f), {1.2f, 0.0f, 0.0f})});
  for (Instance& instance : scene.instances) {
    const std::size_t vertices = scene.meshes[std::size_t(instance.mesh)]->vertices.size();
    instance.occlusion.resize(vertices);
    instance.vertex_materials.resize(vertices);
  }
  const auto tree = sceneTree(scene);
  ASSERT_TRUE(tree && *tree);
  const std::vector<int>& unseen = (*tree)->unseen_by_itself;
  ASSERT_EQ(unseen.size(), 2u);
  EXPECT_NE(unseen[0], 0);
  EXPECT_EQ(unseen[1], 0) << "a knot sees itself";
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 normal = glm::normalize(glm::vec3(unit(random), unit(random), unit(random)));
    glm::vec3 d = glm::normalize(glm::vec3(unit(random), unit(random), unit(random)));
    if (glm::dot(d, normal) < 0.0f) d = -d;
    const auto nearest = [&](int left_out) {
      return formula::nearestTriangleBeside(**tree, 1.001f * normal, d, 0.0f, -1, left_out, formula::kNarrowMargin);
    };
    ASSERT_EQ(nearest(unseen[0]).triangle, nearest(0).triangle);
    met += nearest(0).triangle >= 0;
    const auto from_outside =
        formula::nearestTriangleBeside(**tree, -3.0f * normal, normal, 0.0f, -1, unseen[0], formula::kNarrowMargin);
    if (from_outside.triangle >= 0) {
      ASSERT_EQ(formula::bodySurfaceAt(**tree, from_outside).body, 1);
    }
  }
  EXPECT_GT(met, 100);
}

}  // namespace
}  // namespace mirrorball
