#include "mirrorball/transfer/edge_padding.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

glm::ivec2 placeOf(std::size_t texel, glm::ivec2 size) { return {int(texel) % size.x, int(texel) / size.x}; }

double distanceOf(std::size_t a, std::size_t b, glm::ivec2 size) {
  return glm::length(glm::dvec2(placeOf(a, size) - placeOf(b, size)));
}

TEST(EdgePadding, TakesTheNearestToATexelAtMost) {
  const glm::ivec2 size(61, 47);
  std::vector<bool> has_value(std::size_t(size.x * size.y), false);
  for (std::size_t i = 0; i < has_value.size(); i += 97) has_value[i] = true;
  const EdgePadding padding = edgePadding(has_value, size);
  for (std::size_t i = 0; i < has_value.size(); ++i) {
    ASSERT_NE(padding.source[i], EdgePadding::kNothing);
    ASSERT_TRUE(has_value[padding.source[i]]);
    EXPECT_EQ(padding.isPadded(i), !has_value[i]);
    double nearest = 1e9;
    for (std::size_t j = 0; j < has_value.size(); j += 97) nearest = std::min(nearest, distanceOf(i, j, size));
    EXPECT_LT(distanceOf(i, padding.source[i], size), nearest + 1.0);
  }
}

TEST(EdgePadding, EndsAtItsReach) {
  const glm::ivec2 size(21, 21);
  std::vector<bool> has_value(std::size_t(size.x * size.y), false);
  has_value[10 * 21 + 10] = true;
  for (const int reach : {0, 1, 4}) {
    const EdgePadding padding = edgePadding(has_value, size, reach);
    std::size_t filled = 0;
    for (const std::uint32_t source : padding.source) filled += source != EdgePadding::kNothing ? 1u : 0u;
    EXPECT_EQ(filled, std::size_t((2 * reach + 1) * (2 * reach + 1)));
  }
}

TEST(EdgePadding, CopiesValuesAndLeavesOthers) {
  Image map(3, 1, 2, -5.0f);
  map.texel(0, 0)[0] = 1.0f;
  map.texel(0, 0)[1] = 2.0f;
  pad(map, edgePadding({true, false, false}, {3, 1}, 1));
  EXPECT_EQ(map.texel(1, 0)[0], 1.0f);
  EXPECT_EQ(map.texel(1, 0)[1], 2.0f);
  EXPECT_EQ(map.texel(2, 0)[0], -5.0f);
}

TEST(EdgePadding, OfNothingIsNothing) {
  const EdgePadding padding = edgePadding({false}, {1, 1});
  EXPECT_EQ(padding.source[0], EdgePadding::kNothing);
}

}  // namespace
}  // namespace mirrorball
