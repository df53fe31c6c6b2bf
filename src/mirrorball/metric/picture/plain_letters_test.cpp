#include "mirrorball/metric/picture/plain_letters.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(PlainLetters, AsciiStays) {
  EXPECT_EQ(plainLetters("hall_1k (2).hdr ~!"), "hall_1k (2).hdr ~!");
  EXPECT_EQ(plainLetters(""), "");
  EXPECT_TRUE(hasPlainLetters("attic"));
}

TEST(PlainLetters, LatinLettersLoseTheirMarks) {
  EXPECT_EQ(plainLetters("Zürich, Łódź, Ærø, straße, Þór, Ÿ, ŉ, ſ"), "Zurich, Lodz, AEro, strasse, Thor, Y, 'n, s");
  EXPECT_EQ(plainLetters("Œuvre “été”–‘x’…"), "OEuvre \"ete\"-'x'...");
  EXPECT_TRUE(hasPlainLetters("Zürich"));
}

// As macOS names files.
TEST(PlainLetters, MarksThatStandApartAreLeftOut) {
  EXPECT_EQ(plainLetters("Zu\xCC\x88rich"), "Zurich");
  EXPECT_TRUE(hasPlainLetters("Zu\xCC\x88rich"));
}

TEST(PlainLetters, OneQuestionMarkForEachOther) {
  EXPECT_EQ(plainLetters("夜景.hdr"), "??.hdr");
  EXPECT_EQ(plainLetters("a🌅b"), "a?b");
  EXPECT_EQ(plainLetters("a\tb\x7F"), "a?b?");
  for (const char* text : {"夜", "🌅", "\t", "\xFF"}) EXPECT_FALSE(hasPlainLetters(text)) << text;
}

TEST(PlainLetters, BytesThatAreNoUtf8AreFaults) {
  EXPECT_EQ(plainLetters("a\xFFz"), "a?z");
  EXPECT_EQ(plainLetters("a\xC3"), "a?");
  EXPECT_EQ(plainLetters("\xE2\x80"), "??");
  EXPECT_EQ(plainLetters("\xF0\x9F\x8C"), "?");
  EXPECT_EQ(plainLetters("\x80\x80x"), "??x");
}

}  // namespace
}  // namespace mirrorball
