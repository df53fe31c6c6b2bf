#include "mirrorball/scene/bodies/surrounding_media.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// The next surface after so many counts for the last.
constexpr int kMaxPassed = 512;

/// The bodies that a ray leaves without having entered them, the innermost first.
std::vector<int> bodiesLeft(const Scene& scene, glm::vec3 point, glm::vec3 direction, const FindCrossing& find) {
  formula::Media inside;
  std::vector<int> left;
  float nearest = 0.0f;
  for (int passed = 0; passed < kMaxPassed; ++passed) {
    const auto crossing = find(point, direction, nearest);
    if (!crossing) break;
    nearest = justBehind(crossing->distance);
    const Material& material = materialOf(scene, crossing->instance);
    if (!isBody(material)) continue;
    const int body = static_cast<int>(crossing->instance);
    if (crossing->is_entering)
      inside = formula::entered(inside, body, material.priority);
    else if (formula::timesEntered(inside, body) > 0)
      inside = formula::left(inside, body);
    else
      left.push_back(body);
  }
  return left;
}

}  // namespace

formula::Media surroundingMedia(const Scene& scene, glm::vec3 point, const FindCrossing& find) {
  // Directions in which edges of models seldom lie, and not on one side of the point.
  constexpr std::array<glm::vec3, 3> kDirections{
      {{0.3713f, 0.8017f, 0.4686f}, {-0.8351f, -0.2689f, 0.4798f}, {0.4638f, -0.5328f, -0.7078f}}};
  std::vector<int> candidates;  // the innermost first
  for (const glm::vec3 direction : kDirections)
    for (const int body : bodiesLeft(scene, point, glm::normalize(direction), find)) candidates.push_back(body);
  // An open mesh has a back on one side alone.
  formula::Media around;
  for (auto body = candidates.rbegin(); body != candidates.rend(); ++body)
    if (formula::timesEntered(around, *body) == 0 && std::count(candidates.begin(), candidates.end(), *body) >= 2)
      around = formula::entered(around, *body, materialOf(scene, std::size_t(*body)).priority);
  return around;
}

formula::Media surroundingMedia(const Scene& scene, glm::vec3 point, const BodyTree& tree) {
  return surroundingMedia(scene, point,
                          [&](glm::vec3 origin, glm::vec3 direction, float nearest) -> std::optional<Crossing> {
                            const formula::TriangleHit hit =
                                formula::nearestTriangle(tree, origin, direction, nearest, -1, formula::kNarrowMargin);
                            if (hit.triangle < 0) return std::nullopt;
                            const formula::BodySurface surface = formula::bodySurfaceAt(tree, hit);
                            return Crossing{hit.distance, static_cast<std::size_t>(surface.body),
                                            glm::dot(direction, surface.geometric_normal) < 0.0f};
                          });
}

namespace {

/// The middle of a triangle where an instance puts it.
glm::vec3 middleOf(const Mesh& mesh, const Instance& instance, std::size_t triangle) {
  glm::vec3 sum(0.0f);
  for (std::size_t corner = 0; corner < 3; ++corner) sum += mesh.vertices[mesh.indices[3 * triangle + corner]].position;
  return glm::vec3(instance.world_from_object * glm::vec4(sum / 3.0f, 1.0f));
}

/// Of each vertex a triangle that it belongs to; those of no triangle have the first.
std::vector<std::size_t> trianglesOfVertices(const Mesh& mesh) {
  std::vector<std::size_t> triangles(mesh.vertices.size(), 0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) triangles[mesh.indices[i]] = i / 3;
  return triangles;
}

}  // namespace

std::vector<float> iorAround(const Scene& scene, std::size_t instance, const BodyTree& tree) {
  constexpr std::size_t kGrain = 64;
  const Instance& placed = scene.instances[instance];
  const int own = static_cast<int>(instance);
  const Mesh& mesh = scene.meshes[std::size_t(placed.mesh)];
  if (mesh.indices.empty()) return {};
  const std::vector<std::size_t> triangles = trianglesOfVertices(mesh);
  std::vector<float> indices(mesh.vertices.size(), 1.0f);
  parallelFor(indices.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      formula::Media around = surroundingMedia(scene, middleOf(mesh, placed, triangles[i]), tree);
      while (formula::timesEntered(around, own) > 0) around = formula::left(around, own);
      const int body = formula::fillingBody(around);
      if (body >= 0) indices[i] = materialOf(scene, std::size_t(body)).ior;
    }
  });
  const bool lies_in_air = std::all_of(indices.begin(), indices.end(), [](float ior) { return ior == 1.0f; });
  return lies_in_air ? std::vector<float>() : indices;
}

}  // namespace mirrorball
