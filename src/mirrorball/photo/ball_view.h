#pragma once

#include <optional>
#include <vector>

#include "mirrorball/photo/pinhole.h"

namespace mirrorball {

/// Where a direction is seen on a mirror ball.
struct SeenAt {
  glm::dvec2 position_px{0.0};
  double facing = 0.0;  ///< cosine between the ball's normal and the way to the camera: 1 in the middle, 0 on the rim
  double from_rim_px = 0.0;  ///< distance inside the rim
};

/// A mirror ball in front of a camera: which distant light is seen where. The ball is so small that all light comes
/// from infinitely far away.
///
/// Directions are the camera's: +X to the right, +Y up, +Z from the scene to the camera,
/// as in all maps of this program.
class BallView {
 public:
  /// rim  the ball's outline in the pinhole camera's plane
  BallView(const Pinhole& pinhole, const Circle& rim);

  const Pinhole& pinhole() const { return pinhole_; }
  const Circle& rim() const { return rim_; }

  /// From the camera to the ball's centre, in radii of the ball; infinite for parallel rays.
  double distance() const { return 1.0 / sine_of_rim_; }

  /// Unit, from the camera to the ball's centre.
  glm::dvec3 axis() const { return axis_; }

  /// Half the angle of the cone around axis() that the ball hides: nothing in it is seen.
  double blindHalfAngle_rad() const { return std::asin(sine_of_rim_); }

  /// Where the light that comes from `direction` (unit) is seen; nothing inside the blind cone.
  std::optional<SeenAt> seenAt(glm::dvec3 direction) const;

  /// The direction from which the light comes that is seen at a position; nothing outside the ball.
  std::optional<glm::dvec3> directionAt(glm::dvec2 position_px) const;

  /// How far inside the rim a position lies; negative outside the ball.
  double fromRim_px(glm::dvec2 position_px) const;

  /// The angle from axis() within which nothing is seen from more than `margin_px` inside the rim.
  double unseenHalfAngle_rad(double margin_px) const;

  /// `count` positions on the rim, in its order.
  std::vector<glm::dvec2> outline(int count) const;

 private:
  /// The axes of mirror_ball.glsl, where the camera is on +Z; the roll does not matter, since the ball is round.
  glm::dmat3 worldFromBall() const;

  Pinhole pinhole_;
  Circle rim_;
  glm::dvec3 axis_{0.0, 0.0, -1.0};
  double sine_of_rim_ = 0.0;  // 1 / distance
};

}  // namespace mirrorball
