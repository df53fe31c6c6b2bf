#include "mirrorball/scene/shapes/showcase.h"

#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/faceted.h"
#include "mirrorball/scene/shapes/facing_viewer.h"
#include "mirrorball/scene/shapes/teapot.h"
#include "mirrorball/scene/shapes/tumbler.h"

namespace mirrorball {
namespace {

/// How an object stands: turned, then scaled, then put on the ground, x to the right and z towards the viewer.
struct Stand {
  glm::vec2 place;  ///< x, z
  float size;
  glm::mat4 turn{1.0f};
};

glm::mat4 turned(float angle_deg, glm::vec3 axis) {
  return glm::rotate(glm::mat4(1.0f), glm::radians(angle_deg), axis);
}

constexpr glm::vec3 kX(1, 0, 0), kY(0, 1, 0);

/// Adds what a scene has, with its lowest point on the ground.
void addStanding(Scene& all, Scene object, const Stand& stand) {
  const glm::mat4 turned_and_scaled = glm::scale(glm::mat4(1.0f), glm::vec3(stand.size)) * stand.turn;
  for (Instance& instance : object.instances)
    instance.world_from_object = turned_and_scaled * instance.world_from_object;
  const glm::vec3 place(stand.place.x, -boundingBox(object).low.y, stand.place.y);
  const int first_mesh = static_cast<int>(all.meshes.size());
  const int first_material = static_cast<int>(all.materials.size());
  for (Shared<Mesh>& mesh : object.meshes) {
    mesh.edit().material += first_material;
    all.meshes.push_back(mesh);
  }
  all.materials.insert(all.materials.end(), object.materials.begin(), object.materials.end());
  for (Instance& instance : object.instances) {
    instance.mesh += first_mesh;
    instance.world_from_object = facingViewer() * glm::translate(glm::mat4(1.0f), place) * instance.world_from_object;
    all.instances.push_back(instance);
  }
}

Scene shapeOf(Mesh mesh, std::string_view material) { return meshScene(std::move(mesh), *materialNamed(material)); }

}  // namespace

Scene showcaseScene() {
  Scene all;
  addStanding(all, shapeOf(sphereMesh(), "mirror"), {{0.05f, -0.80f}, 0.74f});
  addStanding(all, shapeOf(teapotMesh(), "gold"), {{-1.20f, 0.30f}, 0.66f, turned(-155.0f, kY)});
  addStanding(all, shapeOf(knotMesh(), "rough-metal"), {{1.25f, -0.60f}, 0.66f, turned(25.0f, kY)});
  Scene tumbler = tumblerWaterScene();
  for (Material& material : tumbler.materials) material.dispersion = 0.0f;  // which is not to be seen, and costs
  addStanding(all, std::move(tumbler), {{0.86f, 0.52f}, 0.42f});
  addStanding(all, shapeOf(sphereMesh(), "orange"), {{0.10f, 0.72f}, 0.26f, turned(30.0f, kX)});
  // It lies on its pavilion and the edge of its girdle.
  addStanding(all, shapeOf(brilliantMesh(), "diamond"),
              {{-0.36f, 0.92f}, 0.17f, turned(20.0f, kY) * turned(49.25f, kX)});
  return all;
}

}  // namespace mirrorball
