#include "mirrorball/environment/projection/texel_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/constants.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A texel's rectangle, in the units of the projection.
struct Rectangle {
  glm::dvec2 low;
  glm::dvec2 high;
};

/// The integral of a density over a rectangle, from its integral between the origin and each of the four corners.
template <typename Corner>
double byCorners(const Rectangle& r, Corner&& corner) {
  return corner(r.high.x, r.high.y) - corner(r.high.x, r.low.y) - corner(r.low.x, r.high.y) + corner(r.low.x, r.low.y);
}

// On an octahedron's face lines of constant x and of constant y are great circles, so that a texel is a spherical
// polygon: its solid angle is the sum of its inner angles less (n − 2) π (Girard). In the quadrant x, y ≥ 0 of the
// front half the point is p = (x, y, 1 − x − y), the planes of the two lines have the normals N = (x − 1, x, x) and
// M = (y, y − 1, y), and N × M = p: the angle between them at the corner is F = atan2(|p|, N·M), N·M = 3xy − x − y.
// Beyond the fold x + y = 1 it is that of the mirrored point (1 − y, 1 − x), and the fold's own angles come in:
// A(t) = atan2(√(2t² − 2t + 1), t) is that between N(t) and the plane z = 0.

double octahedralFoldAngle(double t) { return std::atan2(std::sqrt(2.0 * t * t - 2.0 * t + 1.0), t); }

double octahedralAngle(double x, double y) {
  return std::atan2(std::sqrt(x * x + y * y + (1.0 - x - y) * (1.0 - x - y)), 3.0 * x * y - x - y);
}

/// The solid angle between the centre of the square [−1, 1]² and (x, y), odd in both.
double octahedralCorner(double x, double y) {
  const double a = std::abs(x);
  const double b = std::abs(y);
  const double across_fold =
      octahedralFoldAngle(a) - octahedralFoldAngle(1.0 - a) + octahedralFoldAngle(b) - octahedralFoldAngle(1.0 - b);
  const double angle = a + b <= 1.0 ? octahedralAngle(a, b) : octahedralAngle(1.0 - b, 1.0 - a) + across_fold;
  const double size = octahedralAngle(a, 0.0) + octahedralAngle(b, 0.0) - kPi / 2.0 - angle;
  return std::copysign(size, x * y);
}

/// The same for half the octahedron turned by 45°. For 0 ≤ |y| ≤ x the point is p = ((x + y) / 2, (x − y) / 2, 1 − x),
/// the normals are (1 − x, 1 − x, −x) and (y − 1, y + 1, y), their product 2y − 3xy and their cross product 2p; the
/// fold x = y is the plane py = 0, whose angles with the two at (b, b) come in.
double hemioctahedralCorner(double x, double y) {
  const double a = std::max(std::abs(x), std::abs(y));
  const double b = std::min(std::abs(x), std::abs(y));
  const double angle =
      std::atan2(std::sqrt(2.0 * a * a + 2.0 * b * b + 4.0 * (1.0 - a) * (1.0 - a)), 2.0 * b - 3.0 * a * b);
  const double at_fold = std::sqrt(2.0 * b * b - 2.0 * b + 1.0);
  const double across_fold = std::atan2(at_fold, 1.0 - b) - std::atan2(at_fold, 1.0 + b);
  return std::copysign(angle - kPi / 2.0 + across_fold, x * y);
}

/// The solid angle of a rectangle on a disc where the angle θ from the axis depends on the radius ρ alone. By Green's
/// theorem ∫ sin θ dθ dφ = ∮ (1 − cos θ) dφ = ∮ h (x dy − y dx) with h = (1 − cos θ) / ρ², smooth at the centre too.
/// Each side takes three points of Gauss' rule.
///
/// height   h as a function of ρ²
template <typename Height>
double onDisc(const Rectangle& r, Height&& height) {
  constexpr std::array<double, 3> kPoints{0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> kWeights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const glm::dvec2 extent = r.high - r.low;
  double sum = 0.0;
  for (std::size_t i = 0; i < kPoints.size(); ++i) {
    const glm::dvec2 p = r.low + extent * kPoints[i];
    const auto at = [&](double x, double y) { return height(x * x + y * y); };
    sum += kWeights[i] * extent.x * (r.high.y * at(p.x, r.high.y) - r.low.y * at(p.x, r.low.y));
    sum += kWeights[i] * extent.y * (r.high.x * at(r.high.x, p.y) - r.low.x * at(r.low.x, p.y));
  }
  return sum;
}

double angularHeight(double square) {
  if (square < 1e-12) return kPi * kPi / 2.0;
  const double sine = std::sin(kPi / 2.0 * std::sqrt(square));
  return 2.0 * sine * sine / square;
}

/// From the sines and cosines of formula/projection/mirror_ball.glsl. Beyond the rim the density is that of the same
/// distance before it: a texel there counts for the other half of one whose centre does not lie on the disc.
double ballHeight(double square, double k) {
  const double rim = std::sqrt(1.0 - k * k);
  if (square > 1.0) {
    const double mirrored = 2.0 - std::sqrt(square);
    return (2.0 * (1.0 + rim) - ballHeight(mirrored * mirrored, k) * mirrored * mirrored) / square;
  }
  const double q = 1.0 - k * k * (1.0 - square);
  const double cos_psi = rim / std::sqrt(q);
  const double cos_beta = cos_psi * std::sqrt(1.0 - square);
  return (k * k / (1.0 + cos_psi) + 2.0 * (cos_psi - k * cos_beta)) / q;
}

double solidAngle(Projection projection, const Rectangle& uv) {
  // From [0, 1] to [−1, 1], where the centre is the origin.
  const Rectangle centred{2.0 * uv.low - 1.0, 2.0 * uv.high - 1.0};
  const glm::dvec2 extent = centred.high - centred.low;
  switch (projection) {
    case Projection::equirect: {
      // The zone between two parallels has the area 2π (cos θ0 − cos θ1).
      const double middle = kPi * (uv.low.y + uv.high.y) / 2.0;
      const double half = kPi * (uv.high.y - uv.low.y) / 2.0;
      return 4.0 * kPi * (uv.high.x - uv.low.x) * std::sin(middle) * std::sin(half);
    }
    case Projection::sphere:
      return 4.0 * extent.x * extent.y;  // dω = 4 dA, see formula/projection/sphere_map.glsl
    case Projection::angular:
      return onDisc(centred, angularHeight);
    case Projection::ball:
      return onDisc(centred,
                    [k = 1.0 / double(projection.ball_distance)](double square) { return ballHeight(square, k); });
    case Projection::paraboloid:
      return onDisc(centred, [](double square) { return 2.0 / (1.0 + square); });
    case Projection::cube:
      return byCorners(centred, cubeCornerSolidAngle);
    case Projection::eac:
      return byCorners({glm::tan(centred.low * (kPi / 4.0)), glm::tan(centred.high * (kPi / 4.0))},
                       cubeCornerSolidAngle);
    case Projection::octahedral:
      return byCorners(centred, octahedralCorner);
    case Projection::hemioctahedral:
      return byCorners(centred, hemioctahedralCorner);
    case Projection::equal_area:
      return kPi * extent.x * extent.y;
  }
  return 0.0;
}

}  // namespace

double cubeCornerSolidAngle(double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1.0)); }

float texelSolidAngle(Projection projection, glm::ivec2 size, glm::ivec2 texel) {
  const glm::dvec2 low = glm::dvec2(texel) / glm::dvec2(size);
  const glm::dvec2 high = glm::dvec2(texel + 1) / glm::dvec2(size);
  if (!covers(projection, (glm::vec2(texel) + 0.5f) / glm::vec2(size))) return 0.0f;
  return static_cast<float>(solidAngle(projection, {low, high}));
}

std::vector<float> panoramaRowBends(int height) {
  std::vector<float> bends(static_cast<std::size_t>(height) + 1, 0.0f);
  const double row = kPi / height;
  for (int border = 1; border < height; ++border)
    bends[static_cast<std::size_t>(border)] = static_cast<float>(row / (4.0 * std::tan(row * border)));
  return bends;
}

float texelDensity(Projection projection, int size) {
  const auto texels = static_cast<float>(size);
  switch (projection) {
    case Projection::equirect:
      return texels / formula::kPi;
    case Projection::sphere:
      return texels / 4.0f;  // the reflected ray turns twice as fast as the normal, of which the disc shows 2 rad
    case Projection::angular:
      return texels / formula::kTwoPi;
    case Projection::cube:
      return texels / 2.0f;
    case Projection::ball: {
      // Near the axis θ = (2 − k) β and ρ = β √(1 − k²), see formula/projection/mirror_ball.glsl.
      const float k = 1.0f / projection.ball_distance;
      return texels / 2.0f * std::sqrt((1.0f - k) * (1.0f + k)) / (2.0f - k);
    }
    case Projection::paraboloid:
      return texels / 4.0f;  // ρ = tan(θ / 2)
    case Projection::octahedral:
      return texels / 2.0f;
    case Projection::hemioctahedral:
      return texels * std::sqrt(0.5f);
    case Projection::equal_area:
      return texels / std::sqrt(2.0f * formula::kTwoPi);
    case Projection::eac:
      return texels * 2.0f / formula::kPi;
  }
  return texels;
}

TexelDensity texelDensityAt(Projection projection, int size, MapPosition position) {
  constexpr float kStep = 1.0f / 1024.0f;
  constexpr float kMargin = 2.0f * kStep;
  glm::vec2 uv = glm::clamp(position.uv, glm::vec2(kMargin), glm::vec2(1.0f - kMargin));
  const float radius = glm::length(uv - 0.5f);
  if (hasDisc(projection) && radius > 0.5f - kMargin) uv = 0.5f + (uv - 0.5f) * ((0.5f - kMargin) / radius);

  const auto difference = [&](glm::vec2 step) {
    return (directionAt(projection, {position.face, uv + step}) - directionAt(projection, {position.face, uv - step})) /
           (2.0f * kStep);
  };
  // The columns of d(direction)/d(texel), in radians a texel, and from them its singular values.
  const glm::vec2 extent(imageSize(projection, size));
  const glm::vec3 across = difference({kStep, 0.0f}) / extent.x;
  const glm::vec3 down = difference({0.0f, kStep}) / extent.y;
  const float area = glm::length(glm::cross(across, down));
  const float trace = glm::dot(across, across) + glm::dot(down, down);
  const float root = std::sqrt(std::max(trace * trace - 4.0f * area * area, 0.0f));
  const float larger = std::sqrt((trace + root) / 2.0f);
  // Where both are the same, rounding must not exchange them.
  return {std::max(larger / area, 1.0f / larger), 1.0f / larger};
}

}  // namespace mirrorball
