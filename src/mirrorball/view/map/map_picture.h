#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/view/map/map_layout.h"
#include "mirrorball/view/map/prepared_map.h"

namespace mirrorball {

// A picture of a map in two steps: its light, which exposure, display and marks leave as it is, and what a display
// shows of it.

/// The light of a picture: of each projection what `convert` gives, of the map or, where that has more detail than the
/// picture, of one of its mip levels; from inside the mean over each pixel.
///
/// returns  of the canvas' size; 4 channels, alpha 0 (and black) where no light is shown
/// errors   interrupted (when `progress` says so); too_large
/// cost     on one core 0.5 s for the sheet of 1280 × 720 pixels, 0.4 s from inside, up to 0.4 s for one projection.
///          Bit-identical for any number of threads
Result<Image> mapLight(const PreparedMap& map, const MapViewSettings& settings, const MapCanvas& canvas,
                       const ProgressFunction& progress = {});

/// Whether two pictures have the same light.
bool haveSameLight(const MapViewSettings& a, const MapViewSettings& b);

/// What a display shows of it: tone mapped or in false colours, with marks, waveform and legend. Texts are left to the
/// face: MapLayout::labels.
///
/// light    of the map, of those settings and that canvas
/// returns  4 channels, opaque, sRGB-encoded, row 0 at the top
/// cost     up to 0.1 µs a pixel on one core
Image8 mapPicture(const PreparedMap& map, const Image& light, const MapViewSettings& settings, const MapCanvas& canvas);

/// Pictures of one map, each made of what it shares with the one before.
class MapViewer {
 public:
  explicit MapViewer(PreparedMap map) : map_(std::move(map)) {}

  const PreparedMap& map() const { return map_; }

  /// errors   mapLight's; then the next call begins it again
  Result<Image8> picture(const MapViewSettings& settings, const MapCanvas& canvas,
                         const ProgressFunction& progress = {});

 private:
  PreparedMap map_;
  MapViewSettings settings_;  // of light_
  MapCanvas canvas_;
  std::optional<Image> light_;
};

}  // namespace mirrorball
