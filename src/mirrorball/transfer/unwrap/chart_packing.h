#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/transfer/unwrap/chart.h"

namespace mirrorball {

/// Where charts lie in a square map.
struct ChartPacking {
  double texels_per_unit = 0.0;    ///< 0: they do not fit at any size
  std::vector<glm::dvec2> corner;  ///< of each chart's origin, in texels
};

/// Packs charts as large as they fit, all to the same scale. Each falls to where its lower outline meets the upper
/// outlines of those before it, the tallest first.
///
/// charts   upright (turnUpright), at least one
/// size     of the map, in texels; at least 1
/// gutter   texels that stay free between two charts; at least 0
/// cost     O(charts · size · a chart's width) for each of up to 60 scales
/// from     Lévy, Petitjean, Ray & Maillot 2002, "Least squares conformal maps", section 4
ChartPacking packCharts(const std::vector<Chart>& charts, int size, int gutter);

}  // namespace mirrorball
