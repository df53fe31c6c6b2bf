#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "quality/hidden_makers.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

constexpr int kFineRings = 159;  // 100 172 triangles a ball
constexpr int kGridSide = 11;    // of a grid

/// Where a ball of the grid hangs.
glm::vec3 placeInGrid(int column, int row) {
  return {0.25f * static_cast<float>(column - kGridSide / 2), 0.25f * static_cast<float>(row - kGridSide / 2), 0.12f};
}

Mesh wallBehindGrid() { return rectangle({0, 0, -0.05f}, {1.5f, 0, 0}, {0, 1.5f, 0}); }

}  // namespace

Scene fineBalls() {
  Scene scene;
  add(scene, ground(2.0f, 224), matt({0.6f, 0.6f, 0.6f}));
  add(scene, ball({-0.68f, 0.7f, 0.0f}, 0.7f, kFineRings), matt({0.85f, 0.8f, 0.75f}, 0.9f));
  add(scene, ball({0.75f, 0.7f, 0.1f}, 0.7f, kFineRings), roughMetal({0.9f, 0.7f, 0.4f}, 0.5f));
  return scene;
}

Scene gridOfFineBalls() {
  Scene scene;
  add(scene, wallBehindGrid(), matt({0.5f, 0.5f, 0.5f}));
  add(scene, ball({0, 0, 0}, 0.12f, kFineRings), matt({0.8f, 0.75f, 0.7f}, 0.5f));
  const Instance first = scene.instances.back();
  scene.instances.pop_back();
  for (int row = 0; row < kGridSide; ++row)
    for (int column = 0; column < kGridSide; ++column) {
      scene.instances.push_back(first);
      scene.instances.back().world_from_object = glm::translate(glm::mat4(1.0f), placeInGrid(column, row));
    }
  return scene;
}

Scene gridOfBalls() {
  Scene scene;
  add(scene, wallBehindGrid(), matt({0.5f, 0.5f, 0.5f}));
  for (int row = 0; row < kGridSide; ++row)
    for (int column = 0; column < kGridSide; ++column) {
      Material material = matt({0.9f, 0.7f, 0.5f}, 0.1f * static_cast<float>(column));
      material.metallic = row > kGridSide / 2 ? 1.0f : 0.0f;
      add(scene, ball(placeInGrid(column, row), 0.12f, 28), material);
    }
  return scene;
}

Scene fineFloor() {
  Scene scene;
  add(scene, ground(1.6f, 316), matt({0.7f, 0.68f, 0.65f}));
  add(scene, box({-0.7f, 0.35f, -0.2f}, {0.3f, 0.35f, 0.3f}), matt({0.8f, 0.4f, 0.3f}));
  add(scene, box({0.2f, 0.15f, 0.4f}, {0.4f, 0.15f, 0.2f}), matt({0.4f, 0.6f, 0.8f}));
  add(scene, box({0.7f, 0.6f, -0.4f}, {0.15f, 0.6f, 0.15f}), matt(glm::vec3(0.85f)));
  return scene;
}

Scene fineKnot() {
  Scene scene;
  Mesh floor = ground(1.8f);
  for (Vertex& vertex : floor.vertices) vertex.position.y = -0.85f;
  add(scene, std::move(floor), matt({0.5f, 0.5f, 0.55f}));
  add(scene, knotMesh(1500, 68), matt({0.85f, 0.83f, 0.8f}, 0.6f));
  return scene;
}

}  // namespace mirrorball::quality
