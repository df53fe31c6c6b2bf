#include "mirrorball/photo/ball_view.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "formula/projection.h"

namespace mirrorball {
BallView::BallView(const Pinhole& pinhole, const Circle& rim) : pinhole_(pinhole), rim_(rim) {
  if (pinhole.isOrthographic()) return;
  // The rim's nearest and farthest points from the picture's middle give the cone's axis and half-angle.
  const glm::dvec2 offset = rim.center_px - pinhole.middle_px;
  const double length = glm::length(offset);
  const double near_rad = 2.0 * std::atan((length - rim.radius_px) / (2.0 * pinhole.focal_px));
  const double far_rad = 2.0 * std::atan((length + rim.radius_px) / (2.0 * pinhole.focal_px));
  const double tilt = (near_rad + far_rad) / 2.0;
  const glm::dvec2 outwards = length > 0.0 ? offset / length : glm::dvec2(1.0, 0.0);
  axis_ = {std::sin(tilt) * outwards.x, -std::sin(tilt) * outwards.y, -std::cos(tilt)};
  sine_of_rim_ = std::sin((far_rad - near_rad) / 2.0);
}

double BallView::fromRim_px(glm::dvec2 position_px) const {
  return rim_.radius_px - glm::distance(pinhole_.planeFromPicture(position_px), rim_.center_px);
}

glm::dmat3 BallView::worldFromBall() const {
  const glm::dvec3 any = std::abs(axis_.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis_, any));
  return {x, glm::cross(x, axis_), -axis_};
}

std::optional<SeenAt> BallView::seenAt(glm::dvec3 direction) const {
  const glm::dmat3 world_from_ball = worldFromBall();
  const auto k = static_cast<float>(sine_of_rim_);
  const glm::vec3 of_ball(glm::transpose(world_from_ball) * direction);
  if (!formula::mirrorBallCovers(of_ball, k)) return {};
  const glm::dvec2 uv(formula::mirrorBallPosition(of_ball, k));
  const glm::dvec2 on_disc(2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y);
  // cos β of mirror_ball.glsl, from the distance from the disc's middle.
  const double inside = std::max(0.0, 1.0 - glm::dot(on_disc, on_disc));
  const double square = sine_of_rim_ * sine_of_rim_;
  const double facing = std::sqrt((1.0 - square) * inside / (1.0 - square * inside));
  const glm::dvec2 position =
      pinhole_.isOrthographic()
          ? rim_.center_px + rim_.radius_px * glm::dvec2(on_disc.x, -on_disc.y)
          : pinhole_.pictureOf(world_from_ball * glm::dvec3(std::tan(blindHalfAngle_rad()) * on_disc, -1.0));
  return SeenAt{position, facing, fromRim_px(position)};
}

std::optional<glm::dvec3> BallView::directionAt(glm::dvec2 position_px) const {
  if (fromRim_px(position_px) < 0.0) return {};
  const glm::dmat3 world_from_ball = worldFromBall();
  glm::dvec2 on_disc = (position_px - rim_.center_px) / rim_.radius_px * glm::dvec2(1.0, -1.0);
  if (!pinhole_.isOrthographic()) {
    const glm::dvec3 ray = glm::transpose(world_from_ball) * pinhole_.rayThrough(position_px);
    on_disc = glm::dvec2(ray) / (-ray.z * std::tan(blindHalfAngle_rad()));
  }
  const glm::vec2 uv((1.0 + on_disc.x) / 2.0, (1.0 - on_disc.y) / 2.0);
  return world_from_ball * glm::dvec3(formula::mirrorBallDirection(uv, static_cast<float>(sine_of_rim_)));
}

double BallView::unseenHalfAngle_rad(double margin_px) const {
  // By bisection on the circle of directions through the axis: what is seen moves inwards as the angle grows.
  const glm::dvec3 sideways = worldFromBall()[0];
  double low = blindHalfAngle_rad();
  double high = glm::pi<double>();
  for (int step = 0; step < 50; ++step) {
    const double middle = (low + high) / 2.0;
    const auto seen = seenAt(std::cos(middle) * axis_ + std::sin(middle) * sideways);
    (seen && seen->from_rim_px > margin_px ? high : low) = middle;
  }
  return high;
}

std::vector<glm::dvec2> BallView::outline(int count) const {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < count; ++i) {
    const double angle = glm::two_pi<double>() * i / count;
    const glm::dvec2 on_circle = rim_.center_px + rim_.radius_px * glm::dvec2(std::cos(angle), std::sin(angle));
    points.push_back(pinhole_.pictureFromPlane(on_circle));
  }
  return points;
}

}  // namespace mirrorball
