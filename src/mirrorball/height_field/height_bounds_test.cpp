#include "mirrorball/height_field/height_bounds.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mirrorball/height_field/height_field_testing.h"

namespace mirrorball {
namespace {

using testing::kAllEdges;
using testing::surfaceAt;

constexpr glm::ivec2 kSizes[] = {{1, 1}, {1, 7}, {7, 1}, {2, 2}, {64, 64}, {37, 21}, {5, 300}};

// Rectangles anywhere, also around several tiles, against points of the surface.
TEST(HeightBounds, HoldTheSurfaceOverARectangle) {
  std::mt19937 generator(3);
  const auto random = [&](double low, double high) { return std::uniform_real_distribution(low, high)(generator); };
  for (const glm::ivec2 size : kSizes)
    for (const MapEdges edges : kAllEdges) {
      const Image heights = testing::randomHeights(size.x, size.y);
      const HeightBounds bounds = HeightBounds::make(heights, edges).value();
      for (int i = 0; i < 60; ++i) {
        const glm::dvec2 low(random(-2.0, 2.0) * size.x, random(-2.0, 2.0) * size.y);
        const glm::dvec2 sides(random(0.0, i % 3 == 0 ? 2.0 : 0.3) * size.x,
                               random(0.0, i % 4 == 0 ? 2.0 : 0.3) * size.y);
        const glm::vec2 found = bounds.over(low, low + sides);
        for (int point = 0; point < 200; ++point) {
          const glm::dvec2 place = low + sides * glm::dvec2(random(0.0, 1.0), random(0.0, 1.0));
          const double height = surfaceAt(heights, place.x, place.y, edges);
          ASSERT_GE(height, found.x - 1e-6) << size.x << "x" << size.y << " at " << place.x << ", " << place.y;
          ASSERT_LE(height, found.y + 1e-6) << size.x << "x" << size.y << " at " << place.x << ", " << place.y;
        }
      }
    }
}

// On a ramp the range is that of the rectangle and of a cell more to each side.
TEST(HeightBounds, AreNarrow) {
  Image heights(256, 256, 1);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) heights.texel(x, y)[0] = static_cast<float>(x) / 255.0f;
  const HeightBounds bounds = HeightBounds::make(heights, MapEdges::clamped).value();
  for (const float side : {2.5f, 9.0f, 40.0f}) {
    const glm::vec2 found = bounds.over({60.0f, 20.0f}, {60.0f + side, 20.0f + side});
    const float cell = std::max(2.0f, side / 4.0f);
    EXPECT_GE(found.x, (60.0f - cell) / 255.0f) << side;
    EXPECT_LE(found.y, (60.0f + side + 1.0f + cell) / 255.0f) << side;
  }
}

TEST(HeightBounds, WithoutAMapAreThoseOfAllHeights) {
  EXPECT_EQ(HeightBounds().over({3.0f, 4.0f}, {5.0f, 6.0f}), glm::vec2(0.0f, 1.0f));
}

}  // namespace
}  // namespace mirrorball
