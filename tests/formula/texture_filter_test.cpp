#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "formula/surface.h"

namespace mirrorball::formula {
namespace {

/// Four texels in a row, a b c d, as they are found from two rows of them before to two behind.
std::string wrapped(int wrap) {
  std::string letters;
  for (int texel = -8; texel < 12; ++texel)
    letters += "abcd"[static_cast<int>(wrappedTexel(static_cast<float>(texel), 4.0f, wrap))];
  return letters;
}

TEST(TextureFilter, WrapsAsOpenGl) {
  EXPECT_EQ(wrapped(kWrapRepeat), "abcdabcdabcdabcdabcd");
  EXPECT_EQ(wrapped(kWrapMirroredRepeat), "abcddcbaabcddcbaabcd");
  EXPECT_EQ(wrapped(kWrapClampToEdge), "aaaaaaaaabcddddddddd");
  for (const float size : {1.0f, 3.0f, 5.0f, 7.0f, 4095.0f, 16384.0f})
    for (float times = -9.0f; times < 9.0f; times += 1.0f) {
      EXPECT_EQ(wrappedTexel(times * size, size, kWrapRepeat), 0.0f) << size << " times " << times;
      EXPECT_EQ(wrappedTexel(times * size - 1.0f, size, kWrapRepeat), size - 1.0f) << size << " times " << times;
    }
}

/// A map of 64 × 64 texels that tells what is read of it: the level, and how far left and right.
struct ToldMap {
  vec2& columns;
};
ivec2 mapSize(const ToldMap&, int level) { return ivec2(64) >> level; }
vec4 fetchMap(const ToldMap& map, ivec2 texel, int level) {
  const float column = (static_cast<float>(texel.x) + 0.5f) * static_cast<float>(1 << level);
  map.columns = vec2(std::min(map.columns.x, column), std::max(map.columns.y, column));
  return vec4(static_cast<float>(level), static_cast<float>(texel.x % 2), 0.0f, 1.0f);
}

/// What a pixel of that many texels reads of the map's middle, and in which columns.
struct Reading {
  vec4 texel;
  vec2 columns;
};
Reading readingOf(float width, float height, int kind, bool magnify_nearest = false) {
  vec2 columns(64.0f, 0.0f);
  const MapSampling sampling{kWrapClampToEdge, kWrapClampToEdge, magnify_nearest};
  const vec4 texel = mapInPixel(ToldMap{columns}, vec2(0.5f), vec2(width / 64.0f, 0.0f), vec2(0.0f, height / 64.0f),
                                6.0f, sampling, kind);
  return {texel, columns};
}

TEST(TextureFilter, MipLevelsFollowThePixelsLongerSide) {
  EXPECT_FLOAT_EQ(readingOf(8.0f, 1.0f, kFilterTrilinear).texel.x, 3.0f);
  EXPECT_FLOAT_EQ(readingOf(1.0f, 8.0f, kFilterTrilinear).texel.x, 3.0f);
  EXPECT_FLOAT_EQ(readingOf(0.1f, 6.0f, kFilterTrilinear).texel.x, std::log2(6.0f));
  EXPECT_FLOAT_EQ(readingOf(1e9f, 1.0f, kFilterTrilinear).texel.x, 6.0f) << "one texel is the last level";
  for (const int kind : {kFilterNearest, kFilterBilinear}) EXPECT_EQ(readingOf(64.0f, 64.0f, kind).texel.x, 0.0f);
}

TEST(TextureFilter, ReadsLieAlongThePixelsLongerSide) {
  const Reading reading = readingOf(16.0f, 2.0f, kFilterAnisotropic);
  EXPECT_FLOAT_EQ(reading.texel.x, 1.0f) << "as wide as the shorter side";
  EXPECT_LT(reading.columns.x, 26.0f);
  EXPECT_GT(reading.columns.y, 38.0f);
  EXPECT_FLOAT_EQ(readingOf(4.0f, 4.0f, kFilterAnisotropic).texel.x, 2.0f);
  EXPECT_FLOAT_EQ(readingOf(64.0f, 1.0f, kFilterAnisotropic).texel.x, 2.0f) << "16 reads and no more";
}

TEST(TextureFilter, SquaresOfTexelsAreNearestOnlyWhereTheyAreMagnified) {
  EXPECT_EQ(readingOf(0.5f, 0.5f, kFilterTrilinear, true).columns, vec2(32.5f));
  EXPECT_EQ(readingOf(0.5f, 0.5f, kFilterTrilinear, false).columns, vec2(31.5f, 32.5f));
  EXPECT_EQ(readingOf(4.0f, 4.0f, kFilterBilinear, true).columns, vec2(31.5f, 32.5f));
  EXPECT_EQ(readingOf(4.0f, 4.0f, kFilterNearest, false).columns, vec2(32.5f));
}

TEST(TextureFilter, ReadsAreFiniteInNumber) {
  EXPECT_EQ(readsAlong(0.0f, 0.0f), 1);
  EXPECT_EQ(readsAlong(0.5f, 1e-20f), 1) << "less than a texel";
  EXPECT_EQ(readsAlong(5.0f, 2.0f), 3);
  EXPECT_EQ(readsAlong(1e30f, 1e-30f), kMostReads);
  float sum = 0.0f;
  for (int i = 0; i < 5; ++i) sum += placeOfRead(i, 5);
  EXPECT_NEAR(sum, 0.0f, 1e-6f);
  EXPECT_EQ(placeOfRead(0, 1), 0.0f);
}

}  // namespace
}  // namespace mirrorball::formula
