#pragma once

#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/mesh.h"

namespace mirrorball::gltf {

/// Whether a primitive is made of triangles, strips and fans among them.
bool hasTriangles(const Primitive& primitive);

/// Reads one primitive: its attributes and its indices as triangles. Without normals it becomes flat, as glTF demands.
///
/// tangent_uv_set  the texture coordinates along which tangents are computed where the file has none
/// key             "meshes[0].primitives[1]", for messages
/// returns         a mesh whose material is not set yet
/// errors          bad_file; too_large (an accessor of zeros)
Result<Mesh> readPrimitive(const File& file, const Primitive& primitive, int tangent_uv_set, const std::string& key);

}  // namespace mirrorball::gltf
