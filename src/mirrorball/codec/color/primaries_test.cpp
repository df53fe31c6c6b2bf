#include "mirrorball/codec/color/primaries.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

void expectNear(glm::vec3 actual, glm::vec3 expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 2e-4f) << "component " << c;
}

TEST(Primaries, Rec709AndNoneNeedNothing) {
  EXPECT_FALSE(rec709FromPrimaries(kRec709));
  EXPECT_FALSE(rec709FromPrimaries(Primaries{}));
  EXPECT_FALSE(rec709FromPrimaries({{0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}}));
}

TEST(Primaries, Rec2020GivesThePublishedMatrix) {
  const auto matrix = rec709FromPrimaries(kRec2020);
  ASSERT_TRUE(matrix);
  // ITU-R BT.2087-0 gives the inverse; these are the columns of BT.2407-0, eq. 4.
  expectNear((*matrix)[0], {1.6605f, -0.1246f, -0.0182f});
  expectNear((*matrix)[1], {-0.5876f, 1.1329f, -0.1006f});
  expectNear((*matrix)[2], {-0.0728f, -0.0083f, 1.1187f});
}

TEST(Primaries, WhiteStaysWhiteUnderAnotherWhitePoint) {
  const auto matrix = rec709FromPrimaries(kAcesAp0);
  ASSERT_TRUE(matrix);
  expectNear(*matrix * glm::vec3(1.0f), glm::vec3(1.0f));
}

TEST(Primaries, AlphaIsNotTransformed) {
  Image image(2, 1, 4, 0.5f);
  transformColors(image, glm::mat3(2.0f));
  EXPECT_EQ(image.samples()[4], 1.0f);
  EXPECT_EQ(image.samples()[7], 0.5f);
}

TEST(Primaries, GreyHasNone) {
  Image image(2, 1, 1, 0.5f);
  convertToRec709(image, kRec2020);
  EXPECT_EQ(image.samples()[1], 0.5f);
}

// An XYZ file's sample (x, y, z) is the colour of that tristimulus value, white adapted: D65's own has to become white.
TEST(Primaries, CieXyzAreTristimulusValues) {
  const auto matrix = rec709FromPrimaries(kCieXyz);
  ASSERT_TRUE(matrix);
  expectNear(*matrix * glm::vec3(1.0f), glm::vec3(1.0f));
}

TEST(DescribeColor, NamesWhatIsWellKnown) {
  const std::pair<Primaries, const char*> known[] = {{kRec2020, "Rec.2020"},
                                                     {kDisplayP3, "Display P3"},
                                                     {kDciP3, "DCI-P3"},
                                                     {kAdobeRgb, "Adobe RGB"},
                                                     {kAcesAp0, "ACES AP0"},
                                                     {kAcesAp1, "ACES AP1"},
                                                     {kCieXyz, "CIE XYZ"},
                                                     {kRec601Of625Lines, "BT.601, 625 lines"},
                                                     {kRec601Of525Lines, "BT.601, 525 lines"}};
  for (const auto& [primaries, name] : known)
    EXPECT_EQ(describeColor(kLinearLight, primaries, 3),
              "linear, primaries of the file (" + std::string(name) + "): converted");
  Primaries rounded = kAcesAp1;
  rounded.white = {0.3217, 0.3377};
  EXPECT_EQ(describeColor(kLinearLight, rounded, 3), "linear, primaries of the file (ACES AP1): converted");
}

TEST(DescribeColor, WritesOutWhatIsNot) {
  EXPECT_EQ(describeColor(kLinearLight, Primaries{{0.61, 0.33}, {0.2, 0.7}, {0.1, 0.05}, {0.3333333, 0.3333333}}, 4),
            "linear, primaries of the file (red 0.61 0.33, green 0.2 0.7, blue 0.1 0.05, white 0.3333 0.3333): "
            "converted");
}

TEST(DescribeColor, SaysWhenNothingWasConverted) {
  EXPECT_EQ(describeColor(kLinearLight, {}, 3), "linear, Rec.709");
  EXPECT_EQ(describeColor(kLinearLight, kRec709, 3), "linear, Rec.709");
  EXPECT_EQ(describeColor(kLinearLight, Primaries{}, 3), "linear, Rec.709 assumed: the file's primaries are none");
  EXPECT_EQ(describeColor(kLinearLight, kRec2020, 1), "linear, grey");
  EXPECT_EQ(describeColor(kSrgbCurve, kRec709, 3), "sRGB");
  EXPECT_EQ(describeColor({1.8}, {}, 3), "gamma 1.8, Rec.709");
}

}  // namespace
}  // namespace mirrorball
