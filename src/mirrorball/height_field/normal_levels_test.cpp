#include "mirrorball/height_field/normal_levels.h"

#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "formula/surface.h"

namespace mirrorball {
namespace {

template <typename Normal>
Image8 mapOf(int width, int height, const Normal& normal) {
  Image8 map(width, height, 4, 7);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec3 n = glm::normalize(glm::vec3(normal(x, y)));
      for (int axis = 0; axis < 3; ++axis)
        map.texel(x, y)[axis] = static_cast<std::uint8_t>(std::lround(255.0f * (0.5f + 0.5f * n[axis])));
    }
  return map;
}

glm::vec3 meanOf(const Image8& level, int x, int y) {
  const std::uint8_t* const texel = level.texel(x, y);
  return glm::vec3(texel[0], texel[1], texel[2]) * (2.0f / 255.0f) - 1.0f;
}

float varianceOf(const Image8& level, int x, int y) {
  return formula::spreadOfAlpha(static_cast<float>(level.texel(x, y)[3]) / 255.0f, 1.0f);
}

void expectNoSpread(const Image8& level) {
  for (int y = 0; y < level.height(); ++y)
    for (int x = 0; x < level.width(); ++x) EXPECT_EQ(level.texel(x, y)[3], 255) << x << ", " << y;
}

TEST(NormalLevels, TheFirstLevelIsThePictureWithoutItsAlpha) {
  const Image8 map = mapOf(4, 2, [](int x, int y) { return glm::vec3(x, y, 3); });
  const auto levels = normalLevels(map, 127.5f);
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels[1].width(), 2);
  EXPECT_EQ(levels[2].width(), 1);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(meanOf(levels[0], x, 1), meanOf(map, x, 1));
  expectNoSpread(levels[0]);
}

// However the 8 bits round it.
TEST(NormalLevels, FlatMapsHaveNoSpread) {
  for (int tilt = 0; tilt < 50; ++tilt) {
    const Image8 map = mapOf(8, 8, [tilt](int, int) { return glm::vec3(0.037f * float(tilt), -0.2f, 1.0f); });
    for (const Image8& level : normalLevels(map, 127.5f)) expectNoSpread(level);
  }
}

// A mirror shows it as one: where neighbours differ by a step of 8 bits, it is that which makes the steps.
TEST(NormalLevels, WhatEightBitsScatterIsNoSpread) {
  const Image8 map =
      mapOf(64, 64, [](int x, int y) { return glm::vec3(2e-4f * float(x) + 0.1f, 3e-4f * float(y) - 0.2f, 1.0f); });
  expectNoSpread(normalLevels(map, 127.5f)[1]);
  expectNoSpread(normalLevels(map, 127.5f)[2]);
}

TEST(NormalLevels, KeepTheVarianceOfSlopes) {
  for (const float slope : {0.05f, 0.1f, 0.3f, 0.6f}) {
    const Image8 map = mapOf(16, 16, [slope](int x, int y) {
      return glm::vec3(x % 2 == 0 ? slope : -slope, y % 2 == 0 ? slope : -slope, 1.0f);
    });
    const auto levels = normalLevels(map, 127.5f);
    for (std::size_t level = 1; level < levels.size(); ++level) {
      // Along one direction; a normal's mean knows less of those that lie flat.
      const float variance = varianceOf(levels[level], 0, 0);
      EXPECT_NEAR(std::sqrt(variance), slope, 0.01f + 0.3f * slope * slope) << level;
      EXPECT_NEAR(meanOf(levels[level], 0, 0).x, 0.0f, 0.01f);
    }
  }
}

TEST(NormalLevels, TexelsWithoutADirectionDoNotCount) {
  Image8 map = mapOf(4, 4, [](int, int) { return glm::vec3(0.3f, 0.2f, 1.0f); });
  for (int y = 0; y < 4; ++y)
    for (int x = 1; x < 4; ++x)
      for (int axis = 0; axis < 3; ++axis) map.texel(x, y)[axis] = 127;
  const auto levels = normalLevels(map, 127.5f);
  for (std::size_t level = 1; level < levels.size(); ++level) {
    expectNoSpread(levels[level]);
    EXPECT_LT(glm::distance(meanOf(levels[level], 0, 0), meanOf(map, 0, 0)), 0.01f);
  }
  EXPECT_LT(glm::length(meanOf(levels[1], 1, 1)), 0.05f);
}

// Of texels that are stored short the direction counts, not the length.
TEST(NormalLevels, LengthsDoNotCount) {
  Image8 map = mapOf(2, 1, [](int, int) { return glm::vec3(0.0f, 0.0f, 1.0f); });
  map.texel(1, 0)[2] = 192;
  const auto levels = normalLevels(map, 127.5f);
  expectNoSpread(levels[1]);
  EXPECT_GT(meanOf(levels[1], 0, 0).z, 0.99f);
}

TEST(NormalLevels, OddSizesEndInOneTexel) {
  const auto levels = normalLevels(mapOf(5, 3, [](int, int) { return glm::vec3(0, 0, 1); }), 127.5f);
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels[1].width(), 2);
  EXPECT_EQ(levels[1].height(), 1);
  EXPECT_EQ(levels[2].width(), 1);
}

}  // namespace
}  // namespace mirrorball
