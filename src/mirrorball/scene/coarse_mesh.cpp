#include "mirrorball/scene/coarse_mesh.h"

#include "mirrorball/scene/coarse_triangles.h"

namespace mirrorball {

CoarseMesh coarseMesh(const Mesh& mesh, std::size_t triangles) {
  CoarseMesh coarse{.positions = {}, .indices = mesh.indices};
  if (mesh.indices.size() / 3 > triangles) coarse.indices = coarseTriangles(mesh, triangles);
  constexpr std::uint32_t kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> places(mesh.vertices.size(), kUnused);
  for (std::uint32_t& index : coarse.indices) {
    if (places[index] == kUnused) {
      places[index] = static_cast<std::uint32_t>(coarse.positions.size());
      coarse.positions.push_back(mesh.vertices[index].position);
    }
    index = places[index];
  }
  return coarse;
}

}  // namespace mirrorball
