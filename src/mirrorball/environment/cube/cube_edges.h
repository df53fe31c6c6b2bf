#pragma once

#include <array>

#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// How light goes on across the edges of a cube's faces: whether six images that someone takes for a cube are one.
struct EdgeFit {
  static constexpr std::size_t kStretches = 6 * 4 * 8;  ///< an eighth of each edge of each face

  float across = 0.0f;  ///< mean of |a − b| / (a + b) of the texels on both sides of an edge
  float beside = 0.0f;  ///< the same of the texels at an edge and those next to them in their own face
  std::array<float, kStretches> stretches{};  ///< the mean across each stretch

  /// Whether light changes across edges about as it does beside them.
  bool meets() const { return across <= 2.0f * beside + 0.02f; }
  /// Whether it jumps there. Faces of one colour each, as in cubes made to test a program, jump and say nothing.
  bool jumps() const { return beside > 0.005f && across > 4.0f * beside + 0.05f; }
  /// Whether it is unlikely that they are a cube of which nothing but a shape says so: a photograph's edges change more
  /// beside each other than smooth light does.
  bool isUnlikely() const { return beside > 0.005f && !meets(); }
  /// Whether the same images meet clearly better in this way than in another. A few faces that lie otherwise change
  /// only the stretches at their own edges, which the mean of all hides, and noise changes them at random: the gain has
  /// to be seen all along.
  bool isClearlyBetterThan(const EdgeFit& other) const;
};

/// cube         of a projection with six faces
/// arrangement  how they lie if the cube's faces are images by slots; by default they are its faces
/// cost         some thousand texels
EdgeFit edgeFit(const EnvironmentMap& cube, const CubeArrangement& arrangement = {});

}  // namespace mirrorball
