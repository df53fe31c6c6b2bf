#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// How a mesh's triangles are cut in the middles of edges.
struct MeshRefinement {
  /// Of each new vertex the two that it lies between: vertices of the mesh, or new ones that come before it.
  std::vector<glm::uvec2> parents = {};
  std::vector<std::uint32_t> indices = {};  ///< of all triangles; empty: none is cut

  bool empty() const { return indices.empty(); }
};

/// Cuts a mesh so. All that is interpolated between vertices stays what it was: the normals and tangents of new
/// vertices are the means of their parents', and not unit.
void refine(Mesh& mesh, const MeshRefinement& refinement);

/// Cuts triangles of a mesh step by step; their neighbours in the mesh are cut with them, across seams too, so that no
/// gaps open within it.
class MeshRefiner {
 public:
  explicit MeshRefiner(Mesh mesh);

  /// Of each triangle that is cut the long edges: those of more than half the length of its longest.
  ///
  /// is_cut    of each triangle, not 0: it is cut
  /// returns   of each new triangle the old one that it lies in
  std::vector<std::uint32_t> cut(std::span<const std::uint8_t> is_cut);

  /// Cuts edges in their middles.
  ///
  /// is_cut    of the positions of an edge's ends, in any order
  /// returns   whether there were any
  bool cutEdges(const std::function<bool(glm::vec3, glm::vec3)>& is_cut);

  /// The mesh as it is so far.
  const Mesh& mesh() const { return mesh_; }
  /// MeshRefinement::parents so far.
  std::span<const glm::uvec2> parents() const { return parents_; }
  /// All cuts so far.
  MeshRefinement refinement() const;

 private:
  /// By the places of an edge's ends, the place of its middle.
  using Middles = std::unordered_map<std::uint64_t, std::uint32_t>;

  void addMiddle(Middles& middles, std::size_t triangle, std::size_t edge);
  std::vector<std::uint32_t> cutAt(const Middles& middles);

  Mesh mesh_;
  std::vector<std::uint32_t> places_;  // of each vertex; those at the same place have the same number
  std::uint32_t next_place_;
  std::vector<glm::uvec2> parents_;
};

}  // namespace mirrorball
