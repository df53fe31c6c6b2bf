#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// What bends a mesh: the shapes that it morphs into, and the joints that its vertices hang on.
struct MeshDeformation {
  /// A vertex as it is before.
  struct Basis {
    glm::vec3 position;
    glm::vec3 normal;   ///< unit
    glm::vec4 tangent;  ///< as Vertex's, of a mesh that is not mirrored
  };
  /// What a morph target adds to a vertex.
  struct Displacement {
    std::uint32_t vertex;
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec3 tangent;
  };
  /// How much of a vertex hangs on a joint.
  struct Influence {
    std::uint32_t joint;  ///< index into Skin::joints
    float weight;         ///< those of a vertex sum to 1
  };

  std::vector<Basis> vertices;
  std::vector<std::vector<Displacement>> targets;  ///< of each morph target, for vertices that it moves
  std::vector<Influence> influences;               ///< sorted by vertices
  std::vector<std::size_t> first_influence;        ///< of each vertex, and the end of all; empty: there is no skin
  std::uint32_t joints = 0;                        ///< one more than the greatest that influences name
  /// Normals are those of the triangles, each of three vertices of its own that follow each other.
  bool is_flat = false;

  bool hasSkin() const { return !first_influence.empty(); }
  /// How many vertices, displacements and influences take part, as a measure of the time it takes.
  std::size_t work() const;
  /// How much memory it takes [bytes].
  std::uint64_t size() const;
};

/// Bends a mesh: morphs it, then hangs it on the joints.
///
/// A vertex is at Σ wᵢ Jᵢ (p + Σ tₖ dₖ), with Jᵢ the joints' matrices, wᵢ the vertex's weights of them, and tₖ the
/// weights of the displacements dₖ. Its normal follows the inverse transpose of Σ wᵢ Jᵢ, told by cofactors, so that a
/// scale of 0 divides by nothing; its tangent is brought into the surface again. Texture coordinates, colours and
/// material stay as they are.
///
/// weights  of the morph targets; those that are missing are 0
/// joints   how each joint moves what hangs on it; empty: the mesh hangs on none
/// mesh     with the deformation's vertices; gets their places, normals and tangents, as if nothing mirrored it
/// returns  whether most of its vertices are mirrored by their joints
/// cost     of a million vertices 75 ms with a skin of four joints each, divided by the cores; 10 ms a morph target
///          that moves them all
/// from     Khronos, "glTF 2.0 Specification" (ISO/IEC 12113:2022), sections 3.7.2.2 and 3.7.3
bool deform(const MeshDeformation& how, std::span<const float> weights, std::span<const glm::mat4> joints, Mesh& mesh);

}  // namespace mirrorball
