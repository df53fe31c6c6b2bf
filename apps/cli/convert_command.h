#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/image/filter.h"

namespace mirrorball::cli {

/// What `convert` is told beside its inputs and its files (map_output.h).
struct ConvertOptions {
  std::string to;
  std::string from;
  int size = 0;
  Interpolation filter = Interpolation::bicubic;
  std::vector<float> rotate_deg;
  std::vector<float> centre;
  std::string extension;
  bool repair = false;
  std::string max_memory;
  float exposure_ev = 0.0f;
  ToneMap tone_map = ToneMap::linear;
};

std::span<const Option<ConvertOptions>> convertOptions();

}  // namespace mirrorball::cli
