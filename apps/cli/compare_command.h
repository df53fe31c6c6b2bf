#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/metric/comparison.h"
#include "mirrorball/metric/picture/comparison_sheet.h"

namespace mirrorball::cli {

/// A value that a metric may not be worse than.
struct Threshold {
  Metric metric;
  double value;
};

/// What `compare` is told beside its inputs.
struct CompareOptions {
  std::vector<Threshold> thresholds;
  std::string heat_map;
  std::string sheet;
  HeatMapKind map = HeatMapKind::difference;
  float scale = 0.0f;
  float pixels_per_degree = kUsualPixelsPerDegree;
  Display display{0.0f, ToneMap::neutral};
  bool json = false;
  bool repair = false;
  bool resize = false;
  std::string layer;  ///< of a file of several pictures
};

std::span<const Option<CompareOptions>> compareOptions();

/// A comparison with what is told beside it.
struct ToldComparison {
  std::string test;
  std::string reference;
  CompareOptions options;
  Comparison comparison;
  float scale;  ///< of the heat map of differences
};

/// The table of metrics, a line each, without what they are indented by.
std::vector<std::string> linesOf(const ToldComparison& told);

/// JSON for programs.
std::string jsonOf(const ToldComparison& told);

}  // namespace mirrorball::cli
