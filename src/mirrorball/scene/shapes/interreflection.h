#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

// Built-in scenes in which light meets more than one surface before it reaches the eye, which a distant environment
// map knows nothing of. Each has its bounding sphere about the origin with radius 1.

/// Two mirror spheres beside each other.
///
/// gap      between them, in radii of a sphere; at least 0
Scene spheresScene(float gap = 0.25f);

/// A bowl of clay: a part of a hollow ball, open upwards, with a flat rim; one closed surface, so that of glass it is a
/// body. Its occlusion map has two texels, for the inside and for the rest. The inside's is a closed form: seen from
/// inside of a sphere, a part of it fills, weighted by the cosine, the same share of the hemisphere everywhere: that of
/// its area (Jacquez & Kuppenheim 1955). The opening's is kBowlOpenShare.
Scene bowlScene();

/// Of the inner sphere's area; a whole number of steps of 1/255, so that the map holds it exactly.
inline constexpr float kBowlOpenShare = 102.0f / 255.0f;

}  // namespace mirrorball
