#include "mirrorball/bake/prefilter/lobe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "formula/bsdf.h"
#include "mirrorball/bake/harmonics/gauss_legendre.h"

namespace mirrorball {
namespace {

/// Where a lobe is integrated: cos θ, and the lobe times the solid angle that the place stands for.
struct Samples {
  std::vector<double> cosines;
  std::vector<double> weighted;
};

/// Panels of 16 Gauss points that grow with the distance from the middle, but none so wide that the highest harmonic
/// swings more than twice in it.
Samples sampled(const LobeShape& shape, double width, int max_bands) {
  const QuadratureRule rule = gaussLegendre(16);
  const double widest = 4.0 * std::numbers::pi / max_bands;
  Samples samples;
  for (double begin = 0.0; begin < std::numbers::pi / 2;) {
    const double panel = std::min(std::max(begin, width) / 2, widest);
    const double end = std::min(begin + panel, std::numbers::pi / 2);
    for (std::size_t i = 0; i < rule.places.size(); ++i) {
      const double theta = (begin + end + (end - begin) * rule.places[i]) / 2;
      const double half = std::sin(theta / 2);
      const double ring = 2.0 * std::numbers::pi * std::sin(theta) * rule.weights[i] * (end - begin) / 2;
      samples.cosines.push_back(std::cos(theta));
      samples.weighted.push_back(ring * static_cast<double>(shape.at(static_cast<float>(half * half))));
    }
    begin = end;
  }
  return samples;
}

/// Σ weighted · P_l(cosine), band by band until a whole stretch of them stays below kMinBand.
std::vector<float> bandsOf(const Samples& samples, int max_bands) {
  constexpr int kStretch = 16;
  const std::size_t count = samples.cosines.size();
  std::vector<double> here(count, 1.0);
  std::vector<double> before(count, 0.0);
  std::vector<float> bands;
  double whole = 1.0;
  int small = 0;
  for (int l = 0; l < max_bands && small < kStretch; ++l) {
    double sum = 0.0;
    const double a = (2.0 * l + 1.0) / (l + 1.0);
    const double b = l / (l + 1.0);
    for (std::size_t i = 0; i < count; ++i) {
      sum += samples.weighted[i] * here[i];
      const double next = a * samples.cosines[i] * here[i] - b * before[i];
      before[i] = here[i];
      here[i] = next;
    }
    if (l == 0) whole = sum;
    bands.push_back(static_cast<float>(sum / whole));
    const float min = l < Lobe::kCheapBands ? Lobe::kMinBand : Lobe::kMinFurtherBand;
    small = std::abs(bands.back()) < min ? small + 1 : 0;
  }
  return {bands.begin(), bands.end() - small};
}

}  // namespace

float LobeShape::at(float s) const {
  switch (distribution) {
    case Distribution::phong:
      return formula::phongLobe(parameter, s);
    case Distribution::blinn:
      return formula::blinnLobe(parameter, s);
    case Distribution::charlie:
      return formula::charlieLobe(parameter, s);
    case Distribution::ggx:
      break;
  }
  return formula::ggxLobe(parameter, s);
}

Lobe::Lobe(const LobeShape& shape, float width_rad) : shape_(shape), width_rad_(width_rad) {
  // GGX needs 5.5 / width; lobes with an edge fall like l^-2.5 in the end.
  const int max_bands = static_cast<int>(6.0f / width_rad) + kCheapBands;
  const Samples samples = sampled(shape_, static_cast<double>(width_rad), max_bands);
  double whole = 0.0;
  for (const double weighted : samples.weighted) whole += weighted;
  scale_ = static_cast<float>(1.0 / whole);
  bands_ = bandsOf(samples, max_bands);
}

int Lobe::bandsFor(float tolerance) const {
  double left_out = 0.0;
  std::size_t l = bands_.size();
  while (l > kCheapBands) {
    const auto band = static_cast<double>(bands_[l - 1]);
    left_out += (2.0 * static_cast<double>(l) - 1.0) / (4.0 * std::numbers::pi) * band * band;
    if (std::abs(band) > static_cast<double>(kMaxLeftOut) || std::sqrt(left_out) > static_cast<double>(tolerance))
      break;
    --l;
  }
  return static_cast<int>(l);
}

Lobe Lobe::reflection(Distribution distribution, float perceptual_roughness) {
  const float alpha = formula::alphaFromPerceptualRoughness(perceptual_roughness);
  assert(alpha >= kMinAlpha);
  switch (distribution) {
    case Distribution::phong:
      return Lobe({distribution, formula::phongExponent(alpha)}, alpha);
    case Distribution::blinn:
      return Lobe({distribution, formula::blinnExponent(alpha)}, alpha);
    case Distribution::charlie:
    case Distribution::ggx:
      break;
  }
  return Lobe({distribution, alpha}, alpha);
}

/// GGX with microfacets in all directions alike.
Lobe Lobe::cosine() { return Lobe({Distribution::ggx, 1.0f}, 1.0f); }

}  // namespace mirrorball
