#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mirrorball {

/// A code point of UTF-8, and how many bytes of a text it takes.
struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 1;
  bool is_valid = false;  ///< else the byte is not of UTF-8, or not in its place
};

/// The code point with which a text begins, which is not empty.
CodePoint firstCodePoint(std::string_view text);

/// Writes a code point at the end of a text in UTF-8; a surrogate, and what lies beyond 0x10FFFF, as U+FFFD.
void appendUtf8(std::string& text, char32_t point);

/// Whether a unit of UTF-16 is the first or the second of the two that stand for one code point.
constexpr bool isFirstOfPair(char32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
constexpr bool isSecondOfPair(char32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

/// Whether bytes are a text in UTF-16, as Notepad and PowerShell write it: of a byte-order mark and a character of
/// ASCII, or of four characters of ASCII without that mark.
bool isUtf16(std::span<const std::uint8_t> bytes);

/// What is odd about such a file, as the continuation of "NAME: ".
inline constexpr std::string_view kIsUtf16 = "is in UTF-16, and is read as the UTF-8 that it stands for";

/// How many bytes utf8FromUtf16() makes of a text: at most 3 of each 2.
///
/// cost     O(n)
std::size_t utf8Size(std::span<const std::uint8_t> bytes);

/// A text for which isUtf16() holds, in UTF-8 and without its byte-order mark; surrogates that are not a pair are
/// U+FFFD.
///
/// cost     O(n), and utf8Size() of memory
std::vector<std::uint8_t> utf8FromUtf16(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
