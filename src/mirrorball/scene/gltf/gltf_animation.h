#pragma once

#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_pointer.h"

namespace mirrorball::gltf {

/// Which nodes of a file its animations morph.
std::vector<bool> nodesWithAnimatedWeights(const Document& document);

/// Reads a file's animations into the rig of its scene. What they move that is not read is left out, with a remark, and
/// so are channels that are damaged (indices out of range; not as many values as there must be; NaN), and keys whose
/// times do not grow.
///
/// errors   too_large
Result<void> readAnimations(const File& file, const SceneOfFile& all);

}  // namespace mirrorball::gltf
