#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/render/frame/frame_settings.h"

namespace mirrorball::cli {

/// What `capture` is told beside its scene (scene_inputs.h), its files (map_output.h) and how things look.
struct CaptureOptions {
  std::vector<float> at;
  std::string to;
  int size = 0;
  float nearest = 0.0f;
};

std::span<const Option<CaptureOptions>> captureOptions();

/// The options of `render` that say what a scene looks like, without those that say how a picture of it is taken.
std::span<const Option<FrameSettings>> captureLookOptions();

}  // namespace mirrorball::cli
