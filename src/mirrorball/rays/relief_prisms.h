#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "formula/relief.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/relief/height_texture.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Whether rays meet a material's relief from below, too.
bool hasBack(const Material& material);

/// Heights that rays meet from both sides.
struct TwoSidedHeights {
  const HeightTexture& heights;              ///< must outlive this
  std::optional<HeightTexture> depths = {};  ///< 1 − heights: the same surface from below

  explicit TwoSidedHeights(const HeightTexture& from_above) : heights(from_above) {}

  /// Makes the depths, once.
  ///
  /// errors   too_large
  Result<void> makeDepths();
};

/// A place of a relief.
struct ReliefPlace {
  float distance;              ///< along the ray
  glm::vec2 barycentric;       ///< of the triangle's second and third corner
  glm::vec3 position;          ///< world, on the surface
  glm::vec3 up;                ///< world: from the bottom of the relief to its top there
  glm::vec3 geometric_normal;  ///< world, unit, of the bilinear patch, outwards
};

/// A box along the world's axes.
struct PrismBounds {
  glm::vec3 low;
  glm::vec3 high;
};

/// The reliefs below the triangles of an instance, in the world, where rays meet them exactly: on the bilinear surface
/// of the heights (relief_surface.h).
class ReliefPrisms {
 public:
  /// instance   an index into Scene::instances; its material has a height texture
  /// heights    must outlive it; with depths where the material has a back
  ReliefPrisms(const Scene& scene, std::size_t instance, const TwoSidedHeights& heights);

  std::size_t size() const { return prisms_.size(); }

  PrismBounds boundsOf(std::size_t triangle) const;

  /// The first place that a ray meets: from above and, where the material is double-sided or transmits, from below.
  ///
  /// direction   unit
  /// nearest     above 0, what is as near as rounding to it is what the ray has just passed, and does not count
  /// from        formula/relief/relief_prism.glsl
  std::optional<ReliefPlace> hit(std::size_t triangle, glm::vec3 origin, glm::vec3 direction, float nearest,
                                 float farthest) const;

 private:
  struct Placed {
    formula::ReliefPrism from_above;
    formula::PrismBox box;
  };
  std::optional<ReliefPlace> placeOn(bool from_above, const formula::ReliefPrism& prism, glm::vec3 origin,
                                     glm::vec3 direction, glm::vec2 between, float nearest) const;

  const TwoSidedHeights& heights_;
  bool has_back_;
  std::vector<Placed> prisms_;
};

}  // namespace mirrorball
