#pragma once

#include <span>
#include <string>

#include "mirrorball/base/option.h"

namespace mirrorball::cli {

/// The files of `render` beside those of its scene (scene_inputs.h).
struct RenderFiles {
  std::string output = "mirrorball.png";
};

std::span<const Option<RenderFiles>> renderFileOptions();

}  // namespace mirrorball::cli
