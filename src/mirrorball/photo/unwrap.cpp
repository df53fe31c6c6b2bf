#include "mirrorball/photo/unwrap.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "formula/color.h"
#include "mirrorball/environment/fill.h"
#include "mirrorball/image/filter.h"

namespace mirrorball {
namespace {

/// Texels a side of the cube that holds the continued light: 1.4°,
/// where the smallest blind regions are some 20° across.
constexpr int kFillSize = 64;

/// What one photograph says about a direction.
struct Seen {
  glm::vec3 light{0.0f};
  float weight = 0.0f;    ///< against other photographs
  float presence = 0.0f;  ///< 0 where it is not seen, rising to 1 within a few pixels
};

/// A direction of the first camera in the axes of one that was carried around the ball.
glm::dvec3 turned(glm::dvec3 d, double turn_deg) {
  const double c = std::cos(glm::radians(turn_deg)), s = std::sin(glm::radians(turn_deg));
  return {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
}

/// Pixels beside the ball or the picture have no weight.
glm::vec3 lightAt(const BallPhotograph& photograph, glm::dvec2 position) {
  const Image& image = photograph.light;
  return bilinear(glm::vec2(position), [&](int x, int y) {
    const bool inside = x >= 0 && y >= 0 && x < image.width() && y < image.height();
    if (!inside || photograph.view.fromRim_px(glm::dvec2(x, y) + 0.5) < 0.0) return glm::vec4(0.0f);
    return glm::vec4(rgbAt(image, x, y), 1.0f);
  });
}

Seen look(const BallPhotograph& photograph, glm::vec3 direction) {
  const auto at = photograph.view.seenAt(turned(glm::dvec3(direction), photograph.turn_deg));
  if (!at) return {};
  const double margin = rimMargin_px(photograph.view);
  const glm::dvec2 extent(photograph.light.width(), photograph.light.height());
  const glm::dvec2 from_border = glm::min(at->position_px, extent - at->position_px);
  const double inside = std::min(at->from_rim_px - margin, std::min(from_border.x, from_border.y) - 0.5);
  const auto presence = static_cast<float>(glm::smoothstep(0.0, 1.5 * margin, inside));
  if (presence == 0.0f) return {};
  return {lightAt(photograph, at->position_px), presence * static_cast<float>(std::pow(at->facing, 4.0)), presence};
}

/// All photographs of a ball, and what is continued where they end.
struct Ball {
  std::vector<BallPhotograph> photographs;
  std::vector<float> gains;
  EnvironmentMap continued;

  /// The blend of what is seen; its presence is that of the photograph that sees the direction best.
  Seen blend(glm::vec3 direction) const {
    Seen sum;
    for (std::size_t i = 0; i < photographs.size(); ++i) {
      const Seen seen = look(photographs[i], direction);
      sum.light += seen.weight * gains[i] * seen.light;
      sum.weight += seen.weight;
      sum.presence = std::max(sum.presence, seen.presence);
    }
    if (sum.weight > 0.0f) sum.light /= sum.weight;
    return sum;
  }

  glm::vec3 radiance(glm::vec3 direction) const {
    const Seen seen = blend(direction);
    if (seen.presence >= 1.0f) return seen.light;
    return glm::mix(continued.radiance(direction), seen.light, seen.presence);
  }
};

/// Directions spread evenly over the sphere (Fibonacci's lattice).
template <typename Visit>
void forEachDirection(int count, Visit&& visit) {
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / count;
    const double longitude = glm::pi<double>() * (3.0 - std::sqrt(5.0)) * i;
    const double radius = std::sqrt(1.0 - y * y);
    visit(glm::vec3(radius * std::cos(longitude), y, radius * std::sin(longitude)));
  }
}
constexpr int kDirections = 50000;

/// What a photograph's light is to be multiplied by to agree with the first one's; 1 where they see nothing in common.
float gainOf(const BallPhotograph& first, const BallPhotograph& later) {
  constexpr float kSeenWell = 0.02f;  // a facing of 0.38
  std::vector<float> ratios;
  forEachDirection(kDirections, [&](glm::vec3 direction) {
    const Seen a = look(first, direction), b = look(later, direction);
    const float light_a = formula::luminance(a.light), light_b = formula::luminance(b.light);
    if (std::min(a.weight, b.weight) > kSeenWell && light_a > 0.0f && light_b > 0.0f)
      ratios.push_back(light_a / light_b);
  });
  if (ratios.empty()) return 1.0f;
  const auto middle = ratios.begin() + std::ptrdiff_t(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

/// A panorama's height with the texels that the ball's middle has, by the rule for sphere maps.
int panoramaHeight(const std::vector<BallPhotograph>& photographs) {
  double radius = 1.0;
  for (const BallPhotograph& photograph : photographs) radius = std::max(radius, photograph.view.rim().radius_px);
  return std::max(2, static_cast<int>(std::lround(2.0 * radius)));
}

}  // namespace

double rimMargin_px(const BallView& view) { return std::max(1.5, 0.004 * view.rim().radius_px); }

Result<UnwrappedPhotographs> unwrapBall(std::vector<BallPhotograph> photographs) {
  const int height = panoramaHeight(photographs);
  auto ball = std::make_shared<Ball>();
  ball->photographs = std::move(photographs);
  ball->gains.assign(ball->photographs.size(), 1.0f);
  for (std::size_t i = 1; i < ball->photographs.size(); ++i)
    ball->gains[i] = gainOf(ball->photographs[0], ball->photographs[i]);

  MIRRORBALL_TRY(continued, continueSmoothly(
                                [&](glm::vec3 direction) -> std::optional<glm::vec3> {
                                  const Seen seen = ball->blend(direction);
                                  if (seen.presence < 1.0f) return {};
                                  return seen.light;
                                },
                                kFillSize));
  ball->continued = std::move(continued);

  int unseen = 0;
  forEachDirection(kDirections, [&](glm::vec3 direction) { unseen += ball->blend(direction).presence < 0.5f; });
  UnwrappedPhotographs unwrapped{
      Environment([ball](glm::vec3 direction) { return ball->radiance(direction); }, height), {}, 0.0};
  unwrapped.gains.assign(ball->gains.begin(), ball->gains.end());
  unwrapped.filled_sr = 4.0 * glm::pi<double>() * unseen / kDirections;
  return unwrapped;
}

}  // namespace mirrorball
