#include "mirrorball/codec/color/coded_color.h"

#include <vector>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// The light of grey codes.
float lightOfGrey(float code, const CodedColor& color) {
  Image image(1, 1, 3, code);
  decodeColor(image, color);
  EXPECT_NEAR(image.texel(0, 0)[1], image.texel(0, 0)[0], 1e-3f * image.texel(0, 0)[0]);
  return image.texel(0, 0)[0];
}

// Levels of ITU-R BT.2408-7, table 1, and the ends of the scales.
TEST(CodedColor, PqIsAbsoluteLight) {
  const CodedColor pq = codedColor(9, 16);
  EXPECT_EQ(pq.transfer, Transfer::pq);
  EXPECT_NEAR(lightOfGrey(0.58f, pq), 1.0f, 0.01f) << "graphics white";
  EXPECT_NEAR(lightOfGrey(0.38f, pq), 26.0f / 203.0f, 0.005f) << "an 18 % grey card";
  EXPECT_NEAR(lightOfGrey(1.0f, pq), 10000.0f / 203.0f, 0.01f);
  EXPECT_EQ(lightOfGrey(0.0f, pq), 0.0f);
  EXPECT_NEAR(lightOfGrey(2.0f, pq), 10000.0f / 203.0f, 0.01f) << "there is nothing beyond";
}

TEST(CodedColor, HlgIsThatOfADisplay) {
  const CodedColor hlg = codedColor(9, 18);
  EXPECT_NEAR(lightOfGrey(0.75f, hlg), 1.0f, 0.01f) << "graphics white";
  EXPECT_NEAR(lightOfGrey(0.38f, hlg), 26.0f / 203.0f, 0.005f);
  EXPECT_NEAR(lightOfGrey(1.0f, hlg), 1000.0f / 203.0f, 0.01f);
  EXPECT_EQ(lightOfGrey(0.0f, hlg), 0.0f);
}

TEST(CodedColor, OtherCurvesAndUnknownNumbers) {
  EXPECT_NEAR(lightOfGrey(0.5f, codedColor(1, 13)), 0.2140f, 1e-3f);
  EXPECT_NEAR(lightOfGrey(0.5f, codedColor(1, 1)), 0.2596f, 1e-3f);
  EXPECT_NEAR(lightOfGrey(0.5f, codedColor(1, 4)), 0.2176f, 1e-3f);
  EXPECT_EQ(lightOfGrey(7.0f, codedColor(1, 8)), 7.0f);
  for (const int number : {-1, 0, 2, 3, 19, 255, 65536})
    EXPECT_EQ(codedColor(number, number).transfer, Transfer::srgb) << number;
  EXPECT_FALSE(codedColor(2, 2).primaries);
}

TEST(CodedColor, PrimariesAreConvertedAndAlphaStays) {
  Image red(1, 1, 4, 0.0f);
  red.texel(0, 0)[0] = 1.0f;
  red.texel(0, 0)[3] = 0.5f;
  decodeColor(red, codedColor(12, 8));
  EXPECT_NEAR(red.texel(0, 0)[0], 1.2249f, 1e-3f);
  EXPECT_NEAR(red.texel(0, 0)[1], -0.0421f, 1e-3f);
  EXPECT_EQ(red.texel(0, 0)[3], 0.5f);
  Image grey(1, 1, 1, 0.75f);
  decodeColor(grey, codedColor(9, 18));
  EXPECT_NEAR(grey.texel(0, 0)[0], 1.0f, 0.01f);
}

TEST(CodedColor, IsDescribed) {
  EXPECT_EQ(describeColor(codedColor(1, 13), 3), "sRGB");
  EXPECT_EQ(describeColor(codedColor(9, 16), 3), "PQ, primaries of the file (Rec.2020): converted");
  EXPECT_EQ(describeColor(codedColor(1, 18), 4), "HLG, Rec.709");
  EXPECT_EQ(describeColor(codedColor(12, 13), 3), "sRGB, primaries of the file (Display P3): converted");
  EXPECT_EQ(describeColor(codedColor(1, 1), 3), "Rec.709's curve, Rec.709");
}

}  // namespace
}  // namespace mirrorball
