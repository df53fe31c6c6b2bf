#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/relief_prisms.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/scene/unit_vector.h"

namespace mirrorball {

/// Of instances with relief, what stands in the place of their triangles.
using PrismsOfInstances = std::map<std::size_t, std::unique_ptr<ReliefPrisms>>;

/// What rays meet of a scene, sorted for them.
class RayTree {
 public:
  virtual ~RayTree() = default;
  RayTree(const RayTree&) = delete;
  RayTree& operator=(const RayTree&) = delete;

  /// Geometry::hit of a ray that is finite and begins at most 10¹⁸ away.
  virtual std::optional<Hit> hit(glm::vec3 origin, glm::vec3 direction, float nearest) const = 0;

 protected:
  RayTree() = default;
};

/// The unit normal of a triangle that a ray has met. The square of what lies across a triangle of 10⁻¹⁰ is below the
/// least float, and of a smaller one that itself: it then faces the ray.
///
/// across      the cross product of two edges, or what is left of it
/// direction   unit
inline glm::vec3 normalOfMet(glm::vec3 across, glm::vec3 direction) { return directionOr(across, -direction); }

/// Embree's (Wald et al. 2014).
///
/// prisms   must outlive it
/// errors   too_large; unsupported (Embree does not run here, or is not in this build)
Result<std::unique_ptr<RayTree>> embreeTree(const Scene& scene, const PrismsOfInstances& prisms);

/// Our own: that tree of boxes which the shaders read (scene/bodies/box_tree.h), and for triangles a test through which
/// no ray slips between two that share an edge (Woop, Benthin & Wald 2013, "Watertight ray/triangle intersection").
///
/// prisms   must outlive it
Result<std::unique_ptr<RayTree>> ownTree(const Scene& scene, const PrismsOfInstances& prisms);

}  // namespace mirrorball
