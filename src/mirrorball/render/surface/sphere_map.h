#pragma once

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// The sphere map that a camera in a given orientation would photograph, as a texture: row 0 is t = 0, and the texels
/// beside the disc continue its rim, so that filtering finds nothing black there.
///
/// environment_from_view  turns a direction of view space into one of the environment
Image sphereMapTexture(const Environment& environment, const glm::mat3& environment_from_view, int size);

}  // namespace mirrorball
