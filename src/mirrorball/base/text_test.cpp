#include "mirrorball/base/text.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;

TEST(ParseNumber, TakesWholeTextsOnly) {
  EXPECT_EQ(parseNumber("1.5"), 1.5);
  EXPECT_EQ(parseNumber("+2e3"), 2000.0);
  EXPECT_EQ(parseNumber("-0.25"), -0.25);
  for (const char* wrong : {"", "1,5", "1.5x", " 1", "nan", "inf", "1e999", "--1"})
    EXPECT_FALSE(parseNumber(wrong)) << wrong;
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_THAT(split("a,,b", ','), ElementsAre("a", "", "b"));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(CountedAre, AgreesWithTheNumber) {
  EXPECT_EQ(countedAre(1, "texel"), "1 texel is");
  EXPECT_EQ(countedAre(0, "texel"), "0 texels are");
  EXPECT_EQ(countedAre(12, "texel"), "12 texels are");
}

TEST(FormatNumber, ReadsBackAsTheSameFloat) {
  for (const float number : {0.1f, 1.0f / 3.0f, 65504.0f, 1e-20f})
    EXPECT_EQ(static_cast<float>(*parseNumber(formatNumber(number))), number);
}

TEST(Printable, LeavesNoControlCharacter) {
  EXPECT_EQ(printable("R\nG\x1b[31m\x7f"), "R?G?[31m?");
  EXPECT_EQ(printable("grün"), "grün");
}

TEST(UnknownName, SuggestsTheNearestAndListsAll) {
  constexpr std::array<std::string_view, 3> kNames{"mirror", "chrome", "gold"};
  EXPECT_EQ(nearestWord("miror", kNames), "mirror");
  EXPECT_EQ(nearestWord("zzzzzz", kNames), std::nullopt);
  EXPECT_EQ(unknownName("material", "glod", kNames).message,
            "no material is named 'glod'; did you mean 'gold'? (there are: mirror, chrome, gold)");
}

}  // namespace
}  // namespace mirrorball
