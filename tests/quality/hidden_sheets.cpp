#include <cmath>
#include <utility>
#include <vector>

#include "formula/constants.h"
#include "mirrorball/scene/shapes/revolution.h"
#include "quality/hidden_makers.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

/// Shows the other side of its triangles.
Mesh turnedOver(Mesh mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (Vertex& vertex : mesh.vertices) vertex.normal = -vertex.normal;
  return mesh;
}

/// Half a cylinder about the Y axis from the ground up, open towards +Z, with its front outside.
Mesh halfCylinder(float radius, float height) {
  Mesh mesh = rectangle({0, 0.5f * height, 0}, {-1, 0, 0}, {0, 0.5f * height, 0}, 24);
  for (Vertex& vertex : mesh.vertices) {
    const float angle = 0.5f * formula::kPi * vertex.position.x;
    vertex.normal = {std::sin(angle), 0.0f, -std::cos(angle)};
    vertex.tangent = {-std::cos(angle), 0.0f, -std::sin(angle), 1.0f};
    vertex.position = radius * vertex.normal + glm::vec3(0, vertex.position.y, 0);
  }
  return mesh;
}

Scene halfCylinderWithBall(bool faces_inwards) {
  Scene scene;
  add(scene, ground(1.6f, 32), matt({0.65f, 0.65f, 0.65f}));
  Mesh sheet = halfCylinder(0.8f, 1.1f);
  add(scene, faces_inwards ? turnedOver(std::move(sheet)) : std::move(sheet), matt({0.85f, 0.6f, 0.4f}));
  add(scene, ball({0.1f, 0.35f, -0.1f}, 0.35f), matt({0.8f, 0.8f, 0.85f}));
  return scene;
}

Scene levelSheet(bool faces_up) {
  Scene scene;
  add(scene, ground(1.2f, 24), matt({0.7f, 0.7f, 0.7f}));
  Mesh sheet = rectangle({0, 0.25f, 0}, {0.6f, 0, 0}, {0, 0, -0.6f}, 8);
  add(scene, faces_up ? std::move(sheet) : turnedOver(std::move(sheet)), matt({0.8f, 0.3f, 0.2f}));
  add(scene, ball({0.35f, 0.12f, 0.2f}, 0.12f), matt({0.3f, 0.5f, 0.8f}));
  return scene;
}

/// Five cards at a height over a board of 2 × 2.
Scene cards(float height) {
  Scene scene;
  add(scene, ground(1.0f), matt({0.75f, 0.75f, 0.75f}));
  const auto addCard = [&](glm::vec3 middle, float half_width, float half_depth, glm::vec3 color) {
    Material material = matt(color);
    material.double_sided = true;
    add(scene, rectangle(middle + glm::vec3(0, height, 0), {half_width, 0, 0}, {0, 0, -half_depth}), material);
  };
  addCard({-0.5f, 0, -0.45f}, 0.3f, 0.35f, {0.85f, 0.8f, 0.6f});
  addCard({0.3f, 0, -0.5f}, 0.35f, 0.25f, {0.8f, 0.3f, 0.25f});
  addCard({-0.55f, 0, 0.4f}, 0.25f, 0.3f, {0.3f, 0.55f, 0.75f});
  addCard({0.1f, 0, 0.35f}, 0.25f, 0.4f, {0.9f, 0.9f, 0.9f});
  addCard({0.7f, 0, 0.3f}, 0.15f, 0.45f, {0.4f, 0.7f, 0.4f});
  return scene;
}

/// Ten triangles of walls and two of a lamp; without the wall towards +Z.
Scene emptyRoom() {
  Scene scene;
  const Material white = matt(glm::vec3(0.8f));
  add(scene, ground(1.0f), white);
  add(scene, rectangle({0, 2, 0}, {1, 0, 0}, {0, 0, 1}), white);
  add(scene, rectangle({0, 1, -1}, {1, 0, 0}, {0, 1, 0}), white);
  add(scene, rectangle({-1, 1, 0}, {0, 0, -1}, {0, 1, 0}), matt({0.75f, 0.2f, 0.15f}));
  add(scene, rectangle({1, 1, 0}, {0, 0, 1}, {0, 1, 0}), matt({0.2f, 0.6f, 0.25f}));
  Material lamp = matt(glm::vec3(0.0f));
  lamp.emission = glm::vec3(4.0f, 3.6f, 3.0f);
  add(scene, rectangle({0, 1.98f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}), lamp);
  return scene;
}

}  // namespace

Scene sheetFacingOutwards() { return halfCylinderWithBall(false); }

Scene sheetFacingInwards() { return halfCylinderWithBall(true); }

Scene sheetFacingUp() { return levelSheet(true); }

Scene sheetFacingDown() { return levelSheet(false); }

Scene dome() {
  Scene scene;
  add(scene, ground(1.3f, 32), matt({0.7f, 0.65f, 0.6f}));
  std::vector<ProfilePoint> profile;
  addArc(profile, {0.0, 0.0}, 1.0, 90.0, 0.0, 16);
  add(scene, revolvedMesh(profile, 64), matt({0.4f, 0.5f, 0.8f}));
  add(scene, ball({0.1f, 0.3f, -0.2f}, 0.3f), matt({0.85f, 0.8f, 0.7f}));
  return scene;
}

Scene cardsNearBoard() { return cards(0.02f); }

Scene cardsOverBoard() { return cards(0.1f); }

Scene panels() {
  Scene scene;
  const auto tint = [](int number) { return matt(glm::vec3(0.72f) - 0.06f * static_cast<float>(number % 3)); };
  for (int i = 0; i < 4; ++i) {
    const float x = 0.7f * static_cast<float>(i) - 1.05f;
    add(scene, rectangle({x, 0.8f, -0.6f}, {0.35f, 0, 0}, {0, 0.8f, 0}), tint(i));
    add(scene, rectangle({x, 0, 0.2f}, {0.35f, 0, 0}, {0, 0, -0.8f}), tint(i + 1));
  }
  add(scene, box({-0.6f, 0.7f, -0.4f}, {0.07f, 0.7f, 0.07f}), matt({0.7f, 0.3f, 0.2f}));
  add(scene, ball({0.15f, 0.3f, -0.25f}, 0.3f), matt({0.3f, 0.5f, 0.7f}));
  add(scene, box({0.8f, 0.9f, -0.45f}, {0.4f, 0.03f, 0.15f}), matt({0.6f, 0.5f, 0.3f}));
  return scene;
}

Scene roomOfTwelve() { return emptyRoom(); }

Scene furnishedRoom() {
  Scene scene = emptyRoom();
  add(scene, ball({-0.4f, 0.35f, 0.2f}, 0.35f), matt({0.85f, 0.85f, 0.85f}));
  add(scene, box({0.45f, 0.55f, -0.35f}, {0.28f, 0.55f, 0.28f}), matt({0.7f, 0.65f, 0.5f}));
  return scene;
}

Scene postOnFloor() {
  Scene scene;
  add(scene, ground(1.5f), matt({0.75f, 0.73f, 0.7f}));
  add(scene, box({-0.6f, 0.6f, -0.2f}, {0.06f, 0.6f, 0.06f}), matt({0.8f, 0.3f, 0.2f}));
  const Material wood = matt({0.6f, 0.45f, 0.3f});
  add(scene, box({0.4f, 0.5f, 0.1f}, {0.45f, 0.03f, 0.35f}), wood);
  for (const float x : {0.0f, 0.8f})
    for (const float z : {-0.2f, 0.4f}) add(scene, box({x, 0.235f, z}, {0.03f, 0.235f, 0.03f}), wood);
  return scene;
}

}  // namespace mirrorball::quality
