#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <tiny_obj_loader.h>

#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Turns the materials of a .mtl into those of a scene, in their order, and loads their pictures. What cannot be read
/// becomes a warning.
void addObjMaterials(std::span<const tinyobj::material_t> materials, ModelFiles& named, Scene& scene);

/// A file that an OBJ or a .mtl names, also as programs on Windows write it.
///
/// errors   as ModelFiles::find's and its read's: "'a.mtl' is missing; put it beside the model"
Result<std::span<const std::uint8_t>> readNamed(ModelFiles& named, const std::string& name);

}  // namespace mirrorball
