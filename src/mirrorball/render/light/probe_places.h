#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/box.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// An object that reflects what is around it: an instance, and those that lie in it, as water in its glass.
struct ReflectiveObject {
  glm::vec3 middle{0.0f};      ///< of the box around it; world
  float radius = 0.0f;         ///< of that box
  std::vector<int> instances;  ///< that it is made of: indices into Scene::instances
};

/// Where a scene's probes stand, and who reads them.
struct ProbePlaces {
  std::vector<ReflectiveObject> probes;  ///< each object has the probe in its middle
  std::vector<ReflectiveObject> others;  ///< without one of their own
};

/// Whether a material reflects so that one may tell of what: metal, glass, lacquer, and whatever else is glossy.
bool isReflective(const Material& material);

/// The boxes around the instances.
std::vector<Box> boxesOf(const Scene& scene);

/// Whether a box belongs to what is in another: its middle is in that, and it is no larger.
bool liesIn(const Box& part, const Box& whole);
/// The same, and not the other way round.
bool liesInside(const Box& part, const Box& whole);

/// An instance and those that lie in it.
std::vector<int> withParts(const Scene& scene, int instance);

/// Deals probes out to the largest objects of reflective materials. Flat ones get none: from one place it is not known
/// what the whole of a plane sees.
///
/// most   number of probes at most
ProbePlaces probePlaces(const Scene& scene, int most);

/// The shares of probes in the light of an object without one of its own: as 1 / distance², of the three nearest.
///
/// returns  a share for each probe; their sum is 1
std::vector<float> probeShares(const ReflectiveObject& object, const std::vector<ReflectiveObject>& probes);

}  // namespace mirrorball
