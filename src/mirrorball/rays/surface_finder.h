#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/ray.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What of a scene rays meet that shows heights in that way.
Surfaces surfacesOf(ReliefKind kind);

/// Finds which surface is there for a ray: not what is cut away or lets it through by chance, the back of a surface
/// that has only a front, or that of a body where another one fills the place.
class SurfaceFinder {
 public:
  /// scene, geometry   of each other; they must outlive this
  /// chance            a number in [0, 1), asked for where a surface hides a part of what is behind it: the ray passes
  ///                   if it is at least the opacity
  SurfaceFinder(const Scene& scene, const Geometry& geometry, ReliefKind relief, std::function<float()> chance)
      : scene_(scene), geometry_(geometry), surfaces_(surfacesOf(relief)), chance_(std::move(chance)) {}

  /// The first one, if it is not farther away than that.
  ///
  /// ray                  gets the media that it is in where it has met the surface
  /// meets_bodies_alone   once it has left a surface
  /// share                is dimmed by what bodies absorb on the way; not on a way without an end
  std::optional<Hit> first(Ray& ray, float farthest, bool meets_bodies_alone, glm::vec3& share);

 private:
  bool passes(const Hit& hit, Ray& ray, bool meets_bodies_alone);
  bool isHole(const Hit& hit);
  glm::vec3 transmittance(const formula::Media& media, float distance) const;

  const Scene& scene_;
  const Geometry& geometry_;
  Surfaces surfaces_;
  std::function<float()> chance_;
};

}  // namespace mirrorball
