#include "mirrorball/photo/rim_fit.h"

#include <algorithm>
#include <limits>
#include <map>
#include <random>

#include <glm/gtc/constants.hpp>

#include "mirrorball/base/range.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

glm::dvec2 onRay(int ray, int rays) {
  const double angle = glm::two_pi<double>() * (ray + 0.5) / rays;
  return {std::cos(angle), std::sin(angle)};
}

double distanceTo(const Circle& circle, glm::dvec2 point) {
  return glm::distance(point, circle.center_px) - circle.radius_px;
}

/// The derivative of a Gaussian, one sample a step, scaled to give the slope a pixel.
std::vector<double> slopeKernel(double blur_px, double step_px) {
  const int half = static_cast<int>(std::ceil(3.0 * blur_px / step_px));
  std::vector<double> kernel;
  double moment = 0.0;
  for (int i = -half; i <= half; ++i) {
    const double x = i * step_px;
    kernel.push_back(x * std::exp(-x * x / (2.0 * blur_px * blur_px)));
    moment += kernel.back() * x;
  }
  for (double& weight : kernel) weight /= moment;
  return kernel;
}

/// Where a slope falls below a bound outwards of its peak; NaN when it rises again before.
double fallingBelow(const std::vector<double>& slope, std::size_t peak, double bound) {
  for (std::size_t i = peak + 1; i < slope.size() && slope[i] <= slope[i - 1]; ++i)
    if (slope[i] < bound) return double(i) - (bound - slope[i]) / (slope[i - 1] - slope[i]);
  return std::numeric_limits<double>::quiet_NaN();
}

/// The edges of one radius, the strongest first; lengths in samples.
std::vector<EdgePoint> edgesOnRay(const std::vector<double>& profile, const std::vector<double>& kernel) {
  const int half = static_cast<int>(kernel.size()) / 2;
  std::vector<double> slope(profile.size(), 0.0);
  for (std::size_t i = std::size_t(half); i + std::size_t(half) < profile.size(); ++i) {
    for (std::size_t k = 0; k < kernel.size(); ++k) slope[i] += kernel[k] * profile[i + k - std::size_t(half)];
    slope[i] = std::abs(slope[i]);
  }
  std::vector<EdgePoint> peaks;
  for (std::size_t i = 1; i + 1 < slope.size(); ++i) {
    if (slope[i] <= slope[i - 1] || slope[i] < slope[i + 1]) continue;
    const double bend = slope[i - 1] - 2.0 * slope[i] + slope[i + 1];
    const double offset = bend < 0.0 ? 0.5 * (slope[i - 1] - slope[i + 1]) / bend : 0.0;
    EdgePoint peak{{double(i) + offset, 0.0}, 0, slope[i], {}, {}};
    peak.to_half_px = fallingBelow(slope, i, 0.5 * slope[i]) - peak.plane_px.x;
    peak.to_quarter_px = fallingBelow(slope, i, 0.25 * slope[i]) - peak.plane_px.x;
    peaks.push_back(peak);
  }
  sortDownBy(peaks, &EdgePoint::strength);
  return peaks;
}

/// Whether the picture's gradient at a position points along a unit direction, within 26°: what merely happens to
/// change along a radius mostly does not.
bool runsAcross(const PlanePicture& picture, glm::dvec2 position, glm::dvec2 along, double step_px) {
  constexpr double kCosine = 0.9;
  const glm::dvec2 sideways(-along.y, along.x);
  // The mean of three places across and along gives each component the same smoothing.
  double radial = 0.0, tangential = 0.0;
  for (const double shift : {-step_px, 0.0, step_px}) {
    const glm::dvec2 a = position + shift * sideways, b = position + shift * along;
    radial += picture.at(a + step_px * along) - picture.at(a - step_px * along);
    tangential += picture.at(b + step_px * sideways) - picture.at(b - step_px * sideways);
  }
  return std::abs(radial) >= kCosine * std::hypot(radial, tangential);
}

}  // namespace

double PlanePicture::at(glm::dvec2 plane_px) const {
  const glm::dvec2 position = pinhole_.pictureFromPlane(plane_px) / scale_;
  const glm::dvec2 extent(grey_.width(), grey_.height());
  return bilinear(glm::vec2(glm::clamp(position, glm::dvec2(0.0), extent)),
                  [&](int x, int y) {
                    const int i = std::clamp(x, 0, grey_.width() - 1);
                    const int j = std::clamp(y, 0, grey_.height() - 1);
                    return glm::vec4(*grey_.texel(i, j), 0.0f, 0.0f, 1.0f);
                  })
      .x;
}

bool PlanePicture::contains(glm::dvec2 plane_px, double margin_px) const {
  const glm::dvec2 position = pinhole_.pictureFromPlane(plane_px);
  return position.x >= margin_px && position.y >= margin_px && position.x <= grey_.width() * scale_ - margin_px &&
         position.y <= grey_.height() * scale_ - margin_px;
}

std::vector<EdgePoint> edgesAcross(const PlanePicture& picture, const Circle& circle, int rays, double reach_px,
                                   double blur_px, double weakest) {
  constexpr std::size_t kMaxOnRay = 4;
  const double step = std::max(0.25, blur_px / 4.0);
  const std::vector<double> kernel = slopeKernel(blur_px, step);
  const double reach = reach_px + 3.0 * blur_px;
  const int samples = 2 * static_cast<int>(std::ceil(reach / step)) + 1;
  // A radius stands for its share of the rim: the mean over it, as far as the rim is straight there.
  const double half_width = std::min(glm::pi<double>() * circle.radius_px / rays, 0.05 * circle.radius_px) * 0.7;
  const int across = std::clamp(static_cast<int>(half_width), 0, 3);
  std::vector<EdgePoint> edges;
  for (int ray = 0; ray < rays; ++ray) {
    const glm::dvec2 outwards = onRay(ray, rays);
    const double turn = half_width / circle.radius_px / std::max(across, 1);
    std::vector<double> profile(std::size_t(samples), 0.0);
    for (int side = -across; side <= across; ++side) {
      const double c = std::cos(side * turn), s = std::sin(side * turn);
      const glm::dvec2 turned(c * outwards.x - s * outwards.y, s * outwards.x + c * outwards.y);
      for (int i = 0; i < samples; ++i) {
        const double radius = circle.radius_px + (i - samples / 2) * step;
        profile[std::size_t(i)] += picture.at(circle.center_px + radius * turned) / (2 * across + 1);
      }
    }
    std::vector<EdgePoint> found = edgesOnRay(profile, kernel);
    found.resize(std::min(found.size(), kMaxOnRay));
    for (const EdgePoint& peak : found) {
      const double radius = circle.radius_px + (peak.plane_px.x - samples / 2) * step;
      const glm::dvec2 position = circle.center_px + radius * outwards;
      if (peak.strength >= weakest && std::abs(radius - circle.radius_px) <= reach_px &&
          picture.contains(position, 2.0 * blur_px) && runsAcross(picture, position, outwards, 1.5 * blur_px))
        edges.push_back({position, ray, peak.strength, peak.to_half_px * step, peak.to_quarter_px * step});
    }
  }
  return edges;
}

std::optional<Circle> circleThrough(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  // Relative to a, the centre m obeys 2 m·p = p·p for the two others.
  const glm::dvec2 p = b - a, q = c - a;
  const double cross = 2.0 * (p.x * q.y - p.y * q.x);
  if (std::abs(cross) < 1e-9 * glm::dot(p, p)) return {};
  const double pp = glm::dot(p, p), qq = glm::dot(q, q);
  const glm::dvec2 m((q.y * pp - p.y * qq) / cross, (p.x * qq - q.x * pp) / cross);
  return Circle{a + m, glm::length(m)};
}

std::optional<Circle> fitCircle(std::span<const glm::dvec2> points, std::span<const double> weights) {
  double total = 0.0;
  glm::dvec2 mean(0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    total += weights[i];
    mean += weights[i] * points[i];
  }
  if (points.size() < 3 || total <= 0.0) return {};
  mean /= total;
  // Kåsa: least squares of |p|² − 2 m·p − k, linear in m and k, about the mean.
  glm::dmat2 moments(0.0);
  glm::dvec2 right(0.0);
  double square = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 p = points[i] - mean;
    moments += weights[i] * glm::outerProduct(p, p);
    right += weights[i] * glm::dot(p, p) * p;
    square += weights[i] * glm::dot(p, p);
  }
  if (std::abs(glm::determinant(moments)) < 1e-12 * square * square) return {};
  const glm::dvec2 m = 0.5 * (glm::inverse(moments) * right);
  Circle circle{mean + m, std::sqrt(square / total + glm::dot(m, m))};
  for (int step = 0; step < 10; ++step) {
    glm::dmat3 normal(0.0);
    glm::dvec3 gradient(0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec2 outwards = glm::normalize(points[i] - circle.center_px);
      const glm::dvec3 slope(outwards, 1.0);
      normal += weights[i] * glm::outerProduct(slope, slope);
      gradient += weights[i] * distanceTo(circle, points[i]) * slope;
    }
    if (std::abs(glm::determinant(normal)) < 1e-12 * total * total * total) break;
    const glm::dvec3 change = glm::inverse(normal) * gradient;
    circle.center_px += glm::dvec2(change);
    circle.radius_px += change.z;
    if (glm::length(change) < 1e-9) break;
  }
  return circle;
}

RimSupport supportOf(const PlanePicture& picture, const Circle& circle, std::span<const EdgePoint> edges, int rays,
                     double tolerance_px) {
  std::vector<double> nearest(std::size_t(rays), tolerance_px);
  for (const EdgePoint& edge : edges) {
    double& distance = nearest[std::size_t(edge.ray)];
    distance = std::min(distance, std::abs(distanceTo(circle, edge.plane_px)));
  }
  int visible = 0, supported = 0;
  double squares = 0.0;
  for (int ray = 0; ray < rays; ++ray) {
    if (!picture.contains(circle.center_px + circle.radius_px * onRay(ray, rays), 1.0)) continue;
    ++visible;
    const double distance = nearest[std::size_t(ray)];
    if (distance >= tolerance_px) continue;
    ++supported;
    squares += distance * distance;
  }
  return {visible > 0 ? double(supported) / visible : 0.0, double(visible) / rays,
          supported > 0 ? std::sqrt(squares / supported) : 0.0};
}

Circle mostSupported(std::span<const EdgePoint> edges, const Circle& start, int rays, double reach_px,
                     double tolerance_px) {
  constexpr int kTries = 400;
  constexpr double kOfOneOutside = 0.5;
  if (edges.size() < 3) return start;
  // A generator of its own with a fixed seed: the same circle every time.
  std::minstd_rand random(1);
  const auto any = [&] { return edges[random() % edges.size()].plane_px; };
  std::vector<char> hit(static_cast<std::size_t>(rays));
  const auto supportFor = [&](const Circle& circle) {
    std::fill(hit.begin(), hit.end(), 0);
    std::ptrdiff_t outside = 0;
    for (const EdgePoint& edge : edges) {
      const double distance = distanceTo(circle, edge.plane_px);
      if (std::abs(distance) < tolerance_px) hit[std::size_t(edge.ray)] = 1;
      if (distance >= tolerance_px) ++outside;
    }
    return double(std::count(hit.begin(), hit.end(), 1)) - kOfOneOutside * double(outside);
  };
  Circle best = start;
  double most = supportFor(start);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const auto circle = circleThrough(any(), any(), any());
    if (!circle || glm::distance(circle->center_px, start.center_px) > reach_px ||
        std::abs(circle->radius_px - start.radius_px) > reach_px)
      continue;
    if (const double support = supportFor(*circle); support > most) {
      most = support;
      best = *circle;
    }
  }
  return best;
}

std::vector<EdgePoint> correctedByFlanks(std::span<const EdgePoint> edges, const Circle& circle, double tolerance_px) {
  // A Gaussian falls to a half at 1.177 σ and to a quarter at 1.665 σ.
  constexpr double kHalf = 1.17741, kQuarter = 1.66511;
  std::vector<double> widths;
  for (const EdgePoint& edge : edges)
    if (std::abs(distanceTo(circle, edge.plane_px)) < tolerance_px && std::isfinite(edge.to_quarter_px))
      widths.push_back((edge.to_quarter_px - edge.to_half_px) / (kQuarter - kHalf));
  std::vector<EdgePoint> corrected(edges.begin(), edges.end());
  if (widths.empty()) return corrected;
  const auto middle = widths.begin() + std::ptrdiff_t(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  for (EdgePoint& edge : corrected)
    if (std::isfinite(edge.to_half_px))
      edge.plane_px += (edge.to_half_px - kHalf * *middle) * glm::normalize(edge.plane_px - circle.center_px);
  return corrected;
}

Circle refineCircle(std::span<const EdgePoint> edges, Circle circle, double first_px, double last_px) {
  constexpr int kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    const double tolerance = first_px * std::pow(last_px / first_px, double(round) / (kRounds - 1));
    std::map<int, glm::dvec2> outermost;  // of each radius
    for (const EdgePoint& edge : edges) {
      if (std::abs(distanceTo(circle, edge.plane_px)) >= tolerance) continue;
      const auto [entry, is_first] = outermost.try_emplace(edge.ray, edge.plane_px);
      if (!is_first && distanceTo(circle, edge.plane_px) > distanceTo(circle, entry->second))
        entry->second = edge.plane_px;
    }
    std::vector<glm::dvec2> points;
    std::vector<double> weights;
    for (const auto& [ray, point] : outermost) {
      const double share = distanceTo(circle, point) / tolerance;
      points.push_back(point);
      weights.push_back((1.0 - share * share) * (1.0 - share * share));
    }
    const auto fitted = fitCircle(points, weights);
    if (!fitted) break;
    circle = *fitted;
  }
  return circle;
}

}  // namespace mirrorball
