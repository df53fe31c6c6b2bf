#include "mirrorball/scene/shapes/showcase.h"

#include <string_view>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/facing_viewer.h"
#include "mirrorball/scene/shapes/teapot.h"

namespace mirrorball {
namespace {

glm::mat4 placed(glm::vec3 position, float size) {
  return glm::scale(glm::translate(glm::mat4(1.0f), position), glm::vec3(size));
}

void addObject(Scene& scene, Mesh mesh, std::string_view material, const glm::mat4& arrangement_from_object) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(*materialNamed(material));
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), facingViewer() * arrangement_from_object});
  scene.meshes.push_back(std::move(mesh));
}

}  // namespace

Scene showcaseScene() {
  Scene scene;
  const glm::vec3 x(1, 0, 0);
  const glm::vec3 y(0, 1, 0);
  addObject(scene, sphereMesh(), "mirror", placed({0.0f, 0.58f, -0.35f}, 0.74f));
  addObject(scene, teapotMesh(), "gold", glm::rotate(placed({-0.98f, -0.22f, 0.1f}, 0.72f), glm::radians(-150.0f), y));
  addObject(scene, knotMesh(), "rough-metal", glm::rotate(placed({1.0f, -0.12f, 0.1f}, 0.66f), glm::radians(20.0f), y));
  addObject(scene, sphereMesh(), "glass", placed({-0.40f, -0.74f, 0.55f}, 0.42f));
  addObject(scene, sphereMesh(), "orange", glm::rotate(placed({0.48f, -0.74f, 0.55f}, 0.42f), glm::radians(30.0f), x));
  return scene;
}

}  // namespace mirrorball
