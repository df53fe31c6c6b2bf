#pragma once

#include <optional>
#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/scene.h"

// Buildings in the grid of their country and scans in metres from the equator lie a million of their sizes away from
// the origin of their files. Floats there are as far apart as their details, and a camera's matrix rounds once more.
// So such a model is drawn about its own middle: what is read is moved there in double precision, before floats are
// made of it, and Scene::origin says where in the file that is. A model that is not far away stays as it is, bit by
// bit.

namespace mirrorball {

/// Where in the file's coordinates the origin of a model with that box should be: 0 for one that is not far from it,
/// else near its middle, with no more digits than tell it from its neighbours.
glm::dvec3 originFor(const DoubleBox& box);
/// As above, for a model of such vertices; NaN and infinite ones do not count.
glm::dvec3 originFor(std::span<const glm::dvec3> vertices);

/// Says where the origin of a scene is whose vertices a reader has moved there.
///
/// are_floats   the file has them in 32 bits each
void setOrigin(Scene& scene, glm::dvec3 origin, bool are_floats);

/// Moves the origin of a scene elsewhere, and what it shows the other way: instances, cameras, lights, and the rig.
///
/// origin   in the file's coordinates
/// errors   as poseAtRest's (scene/animation/pose.h)
Result<void> moveOrigin(Scene& scene, glm::dvec3 origin);

/// Gives a scene that its rig has placed the origin that it should have, and meshes that lie far from their nodes, too.
/// Nodes are multiplied in double precision before. Of what is bent, the vertices are moved before they are.
///
/// errors   as moveOrigin's; too_large
/// cost     a pass over all vertices; some more for a model far away
Result<void> drawAboutMiddle(Scene& scene);

/// What is to be said of a scene far from its file's origin, or of its vertices; nothing for others.
std::optional<std::string> remarkOnOrigin(const Scene& scene);

}  // namespace mirrorball
