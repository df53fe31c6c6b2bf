#include "mirrorball/height_field/maximum_pyramid.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/height_field/height_field_testing.h"

namespace mirrorball {
namespace {

using testing::heightAt;
using testing::kAllEdges;
using testing::randomHeights;

// What the header says of a cell, in its own words.
TEST(MaximumPyramid, EveryCellIsTheMaximumOfItsPatches) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 7}, {7, 1}, {2, 2}, {64, 64}, {37, 21}, {100, 33}, {3, 129}})
    for (const MapEdges edges : kAllEdges) {
      const Image heights = randomHeights(size.x, size.y);
      const ImageSet pyramid = maximumPyramid(heights, edges).value();
      for (int level = 0; level < pyramid.levels(); ++level) {
        const Image& cells = pyramid.at(level, 0);
        ASSERT_EQ(glm::ivec2(cells.width(), cells.height()),
                  glm::ivec2(levelSide(size.x, level), levelSide(size.y, level)));
        Image expected(cells.width(), cells.height(), 1, -1.0f);
        for (int j = 0; j < size.y; ++j)
          for (int i = 0; i < size.x; ++i) {
            float& cell =
                expected.texel(std::min(i >> level, cells.width() - 1), std::min(j >> level, cells.height() - 1))[0];
            cell = std::max({cell, heightAt(heights, i, j, edges), heightAt(heights, i + 1, j, edges),
                             heightAt(heights, i, j + 1, edges), heightAt(heights, i + 1, j + 1, edges)});
          }
        for (int y = 0; y < cells.height(); ++y)
          for (int x = 0; x < cells.width(); ++x)
            ASSERT_EQ(cells.texel(x, y)[0], expected.texel(x, y)[0])
                << x << ", " << y << " of level " << level << " of " << size.x << "x" << size.y;
      }
      const Image& top = pyramid.at(pyramid.levels() - 1, 0);
      EXPECT_EQ(top.texelCount(), 1u);
      EXPECT_EQ(top.samples()[0], *std::max_element(heights.samples().begin(), heights.samples().end()));
    }
}

TEST(MaximumPyramid, NaNIsNamedAndWorkStops) {
  Image heights(8, 4, 1);
  heights.texel(7, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  const auto bad = maximumPyramid(heights);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message, "1 texel is NaN or infinite, the first at (7, 3)");
  const auto stopped = maximumPyramid(Image(64, 64, 1), {}, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
