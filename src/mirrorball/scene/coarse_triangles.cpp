#include "mirrorball/scene/coarse_triangles.h"

#include <meshoptimizer.h>

namespace mirrorball {

std::vector<std::uint32_t> coarseTriangles(const Mesh& mesh, std::size_t triangles) {
  constexpr float kAnyError = 1e30f;
  std::vector<std::uint32_t> indices(mesh.indices.size());
  indices.resize(meshopt_simplifySloppy(indices.data(), mesh.indices.data(), mesh.indices.size(),
                                        &mesh.vertices[0].position.x, mesh.vertices.size(), sizeof(Vertex),
                                        3 * triangles, kAnyError, nullptr));
  return indices;
}

}  // namespace mirrorball
