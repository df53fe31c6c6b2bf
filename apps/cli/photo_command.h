#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// What `photo` is told beside its photographs.
struct PhotoOptions {
  std::string to = "equirect";
  int size = 0;
  std::vector<float> circle;
  std::string debug;
  float distance = 0.0f;
  float fov_deg = 0.0f;
  std::string exposures;
  int response = 0;  ///< 0: recovered, or sRGB of a single photograph; then ResponseKind + 1
  std::vector<std::string> second;
  float second_rotation_deg = 90.0f;
  std::vector<float> second_circle;
  std::string second_exposures;
  std::string max_memory;
};

std::span<const Option<PhotoOptions>> photoOptions();

}  // namespace mirrorball::cli
