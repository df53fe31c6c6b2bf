#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Loads a model: a built-in by its name, else a file by its first bytes (binary glTF, PLY), whatever it is called, or
/// by its extension (modelExtensions).
///
/// options  with an animation, the scene is as that shows it (scene/animation/pose.h)
/// returns  a scene whose every index is in range and every number finite: safe to draw
/// errors   not_found (lists the built-ins); bad_file (key or byte named); unsupported (of a folder it names the models
///          in it); too_large; usage (the model has no such animation)
Result<Scene> loadModel(const std::string& name_or_path, const ModelLoadOptions& options = {});

/// A model as loadModel has it without an animation, as it is with one.
///
/// errors   usage (it has no such animation); bad_file (it reaches too far); as posed's
Result<Scene> atMoment(Scene scene, const AnimationChoice& choice);

/// Refuses what lies or reaches so far away that shaders cannot tell distances, as loadModel does.
///
/// errors   bad_file
Result<void> checkExtent(const Scene& scene);

/// The name of a file's format, if loadModel would take it: "a glTF", "an OBJ". Nothing if it would not, or there is no
/// such file.
std::optional<std::string_view> modelFormatOf(const std::string& path);

/// Whether the bytes begin as a model that loadModel takes whatever its name is.
bool isModel(std::span<const std::uint8_t> begin);

/// The extensions of the files that are read: ".glb .gltf .obj .ply .stl".
std::string modelExtensions();

/// "none", "sphere", "torus", "knot", "teapot", "plane", "cube", "brilliant", "prism", "tumbler", "tumbler-water",
/// "spheres", "bowl", "showcase".
std::span<const std::string_view> builtinModelNames();

}  // namespace mirrorball
