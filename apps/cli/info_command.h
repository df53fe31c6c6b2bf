#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// What `info` is told beside its inputs.
struct InfoOptions {
  std::vector<float> direction;
  bool json = false;
  std::string from;
  std::string max_memory;
};

std::span<const Option<InfoOptions>> infoOptions();

}  // namespace mirrorball::cli
