#include "mirrorball/codec/color/hex_color.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(HexColor, ComesBackAsItWasWritten) {
  for (const char* text : {"#000000", "#ffffff", "#0a0b0c", "#336699", "#fe8001"})
    EXPECT_EQ(hexColor(*parseHexColor(text)), text);
  EXPECT_EQ(hexColor(*parseHexColor("#ABCDEF")), "#abcdef");
}

TEST(HexColor, OtherTextsAreNone) {
  for (const char* text : {"", "#", "336699", "#33669", "#3366999", "#33669g", "# 36699", "#-12345", "red"})
    EXPECT_FALSE(parseHexColor(text)) << text;
  EXPECT_TRUE(isHexCode("336699"));
  EXPECT_FALSE(isHexCode("#336699"));
}

TEST(HexColor, LightOutsideOfADisplayIsClamped) { EXPECT_EQ(hexColor({2.0f, -1.0f, 1.0f}), "#ff00ff"); }

}  // namespace
}  // namespace mirrorball
