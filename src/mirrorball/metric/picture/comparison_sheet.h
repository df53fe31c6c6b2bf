#pragma once

#include <string>
#include <vector>

#include "mirrorball/image/image.h"
#include "mirrorball/metric/comparison.h"

namespace mirrorball {

/// Which map of a comparison is looked at.
enum class HeatMapKind {
  difference,  ///< signed: where the test is above its reference, and where below
  flip,        ///< how strongly an observer sees a difference
};

/// The picture that an image of a comparison is: of shown_test, for example.
///
/// encoded  in [0, 1], 3 channels
Image8 codesOf(const Image& encoded);

/// The heat map of a comparison: signedHeatMap or flipHeatMap.
///
/// scale    of the signed one, above 0
Image8 heatMapOf(const Comparison& comparison, HeatMapKind kind, float scale);

/// What is written on a sheet.
struct SheetText {
  std::string test;                ///< its name, which stands above it as "A: NAME"
  std::string reference;           ///< likewise, "B: NAME"
  std::string map;                 ///< what stands above the heat map
  std::vector<std::string> lines;  ///< below all
};

/// Test, reference and heat map side by side, as a display shows them, with what is known of them written below, and
/// the scale of the map's colours. Pictures narrower than 440 pixels are magnified by a whole number, as far as they
/// stay lower than 1024.
///
/// returns  3 channels, encoded
/// cost     memory of about four pictures of 3 bytes a pixel
Image8 comparisonSheet(const Comparison& comparison, HeatMapKind kind, float scale, const SheetText& text);

}  // namespace mirrorball
