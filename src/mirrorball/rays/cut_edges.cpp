#include "mirrorball/rays/cut_edges.h"

#include <functional>
#include <tuple>
#include <utility>

namespace mirrorball {

CutEdges::Edge CutEdges::inOrder(glm::vec3 a, glm::vec3 b) {
  if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) std::swap(a, b);
  return {a, b};
}

std::size_t CutEdges::Hash::operator()(const Edge& edge) const {
  std::size_t hash = 0;
  // 0 and −0 are equal and have the same hash.
  for (const float number : {edge.a.x, edge.a.y, edge.a.z, edge.b.x, edge.b.y, edge.b.z})
    hash = 31 * hash + std::hash<float>()(number);
  return hash;
}

}  // namespace mirrorball
