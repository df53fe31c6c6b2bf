#pragma once

#include <glm/glm.hpp>

#include "mirrorball/environment/projection.h"
#include "mirrorball/image/filter.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Light from every direction, held in images: one, or a cube's six faces in the order +X −X +Y −Y +Z −Z.
class EnvironmentMap {
 public:
  EnvironmentMap() = default;
  /// images   one level; faceCount(projection) images of one size that fits the projection
  EnvironmentMap(Projection projection, ImageSet images);

  Projection projection() const { return projection_; }
  const Image& face(int index) const { return images_.at(0, index); }
  Image& face(int index) { return images_.at(0, index); }
  int faces() const { return images_.faces(); }

  /// A face's side, a disc's diameter, a panorama's height.
  int size() const { return face(0).height(); }

  /// The radiance that arrives from `direction` (unit), interpolated across every seam, pole and cube edge; nothing
  /// from beside a disc is mixed in.
  glm::vec3 radiance(glm::vec3 direction, Interpolation interpolation = Interpolation::bilinear) const;

 private:
  glm::vec4 fetchEquirect(int x, int y) const;
  glm::vec4 fetchDisc(int x, int y) const;
  glm::vec4 fetchCube(int face, int x, int y) const;
  glm::vec3 radianceOfDisc(glm::vec2 position, Interpolation interpolation) const;

  Projection projection_ = Projection::equirect;
  ImageSet images_;
};

}  // namespace mirrorball
