#pragma once

#include <vector>

#include "mirrorball/environment/environment.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball::testing {

inline Environment litFromAbove() {
  return Environment([](glm::vec3 d) { return glm::vec3(1.0f + d.y, 1.0f, 0.5f); }, 32);
}

inline FrameSettings smallFrame(int samples = 1) {
  return {.size = {24, 24}, .samples = samples, .resolve = Resolve::radiance};
}

inline std::vector<float> pictureOf(View& view, const FrameSettings& settings) {
  const Image image = drawn(view, settings);
  return {image.samples().begin(), image.samples().end()};
}

}  // namespace mirrorball::testing
