#pragma once

#include <span>
#include <string>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// What `convert` is told beside its input.
struct ConvertOptions {
  std::string output;
  std::string to;
  std::string from;
  std::string layout = "hcross";
  int size = 0;
  bool half = false;
  bool repair = false;
};

std::span<const Option<ConvertOptions>> convertOptions();

}  // namespace mirrorball::cli
