#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Decodes a surface from a Polygon File Format (Stanford) file: ascii or binary of either byte order, properties of
/// any type and order, faces with any number of corners, triangle strips. Pictures that comments name as MeshLab does
/// (`TextureFile`) are its base colours.
///
/// path     its folder is where the pictures' names begin (ModelFiles); warnings begin with it
/// returns  normals, texture coordinates (v turned to grow downwards) and colours where the file has them, of vertices
///          or of faces (ply_content.h). Normals where it has none: edges are smooth under 45°, as in OBJ. What is left
///          out is a warning in the scene
/// errors   bad_file (the line or byte is named); unsupported (points without faces, Gaussian splats); too_large
Result<Scene> decodePly(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                        const ModelLoadOptions& options = {});

}  // namespace mirrorball
