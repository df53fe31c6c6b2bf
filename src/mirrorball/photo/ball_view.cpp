#include "mirrorball/photo/ball_view.h"

#include <algorithm>

#include <glm/gtc/constants.hpp>

namespace mirrorball {
namespace {

/// On a ball seen from `1 / inverse_distance` radii, the light from the angle θ off the way to the camera is reflected
/// where the normal stands α off it. The ray to the camera leaves the ball at β = atan2(sin α, distance − cos α) on the
/// other side, and the normal halves the angle: θ − α = α + β. Solved by Newton's method, which converges from α = θ/2
/// since θ(α) = 2α + β grows and is bent one way only.
double normalAngle(double theta, double inverse_distance) {
  const double k = inverse_distance;
  const double largest = std::acos(k);
  double alpha = std::min(theta / 2.0, largest);
  for (int step = 0; step < 20; ++step) {
    const double c = std::cos(alpha);
    const double beta = std::atan2(k * std::sin(alpha), 1.0 - k * c);
    const double slope = 2.0 + k * (c - k) / (1.0 - 2.0 * k * c + k * k);
    const double change = (theta - 2.0 * alpha - beta) / slope;
    alpha = std::clamp(alpha + change, 0.0, largest);
    if (std::abs(change) < 1e-12) break;
  }
  return alpha;
}

}  // namespace

BallView::BallView(const Lens& lens, const Circle& rim) : lens_(lens), rim_(rim) {
  if (lens.isOrthographic()) return;
  // The rim's nearest and farthest points from the picture's middle give the cone's axis and half-angle.
  const glm::dvec2 offset = rim.center_px - lens.middle_px;
  const double length = glm::length(offset);
  const double near_rad = 2.0 * std::atan((length - rim.radius_px) / (2.0 * lens.focal_px));
  const double far_rad = 2.0 * std::atan((length + rim.radius_px) / (2.0 * lens.focal_px));
  const double tilt = (near_rad + far_rad) / 2.0;
  const glm::dvec2 outwards = length > 0.0 ? offset / length : glm::dvec2(1.0, 0.0);
  axis_ = {std::sin(tilt) * outwards.x, -std::sin(tilt) * outwards.y, -std::cos(tilt)};
  sine_of_rim_ = std::sin((far_rad - near_rad) / 2.0);
}

double BallView::fromRim_px(glm::dvec2 position_px) const {
  return rim_.radius_px - glm::distance(lens_.planeFromPicture(position_px), rim_.center_px);
}

std::optional<SeenAt> BallView::seenAt(glm::dvec3 direction) const {
  const double along = -glm::dot(direction, axis_);
  const glm::dvec3 across = direction + along * axis_;
  const double sine = glm::length(across);
  const double theta = std::atan2(sine, along);
  if (theta >= glm::pi<double>() - blindHalfAngle_rad()) return {};
  const double alpha = normalAngle(theta, sine_of_rim_);
  const glm::dvec3 sideways = sine > 0.0 ? across / sine : glm::dvec3(0.0);
  const glm::dvec3 normal = std::sin(alpha) * sideways - std::cos(alpha) * axis_;
  const glm::dvec2 position = lens_.isOrthographic() ? rim_.center_px + rim_.radius_px * glm::dvec2(normal.x, -normal.y)
                                                     : lens_.pictureOf(axis_ + sine_of_rim_ * normal);
  return SeenAt{position, std::cos(theta - alpha), fromRim_px(position)};
}

glm::dvec3 BallView::normalAt(glm::dvec2 position_px) const {
  if (lens_.isOrthographic()) {
    const glm::dvec2 p = (position_px - rim_.center_px) / rim_.radius_px;
    return {p.x, -p.y, std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)))};
  }
  // In units of the distance: the near one of the two points where the ray meets the sphere.
  const glm::dvec3 ray = lens_.rayThrough(position_px);
  const double along = glm::dot(ray, axis_);
  const double square = along * along - 1.0 + sine_of_rim_ * sine_of_rim_;
  const double t = along - std::sqrt(std::max(0.0, square));
  return glm::normalize(t * ray - axis_);
}

std::optional<glm::dvec3> BallView::directionAt(glm::dvec2 position_px) const {
  if (fromRim_px(position_px) < 0.0) return {};
  const glm::dvec3 ray = lens_.isOrthographic() ? axis_ : lens_.rayThrough(position_px);
  const glm::dvec3 normal = normalAt(position_px);
  return glm::normalize(ray - 2.0 * glm::dot(ray, normal) * normal);
}

double BallView::unseenHalfAngle_rad(double margin_px) const {
  // By bisection on the circle of directions through the axis: what is seen moves inwards as the angle grows.
  const glm::dvec3 sideways = glm::normalize(std::abs(axis_.y) < 0.9 ? glm::cross(axis_, glm::dvec3(0.0, 1.0, 0.0))
                                                                     : glm::dvec3(1.0, 0.0, 0.0));
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
    points.push_back(lens_.pictureFromPlane(on_circle));
  }
  return points;
}

}  // namespace mirrorball
