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

TEST(TextureFilter, ThePixelsLongerSideChoosesTheLevel) {
  EXPECT_EQ(lodOfTexels(vec2(0.1f, 0.0f), vec2(0.0f, 0.1f)), 0.0f);
  EXPECT_EQ(lodOfTexels(vec2(0.0f, 8.0f), vec2(1.0f, 0.0f)), 3.0f);
  EXPECT_FLOAT_EQ(lodOfTexels(vec2(1.0f, 0.0f), vec2(6.0f, 8.0f)), std::log2(10.0f));
}

}  // namespace
}  // namespace mirrorball::formula
