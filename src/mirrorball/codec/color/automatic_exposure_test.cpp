#include "mirrorball/codec/color/automatic_exposure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

Image grey(float value, glm::ivec2 size = {40, 20}) { return {size.x, size.y, 3, value}; }

void set(Image& image, int x, int y, float value) { std::fill_n(image.texel(x, y), 3, value); }

TEST(AutomaticExposure, EvenLightBecomesMiddleGrey) {
  for (const float value : {1e-6f, 0.18f, 1.0f, 4000.0f})
    EXPECT_NEAR(value * std::exp2(automaticExposure(grey(value))), 0.18f, 1e-4f) << value;
}

TEST(AutomaticExposure, ASunDoesNotDarkenTheRest) {
  Image image = grey(1.0f);
  const float without = automaticExposure(image);
  set(image, 3, 3, 1e5f);
  EXPECT_NEAR(automaticExposure(image), without, 0.05f);
}

// One texel in twenty is a lamp; of the dark around it nothing would be worth a white picture.
TEST(AutomaticExposure, LampsInTheDarkStayWithinWhatIsShown) {
  Image image = grey(1e-5f);
  for (int x = 0; x < 40; ++x) set(image, x, 7, 100.0f);
  EXPECT_NEAR(100.0f * std::exp2(automaticExposure(image)), 16.0f, 0.1f);
}

TEST(AutomaticExposure, WhatHasNoLightDoesNotCount) {
  Image image = grey(0.0f);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 40; ++x) set(image, x, y, 2.0f);
  for (int x = 0; x < 40; ++x) set(image, x, 15, -3.0f);
  set(image, 0, 19, std::numeric_limits<float>::quiet_NaN());
  set(image, 1, 19, std::numeric_limits<float>::infinity());
  EXPECT_NEAR(2.0f * std::exp2(automaticExposure(image)), 0.18f, 1e-4f);
}

TEST(AutomaticExposure, IsFiniteOfWhateverThereIs) {
  EXPECT_EQ(automaticExposure(grey(0.0f)), 0.0f);
  EXPECT_EQ(automaticExposure(grey(-1.0f)), 0.0f);
  EXPECT_EQ(automaticExposure(grey(std::numeric_limits<float>::max())), -30.0f);
  EXPECT_EQ(automaticExposure(grey(std::numeric_limits<float>::denorm_min())), 30.0f);
  EXPECT_NEAR(automaticExposure(grey(0.18f, {1, 1})), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace mirrorball
