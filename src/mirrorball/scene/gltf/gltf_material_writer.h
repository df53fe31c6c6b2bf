#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/glb_builder.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::gltf {

/// Writes all materials of a scene with their textures, samplers and pictures; material i of the scene is material i of
/// the file.
///
/// left_out  gets a line for each material that glTF cannot hold whole
/// errors    as encodePicture's, of a PNG
Result<void> writeMaterials(const Scene& scene, GlbBuilder& file, std::vector<std::string>& left_out);

}  // namespace mirrorball::gltf
