#pragma once

#include <cstddef>
#include <string>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// What repairMesh() changed; the sum over the meshes of a file is what a remark says.
struct MeshRepair {
  std::size_t triangles_of_no_vertex = 0;  ///< left out: they name a vertex that is not there
  std::size_t triangles_of_no_place = 0;   ///< left out: a corner's position is NaN or infinite
  std::size_t faces_fanned = 0;            ///< of many corners that bend inwards, which were cut about one of them
  std::size_t normals_made = 0;            ///< of vertices, whose normals had no direction
  std::size_t coordinates_zeroed = 0;      ///< of vertices, whose texture coordinates were NaN or infinite
  std::size_t colors_whitened = 0;         ///< of vertices, whose colours were

  std::size_t trianglesLeftOut() const { return triangles_of_no_vertex + triangles_of_no_place; }
  MeshRepair& operator+=(const MeshRepair& other);
};

/// Makes a mesh fit to be drawn whatever numbers its file holds, and changes nothing of one that is.
///
/// - Triangles with a corner that is not there, or is nowhere (NaN, infinity), are left out, and so is an incomplete
///   one at the end of the indices.
/// - A vertex whose normal is NaN, infinite or of length 0 gets the mean of the normals of its triangles, weighted by
///   angle (computeNormals); (0, 0, 1) where none of them has an area. All others keep their own.
/// - Texture coordinates of NaN or infinity become 0, colours white.
///
/// Vertices stay where they are in the list. Those that are nowhere get a place of the mesh's, so that they enlarge no
/// box. Tangents are not looked at: they are to be computed afterwards.
///
/// cost     O(n)
MeshRepair repairMesh(Mesh& mesh);

/// What to tell of repairs: "2 triangles reach NaN or infinity and are left out; 3 normals have no direction and are
/// made from the triangles around". Empty: there were none.
std::string remarkOn(const MeshRepair& repair);

}  // namespace mirrorball
