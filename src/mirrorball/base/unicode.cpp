#include "mirrorball/base/unicode.h"

#include <iterator>
#include <optional>

namespace mirrorball {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr char32_t kMark = 0xFEFF;

bool isSurrogate(char32_t point) { return point >= 0xD800 && point < 0xE000; }

/// Units of 16 bits in one of both orders.
class Utf16 {
 public:
  Utf16(std::span<const std::uint8_t> bytes, bool is_big) : bytes_(bytes), is_big_(is_big) {}

  std::size_t size() const { return bytes_.size() / 2; }
  char32_t at(std::size_t index) const {
    const std::uint32_t first = bytes_[2 * index], second = bytes_[2 * index + 1];
    return is_big_ ? first << 8 | second : second << 8 | first;
  }
  /// Whether there is a letter, a sign or white space of ASCII.
  bool isAscii(std::size_t index) const {
    const char32_t unit = index < size() ? at(index) : 0;
    return (unit >= 0x20 && unit < 0x7F) || unit == '\t' || unit == '\n' || unit == '\r';
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool is_big_;
};

/// The units of such a text, its mark among them; nothing for other bytes.
std::optional<Utf16> findUnits(std::span<const std::uint8_t> bytes) {
  for (const bool is_big : {false, true}) {
    const Utf16 units(bytes, is_big);
    if (units.size() > 1 && units.at(0) == kMark && units.isAscii(1)) return units;
    if (units.isAscii(0) && units.isAscii(1) && units.isAscii(2) && units.isAscii(3)) return units;
  }
  return std::nullopt;
}

/// Calls `take` with each code point of such a text but its mark.
template <typename Take>
void forEachPoint(const Utf16& units, Take take) {
  for (std::size_t i = units.at(0) == kMark ? 1 : 0; i < units.size(); ++i) {
    char32_t point = units.at(i);
    if (isFirstOfPair(point) && i + 1 < units.size() && isSecondOfPair(units.at(i + 1)))
      point = 0x10000 + ((point - 0xD800) << 10) + (units.at(++i) - 0xDC00);
    take(point);
  }
}

/// How many bytes appendUtf8() writes.
std::size_t sizeInUtf8(char32_t point) { return point < 0x80 ? 1 : point < 0x800 ? 2 : point < 0x10000 ? 3 : 4; }

template <typename Text>
void append(Text& text, char32_t point) {
  if (point > 0x10FFFF || isSurrogate(point)) point = kReplacement;
  const auto put = [&](char32_t byte) {
    text.push_back(static_cast<typename Text::value_type>(static_cast<unsigned char>(byte)));
  };
  const auto putRest = [&](int shift) { put(0x80 | (point >> shift & 0x3F)); };
  if (point < 0x80) {
    put(point);
  } else if (point < 0x800) {
    put(0xC0 | point >> 6);
    putRest(0);
  } else if (point < 0x10000) {
    put(0xE0 | point >> 12);
    putRest(6);
    putRest(0);
  } else {
    put(0xF0 | point >> 18);
    putRest(12);
    putRest(6);
    putRest(0);
  }
}

}  // namespace

CodePoint firstCodePoint(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1, true};
  // Of two, three and four bytes: what marks the first, and the least value that is not written shorter.
  constexpr struct {
    unsigned char mask, mark;
    char32_t least;
  } kForms[] = {{0xE0, 0xC0, 0x80}, {0xF0, 0xE0, 0x800}, {0xF8, 0xF0, 0x10000}};
  for (std::size_t form = 0; form < std::size(kForms); ++form) {
    const auto& [mask, mark, least] = kForms[form];
    const std::size_t count = form + 2;
    if ((first & mask) != mark || text.size() < count) continue;
    char32_t value = first & static_cast<unsigned char>(~mask);
    for (std::size_t i = 1; i < count; ++i) {
      if ((byte(i) & 0xC0) != 0x80) return {};
      value = value << 6 | (byte(i) & 0x3Fu);
    }
    if (value < least || value > 0x10FFFF || isSurrogate(value)) return {};
    return {value, count, true};
  }
  return {};
}

void appendUtf8(std::string& text, char32_t point) { append(text, point); }

bool isUtf16(std::span<const std::uint8_t> bytes) { return findUnits(bytes).has_value(); }

std::size_t utf8Size(std::span<const std::uint8_t> bytes) {
  std::size_t size = 0;
  if (const std::optional<Utf16> units = findUnits(bytes))
    forEachPoint(*units, [&](char32_t point) { size += sizeInUtf8(point); });
  return size;
}

std::vector<std::uint8_t> utf8FromUtf16(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> text;
  const std::optional<Utf16> units = findUnits(bytes);
  if (!units) return text;
  text.reserve(utf8Size(bytes));
  forEachPoint(*units, [&](char32_t point) { append(text, point); });
  return text;
}

}  // namespace mirrorball
