#pragma once

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Well mixed bits of two numbers (Jarzynski & Olano 2020, "Hash functions for GPU rendering", PCG).
std::uint32_t mixed(std::uint32_t a, std::uint32_t b);

/// Two numbers in [0, 1) of 16 bits each.
glm::vec2 sharesOf(std::uint32_t bits);

/// What a smooth normal sees below its flat triangle, light cannot reach from there: that direction above it.
inline glm::vec3 raisedAbove(glm::vec3 geometric_normal, glm::vec3 direction) {
  return direction - 2.0f * glm::min(glm::dot(direction, geometric_normal), 0.0f) * geometric_normal;
}

/// Whether a ray passes the back of a surface that has only a front, as the eye does: glTF's rule. Bodies have both.
///
/// direction  of the ray
bool isCulled(const Material& material, const Hit& hit, glm::vec3 direction);

/// The first surface along a ray that hides what is behind it: by its opacity, and less by what it transmits.
///
/// direction  unit
/// random     decides whether one that hides a part does
std::optional<Hit> hidingHit(const Scene& scene, const Geometry& geometry, glm::vec3 origin, glm::vec3 direction,
                             std::uint32_t random);

}  // namespace mirrorball
