#pragma once

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// How light goes on across the edges of a cube's faces: whether six images that someone takes for a cube are one.
struct EdgeFit {
  float across = 0.0f;  ///< mean of |a − b| / (a + b) of the texels on both sides of an edge
  float beside = 0.0f;  ///< the same of the texels at an edge and those next to them in their own face

  /// Whether light changes across edges about as it does beside them.
  bool meets() const { return across <= 2.0f * beside + 0.02f; }
  /// Whether it jumps there. Faces of one colour each, as in cubes made to test a program, jump and say nothing.
  bool jumps() const { return beside > 0.005f && across > 4.0f * beside + 0.05f; }
};

/// cube     of a projection with six faces
/// cost     some thousand texels
EdgeFit edgeFit(const EnvironmentMap& cube);

}  // namespace mirrorball
