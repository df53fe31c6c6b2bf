#include "mirrorball/metric/picture/plain_letters.h"

#include <array>
#include <cstddef>
#include <optional>

namespace mirrorball {
namespace {

constexpr unsigned kFirstLatin = 0xC0, kEndOfLatin = 0x180;

/// Of the code points from U+00C0 to U+017F.
constexpr std::array<std::string_view, kEndOfLatin - kFirstLatin> kLatin{
    "A", "A", "A",  "A",  "A", "A", "AE", "C", "E", "E",  "E", "E", "I", "I", "I",  "I",   //
    "D", "N", "O",  "O",  "O", "O", "O",  "x", "O", "U",  "U", "U", "U", "Y", "Th", "ss",  //
    "a", "a", "a",  "a",  "a", "a", "ae", "c", "e", "e",  "e", "e", "i", "i", "i",  "i",   //
    "d", "n", "o",  "o",  "o", "o", "o",  "/", "o", "u",  "u", "u", "u", "y", "th", "y",   //
    "A", "a", "A",  "a",  "A", "a", "C",  "c", "C", "c",  "C", "c", "C", "c", "D",  "d",   //
    "D", "d", "E",  "e",  "E", "e", "E",  "e", "E", "e",  "E", "e", "G", "g", "G",  "g",   //
    "G", "g", "G",  "g",  "H", "h", "H",  "h", "I", "i",  "I", "i", "I", "i", "I",  "i",   //
    "I", "i", "IJ", "ij", "J", "j", "K",  "k", "k", "L",  "l", "L", "l", "L", "l",  "L",   //
    "l", "L", "l",  "N",  "n", "N", "n",  "N", "n", "'n", "N", "n", "O", "o", "O",  "o",   //
    "O", "o", "OE", "oe", "R", "r", "R",  "r", "R", "r",  "S", "s", "S", "s", "S",  "s",   //
    "S", "s", "T",  "t",  "T", "t", "T",  "t", "U", "u",  "U", "u", "U", "u", "U",  "u",   //
    "U", "u", "U",  "u",  "W", "w", "Y",  "y", "Y", "Z",  "z", "Z", "z", "Z", "z",  "s"};

/// A code point, and how many bytes it takes.
struct Letter {
  unsigned point;
  std::size_t bytes;
};

/// The first code point of a text that is not empty, as far as it is below U+10000; nothing: it is another, or its
/// first byte is not UTF-8.
std::optional<Letter> firstLetter(std::string_view text) {
  const auto bits = [&](std::size_t at, unsigned mask) { return static_cast<unsigned char>(text[at]) & mask; };
  const auto goesOn = [&](std::size_t at) { return at < text.size() && bits(at, 0xC0u) == 0x80u; };
  if (bits(0, 0x80u) == 0) return Letter{bits(0, 0x7Fu), 1};
  if (bits(0, 0xE0u) == 0xC0u && goesOn(1)) return Letter{bits(0, 0x1Fu) << 6 | bits(1, 0x3Fu), 2};
  if (bits(0, 0xF0u) == 0xE0u && goesOn(1) && goesOn(2))
    return Letter{bits(0, 0x0Fu) << 12 | bits(1, 0x3Fu) << 6 | bits(2, 0x3Fu), 3};
  return std::nullopt;
}

/// How many bytes belong together where firstLetter finds nothing.
std::size_t otherBytes(std::string_view text) {
  const bool begins_four = (static_cast<unsigned char>(text[0]) & 0xF8u) == 0xF0u;
  std::size_t bytes = 1;
  while (begins_four && bytes < 4 && bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0u) == 0x80u)
    ++bytes;
  return bytes;
}

/// What stands for a code point beyond ASCII; nothing: it has none.
std::optional<std::string_view> plain(unsigned point) {
  if (point >= kFirstLatin && point < kEndOfLatin) return kLatin[point - kFirstLatin];
  if (point >= 0x300 && point < 0x370) return "";  // marks on the letter before them
  switch (point) {
    case 0xA0:  // a space that does not break
      return " ";
    case 0x2010:
    case 0x2011:
    case 0x2012:
    case 0x2013:
    case 0x2014:
      return "-";
    case 0x2018:
    case 0x2019:
      return "'";
    case 0x201C:
    case 0x201D:
      return "\"";
    case 0x2026:
      return "...";
    default:
      return std::nullopt;
  }
}

/// The plain letters of a text, and whether all of it had some.
struct Plain {
  std::string letters;
  bool is_whole = true;
};

Plain inPlainLetters(std::string_view text) {
  Plain result;
  while (!text.empty()) {
    const std::optional<Letter> letter = firstLetter(text);
    const bool is_ascii = letter && letter->point >= ' ' && letter->point <= '~';
    const std::optional<std::string_view> other = letter && !is_ascii ? plain(letter->point) : std::nullopt;
    if (is_ascii)
      result.letters += static_cast<char>(letter->point);
    else
      result.letters += other.value_or("?");
    result.is_whole = result.is_whole && (is_ascii || other);
    text.remove_prefix(letter ? letter->bytes : otherBytes(text));
  }
  return result;
}

}  // namespace

std::string plainLetters(std::string_view text) { return inPlainLetters(text).letters; }

bool hasPlainLetters(std::string_view text) { return inPlainLetters(text).is_whole; }

}  // namespace mirrorball
