#pragma once

#include <glm/glm.hpp>

#include "mirrorball/environment/environment.h"

namespace mirrorball {

/// How many points of a target's texel to look up in the source, across and down.
struct PointsPerTexel {
  /// No farther apart than the source's texels; 1 where a texel spans at most √2 of them: there one interpolated value
  /// at its centre says it.
  glm::ivec2 smooth;
  /// Beside a sun: six in each of the source's texels, at most 48. The sum over points at a distance h of the weights
  /// of one texel, as bilinear interpolation gives them, is off by 2 sinc²(1 / h) at most (Poisson's sum formula): by
  /// 9 % for h = 0.7, by less than 0.5 % here.
  glm::ivec2 sharp;
  /// So many texels span at most 1.5 of the source's, or 1.
  glm::ivec2 stride;
};

/// By the Jacobian of the map from the target to the source, at the centre and the corners of a rectangle of texels.
///
/// extent   the target's images, in texels
PointsPerTexel pointsPerTexel(const Environment& source, Projection to, glm::ivec2 extent, int face, glm::ivec2 begin,
                              glm::ivec2 end, const glm::mat3& source_from_target);

}  // namespace mirrorball
