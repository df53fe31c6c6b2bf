#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "mirrorball/bake/lobe_row/rough_lobe.h"

namespace mirrorball {

/// A row of round lobes for one roughness and one angle, by numbers that may have any value: four a lobe.
struct RowParameters {
  std::vector<double> values;

  int lobes() const { return static_cast<int>(values.size()) / 4; }

  /// A row to begin with: lobes alike, beside each other about the mirror direction.
  static RowParameters even(int lobes);
};

/// What the table holds of the row: a texel a lobe, as formula::lobeOfRow reads them.
std::vector<glm::vec4> texelsOf(const RowParameters& row);

/// The light that a row of lobes takes from each direction of a RoughLobe.
struct RowMixture {
  std::vector<double> of_metal;       ///< [1/sr]
  std::vector<double> of_dielectric;  ///< [1/sr] for that lobe's share of grazing light
};
RowMixture mixtureOf(const RoughLobe& lobe, std::span<const glm::vec4> row);

/// What holds a row to its neighbours in a table.
struct RowPrior {
  const RowParameters* parameters = nullptr;  ///< null: nothing does
  double strength = 0.0;                      ///< of a squared difference, beside squared relative distances
};

/// Fits a row so that the squared relative distances to the lobe of a metal and to that of a dielectric, and what the
/// prior asks, are least: by Levenberg and Marquardt's steps.
///
/// row      to begin with
/// steps    at most
/// cost     some 10 ms a step for 4 lobes and 56 circles
/// from     Marquardt 1963, "An algorithm for least-squares estimation of nonlinear parameters"
RowParameters fitted(const RoughLobe& lobe, RowParameters row, const RowPrior& prior, int steps);

}  // namespace mirrorball
