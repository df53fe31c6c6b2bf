#include "mirrorball/rays/triangle_holes.h"

#include <gtest/gtest.h>

#include "formula/bodies.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

bool isCutAway(int column, int row) { return (column + row) % 2 == 0; }

/// A square of two triangles across z = 0, of 8 × 8 squares of which every other one is cut away.
Scene checkeredSquare() {
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    Vertex vertex;
    vertex.position = glm::vec3(corner, 0.0f);
    vertex.normal = {0.0f, 0.0f, 1.0f};
    vertex.uv[0] = 0.5f + 0.5f * corner;
    mesh.vertices.push_back(vertex);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  Scene scene = meshScene(std::move(mesh), Material{});
  Image8 squares(8, 8, 4, 255);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      if (isCutAway(column, row)) squares.texel(column, row)[3] = 0;
  Texture texture;
  texture.image = squares;
  texture.nearest = true;
  scene.textures.push_back(std::move(texture));
  scene.materials[0].base_color_map.texture = 0;
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.instances[0].occlusion.resize(4);
  scene.instances[0].vertex_materials.resize(4);
  return scene;
}

TEST(TriangleHoles, RaysPassWhatAMaskCutsAway) {
  Scene scene = checkeredSquare();
  findHoles(scene);
  ASSERT_EQ(scene.instances[0].holes.size(), 2u);
  const auto tree = sceneTree(scene);
  ASSERT_TRUE(tree && *tree);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      for (const glm::vec2 within : {glm::vec2(0.3f, 0.2f), glm::vec2(0.4f, 0.8f)}) {
        const glm::vec2 place = (glm::vec2(column, row) + within) / 4.0f - 1.0f;
        constexpr glm::vec3 kDown(0.0f, 0.0f, -1.0f);
        const auto hit =
            formula::nearestTriangle(**tree, glm::vec3(place, 1.0f), kDown, 0.0f, -1, formula::kNarrowMargin);
        ASSERT_GE(hit.triangle, 0);
        EXPECT_EQ(formula::passesTriangle(**tree, hit, kDown), isCutAway(column, row)) << column << " " << row;
      }
}

TEST(TriangleHoles, WhatIsWholeHasNone) {
  Scene scene = checkeredSquare();
  scene.materials[0].alpha_cutoff = 0.0f;
  findHoles(scene);
  EXPECT_TRUE(scene.instances[0].holes.empty());
  scene.materials[0].alpha_mode = AlphaMode::opaque;
  findHoles(scene);
  EXPECT_TRUE(scene.instances[0].holes.empty());
}

}  // namespace
}  // namespace mirrorball
