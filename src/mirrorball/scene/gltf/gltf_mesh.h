#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_deformation.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_vertex_color.h"
#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/mesh_repair.h"

namespace mirrorball::gltf {

/// Whether a primitive is made of triangles, strips and fans among them.
bool hasTriangles(const Primitive& primitive);

/// What a primitive becomes.
struct PrimitiveMesh {
  Mesh mesh;                                                ///< whose material is not set yet
  std::shared_ptr<const MeshDeformation> deformation = {};  ///< none: nothing bends it
  MeshRepair repair = {};                                   ///< of what no picture can be made of
  std::size_t tangents_made = 0;                            ///< of vertices, whose tangents had no direction
  ColorOddity colors = ColorOddity::none;                   ///< how those of vertices are read
  std::vector<Damage> damage = {};                          ///< what is left out besides
};

/// Reads one primitive: its attributes and its indices as triangles. Without normals it becomes flat, as glTF demands.
/// What it can do without, as all but the positions, is left out where it is damaged.
///
/// tangent_uv_set  the texture coordinates along which tangents are computed where the file has none
/// wanted          what may bend it
/// key             "meshes[0].primitives[1]", for messages
/// errors          bad_file; unsupported (its positions are in an extension); too_large (an accessor of zeros)
Result<PrimitiveMesh> readPrimitive(const File& file, const Primitive& primitive, int tangent_uv_set,
                                    WantedDeformation wanted, const std::string& key);

}  // namespace mirrorball::gltf
