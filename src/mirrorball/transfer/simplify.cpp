#include "mirrorball/transfer/simplify.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include <meshoptimizer.h>

#include "mirrorball/scene/equal_vertices.h"

namespace mirrorball {
namespace {

/// For each vertex the first one at the same place, but for rounding: a pole whose corners differ in the last digit
/// would be a hole, which is kept to the end.
std::vector<std::uint32_t> firstNearPlace(const std::vector<Vertex>& vertices) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
  for (const Vertex& vertex : vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  const glm::vec3 side = high - low;
  const float step = std::max({side.x, side.y, side.z, std::numeric_limits<float>::min()}) * 0x1p-22f;
  return firstOfEqual(vertices, [&](const Vertex& vertex) {
    const glm::vec3 place = glm::round((vertex.position - low) / step);
    return std::array{place.x, place.y, place.z};
  });
}

/// Leaves vertices out that no triangle has.
void dropUnused(Mesh& mesh) {
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
  std::vector<Vertex> used;
  for (std::uint32_t& index : mesh.indices) {
    if (place[index] == kUnused) {
      place[index] = static_cast<std::uint32_t>(used.size());
      used.push_back(mesh.vertices[index]);
    }
    index = place[index];
  }
  mesh.vertices = std::move(used);
}

/// All triangles where they are, each place one vertex; without those whose corners are at fewer than three places.
Mesh joined(const Scene& scene) {
  Mesh all;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
      all.vertices.emplace_back().position = glm::vec3(instance.world_from_object * glm::vec4(vertex.position, 1.0f));
    for (const std::uint32_t index : mesh.indices) all.indices.push_back(first + index);
  }
  const std::vector<std::uint32_t> firsts = firstNearPlace(all.vertices);
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < all.indices.size(); i += 3) {
    const std::array corner{firsts[all.indices[i]], firsts[all.indices[i + 1]], firsts[all.indices[i + 2]]};
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    for (const std::uint32_t index : corner) all.indices[kept++] = index;
  }
  all.indices.resize(kept);
  dropUnused(all);  // to meshoptimizer two vertices at one place would be a seam, though one of them has no triangle
  return all;
}

}  // namespace

Result<Simplified> simplified(const Scene& scene, std::size_t triangles) {
  assert(triangles >= 1);
  Simplified result{joined(scene)};
  Mesh& mesh = result.mesh;
  if (mesh.indices.empty()) return fail(ErrorCode::bad_shape, "has no triangles to make fewer of");
  if (3 * triangles < mesh.indices.size()) {
    std::vector<std::uint32_t> fewer(mesh.indices.size());
    fewer.resize(meshopt_simplify(fewer.data(), mesh.indices.data(), mesh.indices.size(), &mesh.vertices[0].position.x,
                                  mesh.vertices.size(), sizeof(Vertex), 3 * triangles,
                                  std::numeric_limits<float>::max(), 0u, &result.error));
    mesh.indices = std::move(fewer);
  }
  if (mesh.indices.empty())
    return fail(ErrorCode::bad_shape, "with so few triangles nothing is left of it; ask for more of them");
  dropUnused(mesh);
  computeNormals(mesh);
  return result;
}

}  // namespace mirrorball
