#pragma once

#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_pointer.h"

namespace mirrorball::gltf {

/// Which nodes of a file its animations morph.
std::vector<bool> nodesWithAnimatedWeights(const Document& document);

/// Reads a file's animations into the rig of its scene. What they move that is not read is left out, with a warning.
///
/// errors   bad_file (indices out of range; times that do not grow, or that are none; as many values as there must
///          not be; NaN); too_large
Result<void> readAnimations(const File& file, const SceneOfFile& all);

}  // namespace mirrorball::gltf
