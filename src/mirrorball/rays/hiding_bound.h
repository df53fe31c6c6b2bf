#pragma once

#include <cstdint>
#include <span>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether no place of a scene can see less than nine tenths of an even sky: a bound that no contact escapes which
/// rises more than a millionth of the scene's size. If false, nothing is known.
///
/// A triangle and all that lies in front of it are compared, by a tree of boxes. What reaches less than an angle above
/// its plane hides no more than what is below that angle; and what is above it no more than the disc that a ball around
/// it covers of the sky. What lets a part of the light through counts as if it let none, what lets all of it through
/// not at all.
///
/// shows_back   of each instance, not 0: places on the back of its triangles count too
/// cost         1 µs a triangle for the tree, and some µs for each triangle on one core; it ends at the first triangle
///              from which more may be hidden
bool hidesLittleSurely(const Scene& scene, std::span<const std::uint8_t> shows_back);

}  // namespace mirrorball
