#include "mirrorball/codec/ldr/png_xmp.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <zlib.h>

#include "mirrorball/base/range.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/compressed_xmp.h"
#include "mirrorball/codec/ldr/png_chunks.h"

namespace mirrorball {
namespace {

constexpr std::string_view kXmpKeyword = "XML:com.adobe.xmp";
constexpr std::array<std::string_view, 2> kRawProfiles{"Raw profile type xmp", "Raw profile type APP1"};

/// What stands before the first 0 of some text, which is cut off with it; nothing where there is none.
std::optional<std::string_view> cutWord(std::string_view& text) {
  const std::size_t end = text.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end + 1);
  return word;
}

/// Unpacks zlib's data; empty where they are damaged or too long.
std::string inflated(std::string_view packed, UnpackingBudget& budget) {
  constexpr std::size_t kStep = UnpackingBudget::kStep;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return {};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads them
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string text;
  int result = Z_OK;
  while (result == Z_OK && budget.take(kStep)) {
    const std::size_t begin = text.size();
    text.resize(begin + kStep);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + begin);
    stream.avail_out = kStep;
    result = inflate(&stream, Z_NO_FLUSH);
    text.resize(begin + kStep - stream.avail_out);
  }
  inflateEnd(&stream);
  return result == Z_STREAM_END ? text : std::string();
}

int hexDigit(char letter) {
  constexpr std::string_view kDigits = "0123456789abcdef0123456789ABCDEF";
  const std::size_t at = kDigits.find(letter);
  return at == std::string_view::npos ? -1 : static_cast<int>(at % 16);
}

/// The bytes of ImageMagick's form: an empty line, the profile's name, how many bytes it has, and digits, two a byte.
/// Empty where there are too many.
std::string bytesOfDigits(std::string_view text, UnpackingBudget& budget) {
  constexpr int kLinesBefore = 3;
  for (int line = 0; line < kLinesBefore; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  if (!budget.take(text.size() / 2)) return {};
  std::string bytes;
  int high = -1;
  for (const char letter : text) {
    const int digit = hexDigit(letter);
    if (digit < 0) continue;  // the end of a line
    if (high >= 0) bytes.push_back(static_cast<char>(16 * high + digit));
    high = high >= 0 ? -1 : digit;
  }
  return bytes;
}

/// The text or the profile in a chunk of text, if its keyword is one under which XMP is stored.
///
/// type     of the chunk
std::string textIn(std::string_view type, std::string_view data, UnpackingBudget& budget) {
  const auto keyword = cutWord(data);
  if (!keyword) return {};
  const bool is_raw = contains(kRawProfiles, *keyword);
  if (type == "tEXt") return is_raw ? bytesOfDigits(data, budget) : std::string();
  if (*keyword != kXmpKeyword && !is_raw) return {};
  if (type == "zTXt") {
    if (data.empty() || data[0] != 0) return {};  // there is one way to compress
    const std::string text = inflated(data.substr(1), budget);
    return is_raw ? bytesOfDigits(text, budget) : text;
  }
  if (data.size() < 2 || data[0] != 1 || data[1] != 0) return {};  // what is not compressed is found as it is
  data.remove_prefix(2);
  const bool has_words = cutWord(data).has_value() && cutWord(data).has_value();  // language, translated keyword
  return has_words ? inflated(data, budget) : std::string();
}

}  // namespace

std::string compressedXmpInPng(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::string_view, 3> kTexts{"iTXt", "zTXt", "tEXt"};
  UnpackingBudget budget;
  for (std::size_t at = kPngSignature; at < bytes.size() && bytes.size() - at >= kPngChunkFrame && !budget.isSpent();) {
    const std::size_t length = bigU32(bytes.data() + at);
    if (length > bytes.size() - at - kPngChunkFrame) break;
    const auto text = [&](std::size_t begin, std::size_t size) {
      return std::string_view(reinterpret_cast<const char*>(bytes.data()) + begin, size);
    };
    const std::string_view type = text(at + 4, 4);
    if (contains(kTexts, type))
      if (std::string xmp = textIn(type, text(at + kPngChunkHead, length), budget); holdsXmp(xmp)) return xmp;
    at += length + kPngChunkFrame;
  }
  return {};
}

}  // namespace mirrorball
