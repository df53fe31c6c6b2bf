#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace mirrorball {

/// The convex outline of directions around a middle, in the plane where each is as far from the middle as on the sphere
/// (azimuthal equidistant). What is less than a hundredth of its reach within it has no corner of its own.
///
/// middle   unit
/// points   unit
/// returns  its corners, at most 128, counter-clockwise about the middle (as seen from outside)
/// cost     15 ns a point
std::vector<glm::vec3> outlineAround(glm::vec3 middle, std::span<const glm::vec3> points);

}  // namespace mirrorball
