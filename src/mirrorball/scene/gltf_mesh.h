#pragma once

#include <cstddef>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf_file.h"
#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// Whether a primitive is made of triangles, strips and fans among them.
bool hasTriangles(const tinygltf::Primitive& primitive);

/// Reads one primitive: its attributes and its indices as triangles. Without normals it becomes flat, as glTF demands.
///
/// normal_uv_set  the texture coordinates along which tangents are computed where the file has none
/// most_vertices  how many vertices it may have at most
/// key            "meshes[0].primitives[1]", for messages
/// returns        a mesh whose material is not set yet
/// errors         bad_file; too_large
Result<Mesh> readPrimitive(const GltfFile& file, const tinygltf::Primitive& primitive, int normal_uv_set,
                           std::size_t most_vertices, const std::string& key);

}  // namespace mirrorball
