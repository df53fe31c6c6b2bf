#include "mirrorball/codec/color/icc_profile.h"

#include <algorithm>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// Four letters as the number that they stand for in a profile.
constexpr std::uint32_t letters(const char (&text)[5]) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(text[i]);
  return number;
}

/// The number at `at`, 0 behind the end.
std::uint32_t numberAt(Span bytes, std::size_t at) {
  return at <= bytes.size() && bytes.size() - at >= 4 ? bigU32(bytes.data() + at) : 0;
}

/// As much of the range as lies within the bytes.
Span clipped(Span bytes, std::size_t begin, std::size_t size) {
  begin = std::min(begin, bytes.size());
  return bytes.subspan(begin, std::min(size, bytes.size() - begin));
}

/// The value of a tag, empty where there is none.
Span tagValue(Span profile, std::uint32_t signature) {
  constexpr std::size_t kHeader = 128;
  constexpr std::size_t kRow = 12;  // signature, offset, size
  const std::size_t begin = kHeader + 4;
  const std::size_t rows = profile.size() < begin ? 0 : (profile.size() - begin) / kRow;
  const std::size_t count = std::min<std::size_t>(numberAt(profile, kHeader), rows);
  for (std::size_t at = begin; at < begin + count * kRow; at += kRow)
    if (numberAt(profile, at) == signature)
      return clipped(profile, numberAt(profile, at + 4), numberAt(profile, at + 8));
  return {};
}

}  // namespace

std::string iccDescription(Span profile) {
  const Span value = tagValue(profile, letters("desc"));
  const std::uint32_t type = numberAt(value, 0);
  std::string name;
  if (type == letters("desc")) {
    for (const std::uint8_t letter : clipped(value, 12, numberAt(value, 8))) name += static_cast<char>(letter);
  } else if (type == letters("mluc")) {
    // The first language's, in UTF-16.
    const Span text = clipped(value, numberAt(value, 24), numberAt(value, 20));
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) name += text[i] == 0 ? static_cast<char>(text[i + 1]) : '?';
  }
  name = excerpt(name.substr(0, name.find('\0')));
  std::replace_if(
      name.begin(), name.end(), [](char letter) { return letter < 0; }, '?');
  return name.empty() ? "unnamed" : name;
}

std::string describeIccColor(const std::string& description) {
  if (description.starts_with("sRGB")) return "sRGB";
  return "sRGB assumed: its ICC profile (" + description + ") is not applied";
}

}  // namespace mirrorball
