#pragma once

#include <span>
#include <string>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// The files of `render`.
struct RenderFiles {
  std::string environment = "studio";
  std::string output = "mirrorball.png";
  std::string from;
  bool repair = false;
  bool timings = false;
  std::string max_memory;
};

std::span<const Option<RenderFiles>> renderFileOptions();

}  // namespace mirrorball::cli
