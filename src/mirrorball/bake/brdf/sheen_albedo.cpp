#include "mirrorball/bake/brdf/sheen_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "formula/bsdf.h"
#include "mirrorball/bake/harmonics/gauss_legendre.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kSide = 64;
/// Light along the surface has no place in the formula.
constexpr float kLeastCosine = 1e-3f;

/// ∫ D V / (4 n·v) dl over the hemisphere: evalCharlie, of which only D changes around the normal. n·l goes by squares,
/// since the light that counts is near the horizon.
float integrated(float sheen_roughness, float cosine) {
  static const QuadratureRule kAlong = gaussLegendre(24);
  static const QuadratureRule kAround = gaussLegendre(32);
  const float alpha = formula::alphaOfSheen(sheen_roughness);
  const glm::vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  const float hidden_from_eye = formula::charlieLambda(alpha, cosine);
  double sum = 0.0;
  for (std::size_t i = 0; i < kAlong.places.size(); ++i) {
    const double t = (1.0 + kAlong.places[i]) / 2.0;
    const auto light = static_cast<float>(t * t);
    const float sine = std::sqrt(1.0f - light * light);
    double ring = 0.0;
    for (std::size_t j = 0; j < kAround.places.size(); ++j) {
      const float around = formula::kPi * static_cast<float>((1.0 + kAround.places[j]) / 2.0);
      const glm::vec3 l(sine * std::cos(around), sine * std::sin(around), light);
      ring += kAround.weights[j] * double(formula::charlieDistribution(alpha, glm::normalize(v + l)));
    }
    const float masking = 1.0f / (1.0f + hidden_from_eye + formula::charlieLambda(alpha, light));
    // Both halves of the circle; dμ = 2 t dt.
    sum += kAlong.weights[i] / 2.0 * 2.0 * t * ring * double(formula::kPi * masking / (4.0f * cosine));
  }
  return static_cast<float>(std::clamp(sum, 0.0, 1.0));
}

/// Roughness downwards, √(n·v) to the right; the first and the last texel are the ends.
std::vector<float> makeTable() {
  std::vector<float> table(std::size_t(kSide) * kSide);
  parallelFor(kSide, 1, [&](std::size_t row, std::size_t) {
    for (std::size_t column = 0; column < kSide; ++column) {
      const float root = static_cast<float>(column) / (kSide - 1);
      table[row * kSide + column] =
          integrated(static_cast<float>(row) / (kSide - 1), std::clamp(root * root, kLeastCosine, 1.0f));
    }
  });
  return table;
}

}  // namespace

float sheenAlbedo(float sheen_roughness, float cosine) {
  static const std::vector<float> table = makeTable();
  const glm::vec2 place = glm::vec2(std::sqrt(cosine), sheen_roughness) * float(kSide - 1);
  const glm::ivec2 first = glm::clamp(glm::ivec2(place), 0, kSide - 2);
  const glm::vec2 share = place - glm::vec2(first);
  const auto at = [&](int x, int y) { return table[std::size_t(first.y + y) * kSide + std::size_t(first.x + x)]; };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), share.x), glm::mix(at(0, 1), at(1, 1), share.x), share.y);
}

}  // namespace mirrorball
