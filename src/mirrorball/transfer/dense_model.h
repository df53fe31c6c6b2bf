#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/rays/geometry.h"
#include "mirrorball/rays/sample_sequence.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A place of a dense model that belongs to one of a light model; world.
struct DensePlace {
  float height = 0.0f;  ///< how far it lies outside the light model
  glm::vec3 position{0.0f};
  glm::vec3 geometric_normal{0.0f};
  glm::vec3 normal{0.0f};  ///< of the smooth surface with its normal map, unit
};

/// What of an even sky is seen from there.
struct VisibleSky {
  float share = 1.0f;         ///< weighted by the cosine to the normal
  glm::vec3 direction{0.0f};  ///< the mean of where it is seen, unit; the normal where it is not
};

/// The model that has the detail, ready for rays.
class DenseModel {
 public:
  /// scene    must outlive it
  /// radius   of the light model [world units], by which reaches are measured
  /// errors   as Geometry's
  static Result<DenseModel> make(const Scene& scene, float radius);

  /// The place that belongs to one of the light model, among those that face the same way.
  ///
  /// outwards  unit
  /// cage      0: the nearest along the line through `origin`, up to a twentieth of the radius away. Else the outermost
  ///           between so far outside and so far inside [world units]
  std::optional<DensePlace> placeAlong(glm::vec3 origin, glm::vec3 outwards, float cage) const;

  /// samples  of the place
  /// rays     at least 1
  VisibleSky skyAt(const DensePlace& place, SampleSequence samples, int rays) const;

 private:
  DenseModel(const Scene& scene, Geometry geometry, float radius);
  std::optional<DensePlace> firstFacing(glm::vec3 origin, glm::vec3 outwards, float start, float way,
                                        float reach) const;

  const Scene* scene_;
  Geometry geometry_;
  std::vector<glm::mat3> world_from_normal_;
  float radius_;
};

}  // namespace mirrorball
