#include "mirrorball/view/viewer/time_budget.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr glm::ivec2 kWindow{1280, 720};

TEST(TimeBudget, DrawsTheWholeWindowUntilItKnowsBetter) { EXPECT_EQ(TimeBudget().sizeFor(kWindow), kWindow); }

/// A driver that needs so long for each pixel, and the sizes it is asked for.
glm::ivec2 settledSize(double frame_s, double seconds_per_pixel) {
  TimeBudget budget(frame_s);
  glm::ivec2 size = kWindow;
  for (int picture = 0; picture < 40; ++picture) {
    size = budget.sizeFor(kWindow);
    budget.drew(size, seconds_per_pixel * size.x * size.y);
  }
  return size;
}

TEST(TimeBudget, HoldsTheTimeOfAFrame) {
  for (const double seconds_per_pixel : {1e-9, 2e-8, 5e-8, 6e-8}) {
    const glm::ivec2 size = settledSize(0.016, seconds_per_pixel);
    EXPECT_LE(seconds_per_pixel * size.x * size.y, 0.016) << seconds_per_pixel;
  }
  EXPECT_EQ(settledSize(0.016, 1e-9), kWindow);
  EXPECT_EQ(settledSize(0.016, 2e-8), glm::ivec2(960, 540));
}

TEST(TimeBudget, APictureStaysLargeEnoughToBeTold) {
  EXPECT_EQ(settledSize(0.016, 1e-3), glm::ivec2(640, 360));
  TimeBudget slow;
  slow.drew({100, 100}, 9.0);
  EXPECT_EQ(slow.sizeFor({320, 200}), glm::ivec2(320, 200));
  EXPECT_EQ(slow.sizeFor({3840, 2160}), glm::ivec2(960, 540));
  EXPECT_EQ(slow.sizeFor({600, 2000}), glm::ivec2(300, 1000)) << "a narrow window, too";
  EXPECT_EQ(slow.sizeFor({1, 1}), glm::ivec2(1));
}

TEST(TimeBudget, OnePictureThatWasDelayedChangesLittle) {
  TimeBudget budget;
  for (int picture = 0; picture < 10; ++picture) budget.drew(kWindow, 0.005);
  budget.drew(kWindow, 0.03);
  EXPECT_EQ(budget.sizeFor(kWindow), kWindow);
  budget.drew(kWindow, -1.0);  // a clock that was set back
  EXPECT_EQ(budget.sizeFor(kWindow), kWindow);
}

}  // namespace
}  // namespace mirrorball
