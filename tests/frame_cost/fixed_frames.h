#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "mirrorball/render/frame/render_inputs.h"

namespace mirrorball::testing {

/// A frame whose cost is watched. Never changed but by a new row, so that its costs can be compared over the years.
struct FixedFrame {
  std::string_view name;
  std::string_view environment;                              ///< a built-in
  Result<Scene> (*scene)();                                  ///< what is drawn
  std::vector<std::pair<const char*, const char*>> options;  ///< of the command line: "refraction", "image-space"
};

/// Mirror, rough metal, glass, relief, a load of textured meshes as a helmet has them, and a small showcase.
std::span<const FixedFrame> fixedFrames();

/// A renderer of it, and its settings.
///
/// errors   as rendererOf's and those of options
Result<Renderer> rendererOf(const FixedFrame& frame, FrameSettings& settings);

}  // namespace mirrorball::testing
