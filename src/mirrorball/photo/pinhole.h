#pragma once

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace mirrorball {

/// A circle in a picture: pixels from its top left corner, pixel (i, j) having its centre at (i + ½, j + ½).
struct Circle {
  glm::dvec2 center_px{0.0};
  double radius_px = 0.0;
};

/// How a camera without distortion maps rays to the picture: x to the right and y up in the picture, z towards the
/// camera.
///
/// The rim of a sphere is seen along a cone of rays. Where the sphere stands beside the picture's middle, that cone
/// cuts the picture in an ellipse. The stereographic projection makes circles of all circles on the sphere of rays, so
/// rims are found and fitted there: in the "plane", which touches the sphere of rays in the picture's middle and has
/// the picture's scale there. For a camera so far away that its rays are parallel, the plane is the picture itself.
struct Pinhole {
  glm::dvec2 middle_px{0.0};  ///< where the optical axis meets the picture
  double focal_px = 0.0;      ///< focal length; 0: parallel rays

  bool isOrthographic() const { return focal_px == 0.0; }

  /// From the picture to the plane: tan θ/2 = tan θ / (1 + √(1 + tan² θ)).
  glm::dvec2 planeFromPicture(glm::dvec2 position_px) const {
    if (isOrthographic()) return position_px;
    const glm::dvec2 tangent = (position_px - middle_px) / focal_px;
    return middle_px + tangent * (2.0 * focal_px / (1.0 + std::sqrt(1.0 + glm::dot(tangent, tangent))));
  }

  /// From the plane to the picture: tan θ = 2 tan θ/2 / (1 − tan² θ/2). Points 90° off the axis or more are not in any
  /// picture: they are mapped far away.
  glm::dvec2 pictureFromPlane(glm::dvec2 plane_px) const {
    if (isOrthographic()) return plane_px;
    const glm::dvec2 half_tangent = (plane_px - middle_px) / (2.0 * focal_px);
    const double rest = 1.0 - glm::dot(half_tangent, half_tangent);
    return middle_px + half_tangent * (2.0 * focal_px / std::max(rest, 1e-6));
  }

  /// The unit ray from the camera through a position. Not of parallel rays.
  glm::dvec3 rayThrough(glm::dvec2 position_px) const {
    const glm::dvec2 tangent = (position_px - middle_px) / focal_px;
    return glm::normalize(glm::dvec3(tangent.x, -tangent.y, -1.0));
  }

  /// Where a point in front of the camera is seen.
  glm::dvec2 pictureOf(glm::dvec3 point) const {
    return middle_px + glm::dvec2(point.x, -point.y) * (focal_px / -point.z);
  }
};

}  // namespace mirrorball
