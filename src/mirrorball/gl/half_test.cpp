#include "mirrorball/gl/half.h"

#include <cmath>
#include <limits>
#include <vector>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

namespace mirrorball::gl {
namespace {

std::uint16_t half(float value) {
  std::uint16_t result = 0;
  halvesFromFloats(std::span(&value, 1), std::span(&result, 1));
  return result;
}

TEST(HalvesFromFloats, EveryHalfComesBackFromItsFloat) {
  for (unsigned bits = 0; bits <= 0xffffu; ++bits) {
    const auto expected = static_cast<std::uint16_t>(bits);
    if ((expected & 0x7c00u) == 0x7c00u) continue;  // infinities and NaN
    ASSERT_EQ(half(glm::unpackHalf1x16(expected)), expected);
  }
}

TEST(HalvesFromFloats, RoundsToTheNearestAndTiesToEven) {
  for (unsigned bits = 0; bits < 0x7bffu; ++bits) {
    const auto below = static_cast<std::uint16_t>(bits);
    const auto above = static_cast<std::uint16_t>(bits + 1);
    const float middle = (glm::unpackHalf1x16(below) + glm::unpackHalf1x16(above)) / 2.0f;
    ASSERT_EQ(half(std::nextafter(middle, 0.0f)), below);
    ASSERT_EQ(half(middle), bits % 2 == 0 ? below : above);
    ASSERT_EQ(half(std::nextafter(middle, 1e6f)), above);
  }
}

TEST(HalvesFromFloats, ClampsWhatIsTooBright) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(half(65504.0f), 0x7bff);
  EXPECT_EQ(half(65519.0f), 0x7bff);
  EXPECT_EQ(half(1e30f), 0x7bff);
  EXPECT_EQ(half(kInfinity), 0x7bff);
  EXPECT_EQ(half(-kInfinity), 0xfbff);
  EXPECT_EQ(half(std::numeric_limits<float>::quiet_NaN()) & 0x7fff, 0x7bff);
}

}  // namespace
}  // namespace mirrorball::gl
