#pragma once

#include <vector>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Takes textures out of a scene whose pictures are missing or cannot be read: its materials are as if they had never
/// named them. What would glow where a lost picture says glows nowhere, since all of it would be more than its author
/// ever saw.
///
/// is_lost  of each of the scene's textures
void leaveOutTextures(Scene& scene, const std::vector<bool>& is_lost);

}  // namespace mirrorball
