#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a Wavefront OBJ file with its .mtl: one mesh a material, corners that agree share a vertex, polygons become
/// triangles, v is turned to grow downwards. Colours behind the positions become those of the vertices.
///
/// What is read of a material: obj_material.h. Where the file has no normals, `s N` makes edges smooth within a
/// smoothing group and `s off` all sharp; in a file without any `s`, edges are smooth under 45°.
///
/// path     its folder is where the paths of the .mtl and the pictures begin (ModelFiles); warnings begin with it
/// returns  a .mtl or picture that is missing, damaged or not to be read is a warning in the scene, as are faces and
///          numbers that are left out (obj_geometry.h)
/// errors   bad_file (no face is left); too_large
Result<Scene> decodeObj(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                        const ModelLoadOptions& options = {});

}  // namespace mirrorball
