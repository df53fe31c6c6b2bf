#include "mirrorball/height_field/slope_moments.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/range.h"
#include "mirrorball/height_field/height_field_testing.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

using testing::kAllEdges;
using testing::randomHeights;

constexpr glm::ivec2 kMomentSizes[] = {{1, 1}, {1, 7}, {9, 1}, {64, 64}, {37, 21}, {13, 70}};

glm::vec4 texelOf(const Image& image, int x, int y) {
  const float* const texel = image.texel(x, y);
  return {texel[0], texel[1], texel[2], texel[3]};
}

// A texel has the mean of the slopes that it covers, and how far they are from it.
TEST(SlopeMoments, AreThoseOfTheSlopesBelowATexel) {
  for (const MapEdges edges : kAllEdges) {
    constexpr int kSide = 32, kLevel = 2, kCovered = 1 << kLevel;
    const Image heights = randomHeights(kSide, kSide);
    const SlopeMoments moments = slopeMoments(heights, edges).value();
    const Image slopes = derivativesFromHeights(heights, {.edges = edges}).value();  // as steep as per texture width
    for (int y = 0; y < kSide / kCovered; ++y)
      for (int x = 0; x < kSide / kCovered; ++x) {
        glm::dvec2 sum(0.0), squares(0.0);
        for (int i = 0; i < kCovered * kCovered; ++i) {
          const float* const slope = slopes.texel(kCovered * x + i % kCovered, kCovered * y + i / kCovered);
          sum += glm::dvec2(slope[0], slope[2]);
          squares += glm::dvec2(slope[0] * slope[0], slope[2] * slope[2]);
        }
        const glm::dvec2 mean = sum / double(kCovered * kCovered);
        const glm::dvec2 variance = squares / double(kCovered * kCovered) - mean * mean;
        const glm::vec4 found = texelOf(moments.levels.at(kLevel, 0), x, y);
        const double unit = moments.unit;
        EXPECT_NEAR(found.x * unit, mean.x, 1e-4 * unit);
        EXPECT_NEAR(found.y * unit, mean.y, 1e-4 * unit);
        EXPECT_NEAR(found.z * unit * unit, variance.x, 1e-4 * unit * unit);
        EXPECT_NEAR(found.w * unit * unit, variance.y, 1e-4 * unit * unit);
      }
  }
}

TEST(SlopeMoments, WithoutFinestLevelsAreTheOthers) {
  for (const glm::ivec2 size : kMomentSizes)
    for (const MapEdges edges : kAllEdges) {
      const Image heights = randomHeights(size.x, size.y);
      const SlopeMoments all = slopeMoments(heights, edges).value();
      for (int finest = 1; finest < all.levels.levels(); ++finest) {
        const SlopeMoments some = slopeMoments(heights, edges, finest).value();
        EXPECT_EQ(some.unit, all.unit);
        ASSERT_EQ(some.levels.levels(), all.levels.levels() - finest);
        for (int level = 0; level < some.levels.levels(); ++level)
          EXPECT_TRUE(areEqual(some.levels.at(level, 0).samples(), all.levels.at(finest + level, 0).samples()))
              << size.x << "x" << size.y << " without " << finest << ", level " << level;
      }
    }
}

TEST(SlopeMoments, AskForTheirMemoryFirst) {
  const std::uint64_t limit = memoryLimit();
  setMemoryLimit(5'000'000);
  const Image heights(512, 512, 1);
  EXPECT_FALSE(slopeMoments(heights));
  EXPECT_TRUE(slopeMoments(heights, MapEdges::tiled, 1));
  setMemoryLimit(limit);
}

}  // namespace
}  // namespace mirrorball
