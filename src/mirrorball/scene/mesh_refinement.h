#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
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

  /// The mesh as it is so far.
  const Mesh& mesh() const { return mesh_; }
  /// All cuts so far.
  MeshRefinement refinement() const;

 private:
  Mesh mesh_;
  std::vector<std::uint32_t> places_;  // of each vertex; those at the same place have the same number
  std::uint32_t next_place_;
  std::vector<glm::uvec2> parents_;
};

}  // namespace mirrorball
