#pragma once

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// How many points of a target's texel to look up in the source, across and down, so that they lie no farther apart
/// than the source's texels: by the Jacobian of the map from the target to the source, at the centre and the corners
/// of a rectangle of texels.
///
/// extent   the target's images, in texels
/// returns  1 where a texel spans at most √2 texels of the source: there one interpolated value at its centre says it
glm::ivec2 pointsPerTexel(const Environment& source, Projection to, glm::ivec2 extent, int face, glm::ivec2 begin,
                          glm::ivec2 end, const glm::mat3& source_from_target);

}  // namespace mirrorball
