#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/scene/proxy/proxy.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// Light of the environment along a ray.
struct SeenLight {
  glm::vec3 radiance{0.0f};
  float pdf = 0.0f;  ///< density with which Surroundings::sample returns directions around the ray's [1/sr]
};

/// The environment as places of a scene see it: turned, scaled, and near where it has a proxy.
class Surroundings {
 public:
  /// environment, lights   of each other; they must outlive this
  Surroundings(const Environment& environment, const LightSampler& lights, Proxy proxy, const TraceSettings& settings);

  /// The light along a ray.
  ///
  /// direction  world, unit
  glm::vec3 radiance(glm::vec3 origin, glm::vec3 direction) const;

  /// A direction that the light chooses, seen from a place.
  ///
  /// u        two uniform numbers
  /// returns  in the world's axes; with a density of 0 where none is seen from there. Of a mesh, what is hidden from
  ///          the capture is never chosen
  LightSample sample(glm::vec3 origin, glm::vec2 u) const;

  /// The light along a ray, and how likely `sample` was to choose it.
  ///
  /// direction  world, unit
  SeenLight seen(glm::vec3 origin, glm::vec3 direction) const;

  /// Where on its line a ray of the eye begins: there, or nearest to the capture if that is outside of the proxy.
  glm::vec3 originOfEye(glm::vec3 origin, glm::vec3 direction) const;

  /// The distance along a ray at which it meets the ground; nothing: it does not.
  std::optional<float> distanceToGround(glm::vec3 origin, glm::vec3 direction) const;

  /// The share of the arriving light that the ground sends back, of which so much is to be seen in the panorama: at
  /// most all of it (shadowedGround).
  glm::vec3 albedoOfGround(glm::vec3 seen) const;

  /// Perceptual; 1: it is matt and mirrors nothing.
  float groundRoughness() const { return proxy_.ground_roughness; }

  // The same of an environment that is infinitely far away, which is what lights the ground.
  glm::vec3 radianceFarAway(glm::vec3 direction) const;
  LightSample sampleFarAway(glm::vec2 u) const;
  float pdfFarAway(glm::vec3 direction) const;

 private:
  float pdfOf(const formula::ProxyHit& here, const formula::ProxySight& sight) const;
  bool isSame(const formula::ProxyHit& here, const formula::ProxyHit& there) const;

  const Environment& environment_;
  const LightSampler& lights_;
  Proxy proxy_;
  glm::mat3 environment_from_world_;
  float intensity_;
  glm::vec3 ground_irradiance_{0.0f};  // divided by π
};

}  // namespace mirrorball
