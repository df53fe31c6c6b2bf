#pragma once

#include <span>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/animation/rig.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {

/// Reads a skin.
///
/// place_of_node  of each node of the file, its place among those of the scene's rig; −1: the scene does not show it
/// returns        without joints where one of them is not in the scene
/// errors         bad_file (joints out of range, too few matrices or of another type, NaN); too_large
Result<Skin> readSkin(const File& file, int skin, std::span<const int> place_of_node);

}  // namespace mirrorball::gltf
