#pragma once

#include <span>

#include "mirrorball/base/json_reader.h"
#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball::gltf {

/// glTF's default material (section 3.9.6): white, and the factors' defaults.
Material defaultMaterial();

/// What KHR_materials_unlit leaves of a material: its base colour and what its alpha covers. The rest is as other
/// programs should show it that do not know the extension.
Material unlitOf(const Material& material);

/// A material of a file, its numbers cut to their ranges; its slots hold indices into the file's textures and its sets
/// of texture coordinates, which are not checked.
FileMaterial parseMaterial(const JsonReader& json);

/// Says of which colours the count of numbers is wrong.
void tellOfMiscounted(std::span<const FileMaterial> materials, Remarks& remarks);

}  // namespace mirrorball::gltf
