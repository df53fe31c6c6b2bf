#include "mirrorball/metric/picture/comparison_sheet.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/metric/flip/flip_testing.h"
#include "mirrorball/metric/picture/lettering.h"

namespace mirrorball {
namespace {

int countOf(const Image8& picture, int code) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) count += picture.texel(x, y)[0] == code ? 1 : 0;
  return count;
}

TEST(Lettering, DrawsLettersWhereItIsTold) {
  Image8 picture(60, 20, 3);
  drawText(picture, {5, 3}, 1, {255, 255, 255}, "I");
  EXPECT_GT(countOf(picture, 255), 5);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 60; ++x)
      if (x < 5 || x >= 5 + textWidth("I", 1) || y < 3 || y >= 3 + lineHeight(1)) {
        ASSERT_EQ(picture.texel(x, y)[0], 0) << x << ", " << y;
      }
}

TEST(Lettering, ScalesByWholePixels) {
  Image8 small(200, 20, 3);
  Image8 large(600, 60, 3);
  drawText(small, {0, 0}, 1, {255, 255, 255}, "FLIP 0.5");
  drawText(large, {0, 0}, 3, {255, 255, 255}, "FLIP 0.5");
  EXPECT_EQ(countOf(large, 255), 9 * countOf(small, 255));
  EXPECT_EQ(textWidth("FLIP 0.5", 3), 3 * textWidth("FLIP 0.5", 1));
}

TEST(Lettering, LeavesOutWhatLiesBesideAndKnowsOnlyAscii) {
  Image8 picture(10, 10, 3);
  drawText(picture, {-20, -5}, 4, {255, 255, 255}, "WWW\n\x01");
  drawText(picture, {8, 8}, 4, {255, 255, 255}, "WWW");
  EXPECT_EQ(textWidth("süß 光", 1), textWidth("suss ?", 1));
  EXPECT_EQ(textWidth("", 1), 0);
  EXPECT_EQ(textWidth("iii", 1), textWidth("WWW", 1)) << "columns stand below each other";
  std::string all;
  for (char letter = ' '; letter <= '~'; ++letter) all += letter;
  Image8 letters(2000, 20, 3);
  drawText(letters, {0, 0}, 1, {255, 255, 255}, all);
  EXPECT_GT(countOf(letters, 255), 1000) << "every letter has its strokes";
  EXPECT_LT(textWidth(all, 1), 2000);
}

Comparison comparisonOf(int width, int height) {
  return *compareImages({testing::flipTest(width, height), {}}, {testing::flipReference(width, height), {}},
                        ImageKind::picture);
}

TEST(ComparisonSheet, HasTheThreePicturesAsTheyAre) {
  const Comparison comparison = comparisonOf(450, 50);
  const Image8 sheet = comparisonSheet(comparison, HeatMapKind::flip, 1.0f, {"A", "B", "C", {"RMSE 1"}});
  const Image8 map = heatMapOf(comparison, HeatMapKind::flip, 1.0f);
  ASSERT_EQ(sheet.width(), 3 * 450 + 4 * 8);
  const int top = 8 + lineHeight(2);
  for (int x = 0; x < 450; ++x)
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(sheet.texel(8 + x, top + 20)[channel],
                int(comparison.shown_test.texel(x, 20)[channel] * 255.0f + 0.5f));
      EXPECT_EQ(sheet.texel(8 + 458 + x, top + 20)[channel],
                int(comparison.shown_reference.texel(x, 20)[channel] * 255.0f + 0.5f));
      EXPECT_EQ(sheet.texel(8 + 916 + x, top + 20)[channel], map.texel(x, 20)[channel]);
    }
}

TEST(ComparisonSheet, SmallPicturesAreMagnifiedUnlessTheyAreTall) {
  const SheetText text{"A", "B", "C", {"RMSE 1"}};
  EXPECT_GT(comparisonSheet(comparisonOf(1, 1), HeatMapKind::difference, 1.0f, text).height(), 440);
  EXPECT_EQ(comparisonSheet(comparisonOf(1, 1), HeatMapKind::difference, 1.0f, text).width(), 3 * 440 + 4 * 8);
  const int tall = comparisonSheet(comparisonOf(1, 1000), HeatMapKind::flip, 1.0f, text).height();
  EXPECT_GT(tall, 1000);
  EXPECT_LT(tall, 1200);
}

TEST(ComparisonSheet, LongNamesAreCutAndLongLinesGoOnInTheNext) {
  const Comparison comparison = comparisonOf(20, 20);
  const std::string word(1000, 'W');
  const auto sheetOf = [&](const SheetText& text) {
    return comparisonSheet(comparison, HeatMapKind::flip, 1.0f, text);
  };
  const std::vector<std::string> four(4, "RMSE");
  const Image8 usual = sheetOf({"A", "B", "C", four});
  const Image8 named = sheetOf({word, word, "C", four});
  EXPECT_EQ(named.width(), usual.width());
  EXPECT_EQ(named.height(), usual.height());
  const Image8 one_more =
      sheetOf({"A", "B", "C", {"", "", "", "of the picture as it is, and so on, " + std::string(50, 'W')}});
  EXPECT_EQ(one_more.height(), usual.height() + lineHeight(2));
  EXPECT_GT(sheetOf({"A", "B", "C", {word}}).height(), usual.height() + 10 * lineHeight(2))
      << "where there is no space it breaks anywhere";
}

}  // namespace
}  // namespace mirrorball
