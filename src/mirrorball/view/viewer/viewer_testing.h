#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/view/viewer/viewer.h"

namespace mirrorball::testing {

constexpr glm::ivec2 kViewerSize{96, 64};

class ViewerTest : public HeadlessTest {
 protected:
  static Device device() { return *Device::on(*gl::Context::adoptCurrent()); }
};

/// Lets time go on until nothing is left to do.
inline void finish(Viewer& viewer) {
  constexpr int kMost = 200'000;
  for (int step = 0; step < kMost && !viewer.isDone(); ++step) {
    const auto drawn = viewer.advance(0.01);
    ASSERT_TRUE(drawn) << drawn.error().message;
    if (!viewer.status().loading.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(viewer.isDone());
}

/// How many pixels of some columns are other than those of a picture.
inline int differing(const Image8& a, const Image8& b, int begin, int end) {
  int differ = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = begin; x < end; ++x) differ += std::equal(a.texel(x, y), a.texel(x, y) + 3, b.texel(x, y)) ? 0 : 1;
  return differ;
}

}  // namespace mirrorball::testing
