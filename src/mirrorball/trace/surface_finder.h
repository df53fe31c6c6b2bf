#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/trace/ray.h"
#include "mirrorball/trace/world.h"

namespace mirrorball {

/// What of a scene rays meet that shows heights in that way.
Surfaces surfacesOf(ReliefKind kind);

/// Finds which surface is there for a ray: not what is cut away or lets it through by chance, the back of a surface
/// that has only a front, or that of a body where another one fills the place.
class SurfaceFinder {
 public:
  /// world, samples   must outlive this
  SurfaceFinder(const World& world, ReliefKind relief, SampleSequence& samples)
      : world_(world), surfaces_(surfacesOf(relief)), samples_(samples) {}

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

  const World& world_;
  Surfaces surfaces_;
  SampleSequence& samples_;
};

}  // namespace mirrorball
