#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a glTF 2.0 file, .gltf or .glb: the default scene, the first where the file names none, or every node that
/// has no parent where it has no scenes.
///
/// Read are the core's metallic-roughness materials with all their textures, cameras, and the extensions of
/// docs/gltf.md. Pictures may have any format that codec/image_file.h's decodeColorTexture takes. Points, lines, and
/// what other extensions say are left out, with a warning in the scene. So is whatever is damaged or missing
/// (docs/files.md): a picture, a primitive, a skin, a channel of an animation, a triangle.
///
/// returns  one mesh a primitive, and one more for each instance that is bent otherwise, by a skin or by morph targets;
///          an instance whose node mirrors gets a copy of its mesh with turned triangles, so that counter-clockwise is
///          outside everywhere. A file with animations is at rest, with a rig (scene/animation/pose.h)
/// path     its folder is where the paths of buffers and pictures begin (ModelFiles); warnings begin with it
/// errors   where no triangle is left, the first damage: io (of a buffer); bad_file (the key is named: a range that its
///          buffer does not have, an index out of range, a missing buffer, NaN); unsupported (a required extension, a
///          file that is not to be read). Else bad_file (no JSON); unsupported (version 1); too_large
Result<Scene> decodeGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                         const ModelLoadOptions& options = {});

}  // namespace mirrorball
