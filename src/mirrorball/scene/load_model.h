#pragma once

#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Loads a model: a built-in by its name, else a file by its extension (.glb .gltf .obj .ply .stl).
///
/// returns  a scene whose every index is in range and every number finite: safe to draw
/// errors   not_found (lists the built-ins); bad_file (key or byte named); unsupported; too_large
Result<Scene> loadModel(const std::string& name_or_path);

/// "none", "sphere", "torus", "knot", "teapot", "plane", "cube", "showcase".
std::span<const std::string_view> builtinModelNames();

}  // namespace mirrorball
