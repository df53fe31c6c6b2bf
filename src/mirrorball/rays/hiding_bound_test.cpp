#include "mirrorball/rays/hiding_bound.h"

#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/rays/seen_from.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// A square in the plane y = height, facing upwards, of two triangles.
Mesh square(float half, float height) {
  Mesh mesh;
  for (const glm::vec2 at : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)})
    mesh.vertices.push_back({.position = {half * at.x, height, half * at.y}, .normal = {0.0f, 1.0f, 0.0f}});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

Scene withInstance(Scene scene, Mesh mesh, const glm::mat4& place = glm::mat4(1.0f), bool double_sided = false) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.emplace_back();
  scene.materials.back().double_sided = double_sided;
  scene.instances.push_back({.mesh = static_cast<int>(scene.meshes.size()), .world_from_object = place});
  scene.meshes.push_back(std::move(mesh));
  return scene;
}

bool hides(const Scene& scene) {
  const auto found = hidesItself(scene);
  EXPECT_TRUE(found);
  return found && *found;
}

TEST(HidingBound, ConvexBodiesHideNothing) {
  EXPECT_FALSE(hides(meshScene(square(1.0f, 0.0f), Material{})));
  for (const int rings : {4, 24, 100})
    EXPECT_FALSE(hides(meshScene(sphereMesh(rings, 2 * rings), Material{}))) << rings;
  EXPECT_FALSE(hides(meshScene(cubeMesh(), Material{})));
}

TEST(HidingBound, BodiesFarApartHideLittle) {
  const auto apart = [](float distance) {
    return withInstance(meshScene(sphereMesh(24, 48), Material{}), sphereMesh(24, 48),
                        glm::translate(glm::mat4(1.0f), glm::vec3(distance, 0.0f, 0.0f)));
  };
  EXPECT_TRUE(hides(apart(2.2f)));
  EXPECT_FALSE(hides(apart(20.0f)));
}

// A card of a thousandth of the board's area lies over it, among so many triangles of a far-off ball that the card's
// are not among the thousand that are sampled.
TEST(HidingBound, NoContactEscapes) {
  const glm::mat4 far_off = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -50.0f, 0.0f));
  const Scene board = withInstance(meshScene(square(1.0f, 0.0f), Material{}), sphereMesh(60, 120), far_off);
  EXPECT_FALSE(hides(board));
  EXPECT_TRUE(hides(withInstance(board, square(0.03f, 0.005f), glm::mat4(1.0f), true)));
}

TEST(HidingBound, GlassHidesNothing) {
  const auto balls = [](float transmission) {
    Scene scene = withInstance(meshScene(sphereMesh(24, 48), Material{}), sphereMesh(24, 48),
                               glm::translate(glm::mat4(1.0f), glm::vec3(2.2f, 0.0f, 0.0f)));
    for (Material& material : scene.materials) material.transmission = transmission;
    return scene;
  };
  EXPECT_FALSE(hides(balls(1.0f)));
  EXPECT_TRUE(hides(balls(0.5f)));
}

// A shallow dish, whose rim is seen 5° above the plane of its middle, and a deep one.
TEST(HidingBound, AShallowDishHidesLittle) {
  const auto dish = [](float depth) {
    Mesh mesh = sphereMesh(24, 48);
    for (Vertex& vertex : mesh.vertices) {
      const float from_axis = glm::length(glm::vec2(vertex.position.x, vertex.position.z));
      vertex.position.y = vertex.position.y > 0.0f ? depth * from_axis * from_axis : -0.5f + 0.5f * from_axis;
    }
    computeNormals(mesh);
    return meshScene(std::move(mesh), Material{});
  };
  EXPECT_FALSE(hides(dish(0.04f)));
  EXPECT_TRUE(hides(dish(0.6f)));
}

TEST(HidingBound, TakesMeshesThatAreNotSound) {
  Mesh mesh = square(1.0f, 0.0f);
  mesh.vertices[3].position.x = NAN;
  EXPECT_FALSE(hides(meshScene(std::move(mesh), Material{})));
  EXPECT_FALSE(hides(Scene()));
}

}  // namespace
}  // namespace mirrorball
