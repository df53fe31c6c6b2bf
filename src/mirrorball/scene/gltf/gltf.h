#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a glTF 2.0 file, .gltf or .glb: the default scene, or every node that has no parent where the file names
/// none.
///
/// Read are the core's metallic-roughness materials with all their textures, cameras, and the extensions of
/// docs/gltf.md. Pictures may have any format that codec.h's decodeTexture takes. Points, lines, and what other
/// extensions say are left out, with a warning in the scene.
///
/// returns  one mesh a primitive, and one more for each instance that is bent otherwise, by a skin or by morph targets;
///          an instance whose node mirrors gets a copy of its mesh with turned triangles, so that counter-clockwise is
///          outside everywhere. A file with animations is at rest, with a rig (scene/animation/pose.h)
/// path     its folder is where the paths of buffers and pictures begin (ModelFiles); warnings begin with it
/// errors   io (of a buffer or picture); bad_file (the key is named: a range that its buffer does not have, an index
///          out of range, a missing picture or buffer, NaN, times that do not grow); unsupported (version 1, a required
///          extension, a file that is not to be read); too_large
Result<Scene> decodeGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                         const ModelLoadOptions& options = {});

}  // namespace mirrorball
