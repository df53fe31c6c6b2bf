// The largest screens.

#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::finish;

/// The most that the process has ever had in memory [bytes].
double peakBytes() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

class ViewerLargePictureLongTest : public testing::ViewerTest {};

TEST_F(ViewerLargePictureLongTest, EightThousandPixelsAreDrawnAndSavedInBoundedMemory) {
  constexpr glm::ivec2 kSize{7680, 4320};
  // With a driver in the processor's memory: colours, sums and depths of the viewer's picture and of the one that is
  // saved, and what leaves them: 54 on llvmpipe.
  constexpr double kMostBytesOfAPixel = 70.0;
  const std::string path = ::testing::TempDir() + "eight_thousand.png";
  Workspace workspace;
  workspace.model = "sphere";
  workspace.maps = {"white"};
  workspace.frame = {{"samples", {"1"}}, {"quality", {"draft"}}};
  const double before = peakBytes();
  Viewer viewer(device(), workspace, kSize);
  finish(viewer);
  const glm::ivec2 drawn = viewer.status().sides[0].size_px;
  EXPECT_EQ(drawn, kSize) << drawn.x << " x " << drawn.y;
  viewer.savePicture({.path = path, .size_px = kSize});
  while (!viewer.status().saving.empty()) {
    ASSERT_TRUE(viewer.advance(0.01));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(viewer.status().saved_last, "wrote " + path);
  EXPECT_LE(peakBytes() - before, kMostBytesOfAPixel * kSize.x * kSize.y);

  const auto bytes = readFile(path);
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto saved = decodeTexture(*bytes);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(testing::differing(*saved, *viewer.picture(), 0, kSize.x), 0);
}

}  // namespace
}  // namespace mirrorball
