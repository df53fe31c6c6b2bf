#pragma once

#include <filesystem>
#include <span>

#include <tiny_obj_loader.h>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Turns the materials of a .mtl into those of a scene, in their order, and loads their pictures from `folder`. What
/// cannot be read becomes a warning.
void addObjMaterials(std::span<const tinyobj::material_t> materials, const std::filesystem::path& folder, Scene& scene);

}  // namespace mirrorball
