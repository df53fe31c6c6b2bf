#include "mirrorball/bake/harmonics/spherical_harmonics.h"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "formula/prefilter.h"
#include "mirrorball/bake/harmonics/gauss_legendre.h"

namespace mirrorball {
namespace {

/// Σ over l and m up to `degree` of the coefficients, times Y_lm, at (θ, φ) of a panorama.
glm::dvec3 valueAt(const HarmonicCoefficients& coefficients, int degree, double cosine, double phi) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  glm::dvec3 sum(0.0);
  for (int m = 0; m <= degree; ++m) {
    const LegendreOrder& legendre = coefficients.legendre(m);
    double before = 0.0;
    double here = std::exp2(legendre.log2_seed) * std::pow(sine, m);
    for (std::size_t k = 0; m + static_cast<int>(k) <= degree; ++k) {
      const HarmonicCoefficients::Value& value = coefficients.order(m)[k];
      const double function = here * legendre.scale[k] * (m == 0 ? 1.0 : 2.0);
      sum += function * (glm::dvec3(value.real) * std::cos(m * phi) - glm::dvec3(value.imaginary) * std::sin(m * phi));
      const double next = legendre.step[k] * cosine * here - before;
      before = here;
      here = next;
    }
  }
  return sum;
}

int bandOf(std::size_t index) { return static_cast<int>(std::sqrt(static_cast<double>(index))); }

}  // namespace

Harmonics radianceHarmonics(const LightHarmonics& light, int degree, const glm::mat3& source_from_target) {
  assert(degree >= 0 && degree <= 4 && degree < light.coefficients().bands());
  // The transform's pole is +Y, the harmonics' is +Z. What both say of a band is the same function, so that it is
  // projected again, by a rule that is exact for products of two harmonics.
  constexpr int kMeridians = 10;
  const QuadratureRule rule = gaussLegendre(5);
  const glm::mat3 target_from_source = glm::transpose(source_from_target);
  std::vector<glm::dvec3> sums(static_cast<std::size_t>((degree + 1) * (degree + 1)), glm::dvec3(0.0));
  for (std::size_t ring = 0; ring < rule.places.size(); ++ring)
    for (int meridian = 0; meridian < kMeridians; ++meridian) {
      const double cosine = rule.places[ring];
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const double phi = 2.0 * std::numbers::pi * meridian / kMeridians;
      const glm::vec3 direction = target_from_source * glm::vec3(sine * std::sin(phi), cosine, -sine * std::cos(phi));
      const glm::dvec3 value = valueAt(light.coefficients(), degree, cosine, phi) * rule.weights[ring] *
                               (2.0 * std::numbers::pi / kMeridians);
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += value * static_cast<double>(formula::harmonic(static_cast<int>(i), direction));
    }
  for (const PointOfLight& point : light.bright().points) {
    const glm::vec3 direction = target_from_source * point.direction;
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += glm::dvec3(point.flux) * static_cast<double>(formula::harmonic(static_cast<int>(i), direction));
  }
  return Harmonics(sums.begin(), sums.end());
}

Harmonics irradianceOf(Harmonics radiance) {
  for (std::size_t i = 0; i < radiance.size(); ++i) radiance[i] *= formula::cosineLobeBand(bandOf(i));
  return radiance;
}

Harmonics windowed(Harmonics harmonics) {
  const int degree = bandOf(harmonics.size()) - 1;
  for (std::size_t i = 0; i < harmonics.size(); ++i) harmonics[i] *= formula::harmonicWindow(bandOf(i), degree);
  return harmonics;
}

}  // namespace mirrorball
