// For a build without meshoptimizer: all vertices of a cell of a grid become the first of them.
#include <array>
#include <map>

#include "mirrorball/scene/box.h"
#include "mirrorball/scene/coarse_triangles.h"

namespace mirrorball {
namespace {

/// The triangles whose corners are in three cells of a grid that has so many along the longest side.
std::vector<std::uint32_t> joinedInCells(const Mesh& mesh, const Box& box, int cells) {
  const glm::vec3 size = box.high - box.low;
  const float side = std::max({size.x, size.y, size.z}) / static_cast<float>(cells);
  std::map<std::array<int, 3>, std::uint32_t> first_of_cell;
  std::vector<std::uint32_t> first(mesh.vertices.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    const glm::ivec3 cell((mesh.vertices[i].position - box.low) / side);
    first[i] = first_of_cell.emplace(std::array{cell.x, cell.y, cell.z}, i).first->second;
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array corner{first[mesh.indices[i]], first[mesh.indices[i + 1]], first[mesh.indices[i + 2]]};
    if (corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0])
      indices.insert(indices.end(), corner.begin(), corner.end());
  }
  return indices;
}

}  // namespace

std::vector<std::uint32_t> coarseTriangles(const Mesh& mesh, std::size_t triangles) {
  Box box;
  for (const Vertex& vertex : mesh.vertices) box.include({vertex.position, vertex.position});
  if (!glm::all(glm::equal(box.low, box.low)) || box.low == box.high) return {};
  // The finest grid that leaves no more, by halving: finer ones leave more.
  int coarse = 1, fine = 1024;
  std::vector<std::uint32_t> best;
  while (fine - coarse > 1) {
    const int cells = (coarse + fine) / 2;
    std::vector<std::uint32_t> indices = joinedInCells(mesh, box, cells);
    if (indices.size() > 3 * triangles) {
      fine = cells;
    } else {
      coarse = cells;
      best = std::move(indices);
    }
  }
  return best;
}

}  // namespace mirrorball
