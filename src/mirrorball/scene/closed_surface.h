#pragma once

#include <string>
#include <vector>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether a mesh's surface has no border: each edge is there as often in one direction as in the other, so that what
/// enters the body also leaves it. Vertices at one place, to the last digit, count as one.
///
/// returns  true for no triangles; wrong with a probability of 2⁻⁶⁴
/// cost     O(triangles), without memory, on all cores: 0.3 s of the processors' time for ten million triangles
bool isClosed(const Mesh& mesh);

/// Whether a mesh's triangles are those of a ball, to 1e-4 of its radius, none of which reaches into its inside: then
/// no ray from its outside that has left it meets it again, however it is stretched.
///
/// cost     O(triangles)
bool isBall(const Mesh& mesh);

/// Whether a mesh's surface is closed and its triangles face the inside: from outside, its far side alone is seen.
///
/// cost     O(triangles); isClosed's where the volume that they enclose is negative
bool facesInwards(const Mesh& mesh);

/// What to say of transmitting materials whose bodies are not closed (and not thin_walled): one line for each.
///
/// cost     isClosed of each mesh of such a material
std::vector<std::string> openBodies(const Scene& scene);

}  // namespace mirrorball
