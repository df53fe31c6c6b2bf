#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace mirrorball {

/// A rule that integrates over [−1, 1]: ∫ f ≈ Σ weight · f(place).
struct QuadratureRule {
  std::vector<double> places;
  std::vector<double> weights;
};

/// The rule of `count` points that is exact for polynomials up to degree 2 count − 1.
///
/// cost     O(count²)
/// from     Newton's method on P_n from the places' asymptotic form (Abramowitz & Stegun 22.16.6, 25.4.29)
inline QuadratureRule gaussLegendre(int count) {
  QuadratureRule rule;
  for (int i = 0; i < count; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 1.0;
    for (int step = 0; step < 6; ++step) {
      double before = 1.0;
      double here = x;
      for (int l = 2; l <= count; ++l) {
        const double next = ((2 * l - 1) * x * here - (l - 1) * before) / l;
        before = here;
        here = next;
      }
      slope = count * (x * here - before) / (x * x - 1.0);
      x -= here / slope;
    }
    rule.places.push_back(x);
    rule.weights.push_back(2.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

}  // namespace mirrorball
