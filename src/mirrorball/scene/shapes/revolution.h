#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/scene/mesh.h"

namespace mirrorball {

/// A point of the section through a body that is round about the Y axis.
struct ProfilePoint {
  glm::dvec2 place;   ///< distance from the axis, height
  glm::dvec2 normal;  ///< unit, outwards
};

/// Appends an arc of a profile, from one direction of its normal to another.
///
/// radius      above 0 the body is inside of the arc; below 0 it is outside, as at the bottom of a vessel's inside
/// first_deg   direction of the normal: 0 points away from the axis, 90 upwards
/// steps       at least 1
void addArc(std::vector<ProfilePoint>& profile, glm::dvec2 center, double radius, double first_deg, double last_deg,
            int steps);

/// The surface of a profile turned about the Y axis, closed exactly where the profile begins and ends on the axis.
/// Where two points of the profile share a place, their normals make a sharp edge.
///
/// profile    outside is to the left of its direction where distance grows to the right and height upwards: it goes
///            down an outer wall
/// segments   about the axis, at least 3
/// returns    u grows around the axis, from +Z towards +X, with +Z in the middle; v along the profile by its length
Mesh revolvedMesh(std::span<const ProfilePoint> profile, int segments);

}  // namespace mirrorball
