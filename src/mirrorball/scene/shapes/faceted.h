#pragma once

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

// Closed bodies with flat polished faces. Each has its bounding sphere about the origin with radius 1. On each face u
// grows to the right and v downwards, as seen from outside, over the square around it.

/// The standard round brilliant, its table upwards: 33 facets of the crown, 24 of the pavilion that meet in a point (no
/// culet), and a girdle of 16 flat sides. Facets are plane by construction.
///
/// from     M. Tolkowsky, "Diamond Design", London 1919: table 53 % of the girdle's diameter, crown angle 34.5°,
///          pavilion angle 40.75°. What he leaves open: star facets reach half of the way from the table to the girdle
///          and lower halves 0.77 of that to the culet, both within the range of today's best grades (GIA: 45 to 65 %,
///          70 to 85 %); the girdle is 2 % of the diameter high
Mesh brilliantMesh();

/// An equilateral dispersing prism: it lies on one of its sides, an edge upwards, along the Z axis, half as long again
/// as its sides are wide.
Mesh prismMesh();

}  // namespace mirrorball
