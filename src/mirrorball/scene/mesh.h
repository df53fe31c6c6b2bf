#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// One corner of a mesh as the GPU reads it. Normals and tangents of those that refine() made are the means of their
/// parents', and not unit.
struct Vertex {
  glm::vec3 position{0.0f};                              ///< object space
  glm::vec3 normal{0.0f, 0.0f, 1.0f};                    ///< unit
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};             ///< unit p_u, and the sign of the bitangent: b = w · n × t
  glm::vec2 uv[2] = {glm::vec2(0.0f), glm::vec2(0.0f)};  ///< glTF's: (0, 0) is the top left of a texture
  glm::vec4 color{1.0f};                                 ///< linear; multiplies the base colour
};

/// Triangles with one material. Counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, each below vertices.size()
  int material = 0;                    ///< index into Scene::materials
  /// For each of Scene::variants the material that it gives the mesh; empty: none gives it another.
  std::vector<int> material_of_variant = {};
  /// The vertices from this one on are of a relief: a model is as large, and framed, as without. 0: none is.
  std::size_t first_of_relief = 0;
};

/// Whether not all vertices are at the same place of a texture, as they are where a file says nothing of it.
bool hasTextureCoordinates(const Mesh& mesh);

/// Sets smooth normals: the mean of the triangles' normals at each vertex, weighted by angle (Thürmer & Wüthrich 1998).
void computeNormals(Mesh& mesh);

}  // namespace mirrorball
