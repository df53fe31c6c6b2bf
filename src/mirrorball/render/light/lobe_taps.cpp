#include "mirrorball/render/light/lobe_taps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mirrorball/base/linear_system.h"

namespace mirrorball {
namespace {

constexpr double kPi = std::numbers::pi;

/// Taps at the same angle from the lobe's middle.
struct Ring {
  double theta_rad;
  double phase;  ///< of its first point, in steps between points
  double footprint_rad;
};

/// Where the integral of a power of the lobe reaches the share (i + ½) / count and i / count, as s = sin²(θ/2).
class LobeQuantiles {
 public:
  explicit LobeQuantiles(const Lobe& lobe) {
    // Steps that grow with s, from the lobe's width on.
    constexpr int kSteps = 4096;
    const double a2 = static_cast<double>(lobe.width()) * static_cast<double>(lobe.width());
    double sum = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const double s = a2 * (std::pow(1.0 + 0.5 / a2, double(i) / kSteps) - 1.0);
      if (i > 0) {
        const double middle = (s + places_.back()) / 2;
        sum += std::pow(static_cast<double>(lobe.at(static_cast<float>(middle))), kPower) * (s - places_.back());
      }
      places_.push_back(s);
      sums_.push_back(sum);
    }
  }

  double at(double share) const {
    const auto found = std::lower_bound(sums_.begin(), sums_.end(), share * sums_.back());
    return places_[std::min(static_cast<std::size_t>(found - sums_.begin()), places_.size() - 1)];
  }

 private:
  /// Less than 1, since the wide taps far out blur light that a few more would tell apart. Found by trying.
  static constexpr double kPower = 0.8;

  std::vector<double> places_;
  std::vector<double> sums_;
};

std::vector<Ring> ringsOf(const Lobe& lobe, double texel_rad, int rings, int points) {
  // A tap's footprint against the side of its part of the ring. For a cube without texels of its own 1.55 would be
  // best; smaller ones read finer mip levels, which show less where their texels lie.
  constexpr double kOverlap = 1.2;
  const LobeQuantiles quantiles(lobe);
  std::vector<Ring> made;
  for (int i = 0; i < rings; ++i) {
    const double inner = quantiles.at(double(i) / rings);
    const double outer = quantiles.at((i + 1.0) / rings);
    const double middle = quantiles.at((i + 0.5) / rings);
    const double solid_angle = 4.0 * kPi * (outer - inner) / points;
    made.push_back({2.0 * std::asin(std::sqrt(middle)), i % 2 == 0 ? 0.0 : 0.5,
                    std::max(kOverlap * std::sqrt(solid_angle), texel_rad)});
  }
  return made;
}

/// What reads of a footprint leave of each band: those of a Gaussian of the same
/// variance (formula/prefilter/mip_taps.glsl).
std::vector<double> bandsOfFootprint(double footprint_rad, double texel_rad, int bands) {
  const double variance = footprint_rad * footprint_rad * 5 / 12 - texel_rad * texel_rad / 4;
  std::vector<double> left;
  for (int l = 0; l < bands; ++l) left.push_back(std::exp(-0.5 * l * (l + 1.0) * variance));
  return left;
}

/// Σ terms[l] P_l(cosine).
double legendreSum(const std::vector<double>& terms, double cosine) {
  double before = 0.0;
  double here = 1.0;
  double sum = 0.0;
  for (std::size_t l = 0; l < terms.size(); ++l) {
    sum += terms[l] * here;
    const auto band = static_cast<double>(l);
    const double next = ((2.0 * band + 1.0) * cosine * here - band * before) / (band + 1.0);
    before = here;
    here = next;
  }
  return sum;
}

/// Expected products over random light: of what two rings read, and of what a ring reads with the lobe's mean.
struct Expectations {
  std::size_t count;
  std::vector<double> of_rings;  ///< count × count
  std::vector<double> with_lobe;

  double of(std::size_t i, std::size_t j) const { return of_rings[i * count + j]; }
};

/// The mean over the points of two rings of Σ terms[l] P_l(the cosine between them).
double meanBetween(const Ring& one, const Ring& other, int points, const std::vector<double>& terms) {
  double sum = 0.0;
  for (int k = 0; k < points; ++k) {
    const double turn = 2.0 * kPi * (k + one.phase - other.phase) / points;
    const double cosine = std::cos(one.theta_rad) * std::cos(other.theta_rad) +
                          std::sin(one.theta_rad) * std::sin(other.theta_rad) * std::cos(turn);
    sum += legendreSum(terms, std::clamp(cosine, -1.0, 1.0));
  }
  return sum / points;
}

Expectations expectationsOf(const std::vector<Ring>& rings, int points, const Lobe& lobe, double texel_rad) {
  // Finer bands than the texels can hold there are not.
  const int bands =
      std::min(static_cast<int>(lobe.bands().size()) + 64, std::max(static_cast<int>(kPi / texel_rad), 8));
  std::vector<double> power(static_cast<std::size_t>(bands), 0.0);  // of all 2 l + 1 harmonics of a band
  for (int l = 1; l < bands; ++l) power[static_cast<std::size_t>(l)] = (2.0 * l + 1.0) / (l * (l + 1.0));

  std::vector<std::vector<double>> left;
  for (const Ring& ring : rings) left.push_back(bandsOfFootprint(ring.footprint_rad, texel_rad, bands));
  Expectations expectations{rings.size(), std::vector<double>(rings.size() * rings.size()), {}};
  std::vector<double> terms(power.size());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t l = 0; l < terms.size(); ++l)
      terms[l] = l < lobe.bands().size() ? power[l] * left[i][l] * static_cast<double>(lobe.bands()[l]) : 0.0;
    expectations.with_lobe.push_back(legendreSum(terms, std::cos(rings[i].theta_rad)));
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t l = 0; l < terms.size(); ++l) terms[l] = power[l] * left[i][l] * left[j][l];
      const double product = meanBetween(rings[i], rings[j], points, terms);
      expectations.of_rings[i * rings.size() + j] = product;
      expectations.of_rings[j * rings.size() + i] = product;
    }
  }
  return expectations;
}

/// The weights with the sum 1 and the least expected square error, of the rings given only: where its gradient is the
/// same for each (Lagrange).
std::vector<double> bestWeights(const Expectations& expectations, const std::vector<std::size_t>& rings) {
  // As much noise in each read keeps the system from being singular where rings read nearly the same.
  constexpr double kNoise = 1e-9;
  const std::size_t count = rings.size();
  std::vector<std::vector<double>> rows(count + 1, std::vector<double>(count + 2, 1.0));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) rows[i][j] = expectations.of(rings[i], rings[j]);
    rows[i][i] *= 1.0 + kNoise;
    rows[i][count + 1] = expectations.with_lobe[rings[i]];
  }
  rows[count][count] = 0.0;
  std::vector<double> solution = solved(std::move(rows));
  solution.pop_back();
  return solution;
}

/// Rings that would take light away are left out, the worst first.
std::vector<double> positiveWeights(const Expectations& expectations) {
  std::vector<std::size_t> rings(expectations.count);
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i] = i;
  for (;;) {
    const std::vector<double> weights = bestWeights(expectations, rings);
    const auto min = std::min_element(weights.begin(), weights.end());
    if (*min >= 0.0) {
      std::vector<double> all(expectations.count, 0.0);
      for (std::size_t i = 0; i < rings.size(); ++i) all[rings[i]] = weights[i];
      return all;
    }
    rings.erase(rings.begin() + (min - weights.begin()));
  }
}

}  // namespace

std::vector<LobeTap> lobeTaps(const Lobe& lobe, float texel_rad, int rings, int points) {
  const auto texel = static_cast<double>(texel_rad);
  const std::vector<Ring> made = ringsOf(lobe, texel, rings, points);
  const std::vector<double> weights = positiveWeights(expectationsOf(made, points, lobe, texel));
  std::vector<LobeTap> taps;
  for (std::size_t i = 0; i < made.size(); ++i)
    for (int k = 0; k < points; ++k) {
      const double turn = 2.0 * kPi * (k + made[i].phase) / points;
      const double radius = std::sin(made[i].theta_rad);
      taps.push_back({glm::vec2(radius * std::cos(turn), radius * std::sin(turn)),
                      static_cast<float>(made[i].footprint_rad), static_cast<float>(weights[i] / points)});
    }
  return taps;
}

}  // namespace mirrorball
