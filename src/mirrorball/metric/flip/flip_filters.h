#pragma once

#include <vector>

namespace mirrorball::flip {

/// A filter of one direction: its weights from −radius to radius.
using Filter = std::vector<float>;

/// FLIP's filters for one density of pixels, each of which is applied along x and along y.
struct Filters {
  int spatial_radius = 0;
  int feature_radius = 0;
  // The contrast sensitivity of the eye: of the achromatic channel and of red against green one Gaussian each, of blue
  // against yellow the sum of two, which are filtered by themselves and added.
  Filter achromatic;
  Filter red_green;
  Filter blue_yellow_narrow;
  Filter blue_yellow_wide;
  // What finds edges and points: a Gaussian and its first and second derivative.
  Filter smooth;
  Filter edge;
  Filter point;

  int radius() const;
};

/// pixels_per_degree  at least kMinPixelsPerDegree (flip.h)
/// from               Andersson et al. 2020, sections 4.1.1 and 4.2 with table 1; separated as in the note "Separated
///                    Convolutions" of the published program
Filters filtersFor(float pixels_per_degree);

}  // namespace mirrorball::flip
