#include "mirrorball/base/unicode.h"

#include <vector>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

std::vector<std::uint8_t> inUtf16(std::u16string_view text, bool is_big) {
  std::vector<std::uint8_t> bytes;
  for (const char16_t unit : text) {
    bytes.push_back(static_cast<std::uint8_t>(is_big ? unit >> 8 : unit & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(is_big ? unit & 0xFF : unit >> 8));
  }
  return bytes;
}

std::string fromUtf16(std::span<const std::uint8_t> bytes) {
  const std::vector<std::uint8_t> text = utf8FromUtf16(bytes);
  EXPECT_EQ(text.size(), utf8Size(bytes));
  EXPECT_EQ(text.capacity(), text.size()) << "what was asked for before it was taken";
  return {text.begin(), text.end()};
}

TEST(Unicode, Utf16OfEitherOrderBecomesUtf8) {
  for (const bool is_big : {false, true}) {
    for (const std::u16string_view mark : {u"\uFEFF", u""}) {
      const auto bytes = inUtf16(std::u16string(mark) + u"v ab\u00E9\u20AC\U0001F600\n", is_big);
      ASSERT_TRUE(isUtf16(bytes)) << is_big;
      EXPECT_EQ(fromUtf16(bytes), "v ab\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\n") << is_big;
    }
    std::u16string broken = u"\uFEFFa";
    broken += {char16_t{0xD83D}, u'b', char16_t{0xDE00}, char16_t{0xD83D}};
    auto cut = inUtf16(broken, is_big);
    cut.push_back('x');
    EXPECT_EQ(fromUtf16(cut),
              "a\xEF\xBF\xBD"
              "b\xEF\xBF\xBD\xEF\xBF\xBD")
        << "surrogates without their others";
  }
}

TEST(Unicode, OtherBytesAreNotUtf16) {
  const std::vector<std::vector<std::uint8_t>> others = {{},
                                                         {0xFF, 0xFE},
                                                         {0xFF, 0xFE, 0},
                                                         {0xFF, 0xFE, 0, 0, 'a', 0, 0, 0},
                                                         {'v', 0, 0, 0, 1, 0, 0, 0},
                                                         {'v', ' ', '1'},
                                                         {0xEF, 0xBB, 0xBF, 'v', ' ', '1', ' ', '2'},
                                                         {1, 0, 2, 0, 3, 0, 4, 0},
                                                         {0, 0, 0, 0, 0, 0, 0, 0}};
  for (const auto& bytes : others) {
    EXPECT_FALSE(isUtf16(bytes));
    EXPECT_EQ(fromUtf16(bytes), "");
  }
}

TEST(Unicode, CodePointsComeBack) {
  for (const char32_t point : {0x41, 0x7F, 0x80, 0x7FF, 0x800, 0xD7FF, 0xE000, 0xFFFD, 0x10000, 0x10FFFF}) {
    std::string text;
    appendUtf8(text, point);
    const CodePoint read = firstCodePoint(text);
    EXPECT_TRUE(read.is_valid);
    EXPECT_EQ(read.value, point);
    EXPECT_EQ(read.bytes, text.size());
  }
  for (const char32_t none : {0xD800, 0xDFFF, 0x110000}) {
    std::string text;
    appendUtf8(text, none);
    EXPECT_EQ(text, "\xEF\xBF\xBD");
  }
}

}  // namespace
}  // namespace mirrorball
