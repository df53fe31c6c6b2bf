#include "mirrorball/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/positions.h"

namespace mirrorball {

const Material& materialOf(const Scene& scene, std::size_t instance) {
  return scene.materials[std::size_t(scene.meshes[std::size_t(scene.instances[instance].mesh)]->material)];
}

bool knowsBacks(const Scene& scene, std::size_t instance) {
  const Instance& of = scene.instances[instance];
  return of.occlusion.size() > scene.meshes[std::size_t(of.mesh)]->vertices.size();
}

Scene meshScene(Mesh mesh, Material material) {
  Scene scene;
  mesh.material = 0;
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(std::move(material));
  scene.instances.emplace_back();
  return scene;
}

Result<void> chooseVariant(Scene& scene, const std::string& name) {
  if (scene.variants.empty())
    return fail(ErrorCode::usage,
                "the model has no variants of its materials, so none is named '" + excerpt(name) + "'");
  const std::vector<std::string_view> names(scene.variants.begin(), scene.variants.end());
  const auto index = indexOfName(name, names);
  if (!index) return tl::unexpected<Error>(unknownName("variant", name, names));
  for (Shared<Mesh>& mesh : scene.meshes) {
    if (mesh->material_of_variant.empty()) continue;
    const int material = mesh->material_of_variant[*index];
    if (mesh->material != material) mesh.edit().material = material;
  }
  return {};
}

void standUpright(Scene& scene, UpAxis up) {
  if (up == UpAxis::y) return;
  const glm::mat4 y_from_z(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 0, 1));
  for (Instance& instance : scene.instances) instance.world_from_object = y_from_z * instance.world_from_object;
  scene.rig.world_from_roots = glm::dmat4(y_from_z) * scene.rig.world_from_roots;
  scene.origin = glm::dmat3(glm::mat3(y_from_z)) * scene.origin;
  for (ModelCamera& camera : scene.cameras) camera.world_from_view = y_from_z * camera.world_from_view;
  for (ModelLight& light : scene.lights) {
    light.position = glm::vec3(y_from_z * glm::vec4(light.position, 1.0f));
    light.direction = glm::vec3(y_from_z * glm::vec4(light.direction, 0.0f));
  }
}

DoubleBox boxOfPositions(const Scene& scene) {
  DoubleBox box;
  forEachPosition(scene, glm::dmat4(1.0), [&](glm::dvec3 position) { box.include(position); });
  return box;
}

std::vector<std::vector<PositionRun>> positionRuns(const Scene& scene) {
  constexpr std::size_t kLongest = 64;
  std::vector<std::vector<PositionRun>> runs;
  for (const Mesh& mesh : scene.meshes) {
    auto& of_mesh = runs.emplace_back();
    const std::size_t count = framedVertices(mesh);
    for (std::size_t first = 0; first < count; first += kLongest) {
      PositionRun run{first, std::min(kLongest, count - first), {}};
      for (std::size_t i = first; i < first + run.count; ++i)
        run.box.include({mesh.vertices[i].position, mesh.vertices[i].position});
      of_mesh.push_back(run);
    }
  }
  return runs;
}

Box boundingBox(const Scene& scene) { return boxOfPositions(scene).rounded(); }

Box boundingBox(const Scene& scene, const Instance& instance) {
  DoubleBox box;
  forEachPosition(scene, instance, glm::dmat4(1.0), [&](glm::dvec3 position) { box.include(position); });
  return box.rounded();
}

BoundingSphere boundingSphere(const Scene& scene) {
  const DoubleBox box = boxOfPositions(scene);
  if (box.isEmpty()) return {.origin = scene.origin};

  const glm::dvec3 center = box.center();
  double squared_radius = 0.0;
  forEachPosition(scene, glm::dmat4(1.0), [&](glm::dvec3 position) {
    const glm::dvec3 away = position - center;
    squared_radius = std::max(squared_radius, glm::dot(away, away));
  });
  // A single point still needs a ball that a camera can stand off from.
  const double radius = squared_radius > 0.0 ? std::sqrt(squared_radius) : 1.0;
  return {glm::vec3(center), std::max(static_cast<float>(radius), std::numeric_limits<float>::min()), scene.origin};
}

}  // namespace mirrorball
