#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/cube/cube_edges.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The arrangements in which six images may lie that do not say it, in the order in which they are tried: that by which
/// they are expected, then those of the sides that programs have, upright, by OpenGL's table or, if they are not
/// expected by that, as an eye sees them (docs/conventions.md), each with the images of ±Y turned by every number of
/// quarters.
///
/// is_numbered  whether names only count them: then also in the order front, right, back, left, up, down
std::vector<CubeArrangement> possibleArrangements(const CubeArrangement& expected, bool is_numbered = false);

/// How six images lie, as far as their edges tell.
struct FaceReading {
  CubeArrangement arrangement;
  EdgeFit fit;  ///< of the images so arranged
  /// Whether their edges alone show that they are a cube: they go on into each other, and do not in every arrangement,
  /// as images with black borders would.
  bool is_proved = false;
};

/// The first of some arrangements, or a later one in which the images meet, and clearly better.
///
/// images         six, as the faces of a cube by slots
/// arrangements   at least one
/// cost           some thousand texels for each
FaceReading readByEdges(const EnvironmentMap& images, std::span<const CubeArrangement> arrangements);

/// The arrangement in which the same images are the mirrored world, where that is another that programs have: by
/// OpenGL's table right-handed worlds have mirrored images, and pictures as an eye sees them have the same neighbours.
/// Edges cannot tell the one from the other.
///
/// returns  nothing where no program has it
std::optional<CubeArrangement> mirrorReading(const CubeArrangement& arrangement);

/// The words by which `formHintNamed` reads six files so arranged: "faces", "faces:for=krpano", "faces:as-seen".
std::string hintForFaces(const CubeArrangement& arrangement);

}  // namespace mirrorball
