#pragma once

#include <map>
#include <span>

#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/mesh_file/obj_geometry.h"

namespace mirrorball {

/// Builds the meshes of an OBJ, one a material: corners that agree share a vertex, polygons become triangles. Corners
/// without a normal, or with one that is NaN or has no length, get one: by the face's smoothing group, else smooth
/// where edges turn by less than 45°. Those go by position, so that a seam of the texture coordinates does not show.
///
/// geometry   gets the normals that are made, and counts what is repaired
/// materials  for each of geometry.material_names the key of its mesh
/// origin     the place in the file's coordinates that is (0, 0, 0) in the meshes (scene/model_origin.h)
/// returns    the meshes by that key, with tangents; −1: of faces without a material
std::map<int, Mesh> buildObjMeshes(ObjGeometry& geometry, std::span<const int> materials, glm::dvec3 origin);

}  // namespace mirrorball
