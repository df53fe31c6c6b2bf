#pragma once

#include <cstddef>
#include <unordered_set>

#include <glm/glm.hpp>

namespace mirrorball {

/// Edges in the world that are cut in their middles, whatever mesh they belong to: where one material ends and another
/// begins, two meshes have the same edge, and if only one of them were cut there, pixels would fall between the two.
class CutEdges {
 public:
  void insert(glm::vec3 a, glm::vec3 b) { edges_.insert(inOrder(a, b)); }
  /// Whether it was inserted, from either end. Places are the same where all their digits are.
  bool contains(glm::vec3 a, glm::vec3 b) const { return edges_.contains(inOrder(a, b)); }
  bool empty() const { return edges_.empty(); }

 private:
  struct Edge {
    glm::vec3 a;
    glm::vec3 b;
    bool operator==(const Edge&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Edge& edge) const;
  };
  static Edge inOrder(glm::vec3 a, glm::vec3 b);

  std::unordered_set<Edge, Hash> edges_;
};

}  // namespace mirrorball
