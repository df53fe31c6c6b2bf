#include "mirrorball/metric/picture/heat_map.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/metric/picture/color_ramp.h"

namespace mirrorball {
namespace {

glm::ivec3 codesAt(const Image8& map, int x) { return {map.texel(x, 0)[0], map.texel(x, 0)[1], map.texel(x, 0)[2]}; }
glm::ivec3 codesOf(glm::vec3 color) { return glm::ivec3(color * 255.0f + 0.5f); }

TEST(HeatMap, SignedDifferencesHaveTheFullColourAtTheScale) {
  Image difference(5, 1, 1);
  const float numbers[] = {-9.0f, -2.0f, 0.0f, 1.0f, 2.0f};
  for (int x = 0; x < 5; ++x) *difference.texel(x, 0) = numbers[x];
  const Image8 map = signedHeatMap(difference, 2.0f);
  EXPECT_EQ(codesAt(map, 0), codesOf(divergingColor(-1.0f)));
  EXPECT_EQ(codesAt(map, 1), codesAt(map, 0)) << "more is not shown";
  EXPECT_EQ(codesAt(map, 2), codesOf(divergingColor(0.0f)));
  EXPECT_EQ(codesAt(map, 3), codesOf(divergingColor(0.5f)));
  EXPECT_EQ(codesAt(map, 4), codesOf(divergingColor(1.0f)));
}

TEST(HeatMap, FlipHasTheSequentialRamp) {
  Image flip(3, 1, 1);
  *flip.texel(1, 0) = 0.5f;
  *flip.texel(2, 0) = 1.0f;
  const Image8 map = flipHeatMap(flip);
  EXPECT_EQ(codesAt(map, 0), codesOf(sequentialColor(0.0f)));
  EXPECT_EQ(codesAt(map, 1), codesOf(sequentialColor(0.5f)));
  EXPECT_EQ(codesAt(map, 2), codesOf(sequentialColor(1.0f)));
}

TEST(HeatMap, TheUsualScaleIsARoundNumberThatFewExceed) {
  Image difference(100, 20, 1);
  EXPECT_EQ(usualScale(difference), 1.0f) << "nothing differs";
  for (int x = 0; x < 100; ++x) *difference.texel(x, 0) = x % 2 == 0 ? 0.3f : -0.4f;
  EXPECT_FLOAT_EQ(usualScale(difference), 0.5f);
  for (int x = 0; x < 100; ++x) *difference.texel(x, 0) = 0.05f;
  EXPECT_FLOAT_EQ(usualScale(difference), 0.05f) << "a round number is its own";
  *difference.texel(0, 0) = 1e5f;
  EXPECT_FLOAT_EQ(usualScale(difference), 0.05f) << "one sun alone does not hide the rest";
  Image rounding(100, 20, 1, 1e-6f);
  EXPECT_FLOAT_EQ(usualScale(rounding), 1e-6f);
  *rounding.texel(9, 9) = 0.2f;
  EXPECT_FLOAT_EQ(usualScale(rounding), 0.2f) << "what is seen counts, where there is some";
  Image huge(1, 1, 1, -3e38f);
  EXPECT_GE(usualScale(huge), 3e38f);
  EXPECT_TRUE(std::isfinite(usualScale(huge)));
  Image tiny(1, 1, 1, 1e-44f);
  EXPECT_GT(usualScale(tiny), 0.0f);
}

}  // namespace
}  // namespace mirrorball
