#pragma once

#include <functional>

#include <glm/glm.hpp>

#include "mirrorball/rays/ray.h"
#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/trace/carried_light.h"
#include "mirrorball/trace/surroundings.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// How a path goes on from the ground of the environment. The panorama shows the ground as it is without the scene, and
/// the path has found that. What the scene changes is added: the light that it hides, below 0, and its own
/// ("differential rendering": Debevec 1998, "Rendering synthetic objects into real scenes").
class PathOnGround {
 public:
  /// The share of the light from far away along a ray that gets to its origin.
  using ShareThatArrives = std::function<glm::vec3(const Ray&)>;

  /// surroundings, samples   must outlive this
  PathOnGround(const Surroundings& surroundings, LightStrategy strategy, SampleSequence& samples)
      : surroundings_(surroundings), strategy_(strategy), samples_(samples) {}

  /// Chooses how the path leaves the ground: scattered by what is matt, or mirrored where it is polished.
  ///
  /// ray            meets the ground at that distance
  /// photographed   the light that the panorama shows along it
  /// light          loses what the scene hides; carries the share of the next ray
  /// returns        the next ray
  Ray scatter(const Ray& ray, float distance, glm::vec3 photographed, const ShareThatArrives& arrives,
              CarriedLight& light);

  /// Asked of each ray once it is known what it meets. Where it has left the ground, `light` loses what is shown in the
  /// panorama in place of the surface that it meets.
  ///
  /// returns  whether the path goes on: not from the ground into the environment, which counts already
  bool goesOn(const Ray& ray, bool meets_surface, const ShareThatArrives& arrives, CarriedLight& light);

 private:
  Ray scatterMatt(Ray next, glm::vec3 photographed, const ShareThatArrives& arrives, CarriedLight& light);
  Ray mirror(const Ray& ray, Ray next, CarriedLight& light);
  glm::vec3 hidden(Ray next, bool is_alone, const ShareThatArrives& arrives);

  const Surroundings& surroundings_;
  LightStrategy strategy_;
  SampleSequence& samples_;
  enum class Left { no, scattered, mirrored } left_ = Left::no;  // how the path's ray has left the ground
  // Where it was mirrored:
  Ray mirrored_;
  glm::vec3 photographed_{0.0f};  // there
};

}  // namespace mirrorball
