#pragma once

#include <cstddef>
#include <vector>

#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/image.h"
#include "mirrorball/view/map/map_layout.h"

namespace mirrorball {

/// How luminance is spread in each column of a panorama: shares of the column's solid angle by stops, whatever the
/// exposure. What is black has none.
class Waveform {
 public:
  static constexpr int kFirstStop = -32;
  static constexpr int kStops = 64;
  static constexpr int kBinsPerStop = 8;

  Waveform() = default;
  /// panorama   equirect, finite
  /// cost       a logarithm of each texel; bit-identical for any number of threads
  explicit Waveform(const EnvironmentMap& panorama);

  int columns() const { return columns_; }

  /// The share of some columns, in the mean, that lies from `begin` to before `end` stops: 0 … 1. Within a bin it
  /// counts as spread evenly.
  ///
  /// first, last   columns, both counted
  float share(int first, int last, float begin, float end) const;

 private:
  static constexpr int kBins = kStops * kBinsPerStop;
  float sumBelow(int column, float stops) const;

  int columns_ = 0;
  std::vector<float> sums_;  // of each column, kBins + 1: the share that lies in the bins before
};

/// Draws a waveform: columns from left to right, stops after the exposure from −range below to +range above, the
/// brighter the more of a column lies there; with lines at 0 and at each fourth stop.
void drawWaveform(const Waveform& waveform, const PixelRectangle& place, float exposure_ev, float range,
                  Image8& picture);

}  // namespace mirrorball
