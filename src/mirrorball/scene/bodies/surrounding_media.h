#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "formula/bodies.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A triangle that a ray meets.
struct Crossing {
  float distance;
  std::size_t instance;  ///< index into Scene::instances
  bool is_entering;      ///< it is met from the side that its corners go round counter-clockwise
};

/// Looks for the first triangle along a ray from a distance on.
using FindCrossing = std::function<std::optional<Crossing>(glm::vec3 origin, glm::vec3 direction, float nearest)>;

/// The distance from which on a ray has passed what it met.
inline float justBehind(float distance) { return std::nextafter(distance * (1.0f + 1e-6f), INFINITY); }

/// The bodies that a point lies in, the outermost first: those that at least two of three rays from there leave and
/// have not entered.
formula::Media surroundingMedia(const Scene& scene, glm::vec3 point, const FindCrossing& find);

/// The same by the tree of the scene's bodies.
///
/// cost     three rays through all that they meet
formula::Media surroundingMedia(const Scene& scene, glm::vec3 point, const BodyTree& tree);

/// The index of refraction of what a body's surface is met from: of the body that fills the place around it, or 1.
///
/// instance  of a body (isBody)
/// returns   for each vertex of its mesh, that of the middle of a triangle that it belongs to; empty: all lies in air
/// cost      three rays for each of those triangles, on all cores
std::vector<float> iorAround(const Scene& scene, std::size_t instance, const BodyTree& tree);

}  // namespace mirrorball
