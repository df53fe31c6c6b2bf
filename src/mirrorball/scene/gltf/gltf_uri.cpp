#include "mirrorball/scene/gltf/gltf_uri.h"

#include <cstddef>
#include <cstdint>
#include <optional>

#include "mirrorball/base/text.h"

namespace mirrorball::gltf {
namespace {

constexpr std::string_view kDataScheme = "data:";

/// What a letter of base64 stands for; 64 of any other. '-' and '_' are those of addresses (RFC 4648, section 5).
std::uint32_t base64Digit(char letter) {
  if (letter >= 'A' && letter <= 'Z') return static_cast<std::uint32_t>(letter - 'A');
  if (letter >= 'a' && letter <= 'z') return static_cast<std::uint32_t>(letter - 'a' + 26);
  if (letter >= '0' && letter <= '9') return static_cast<std::uint32_t>(letter - '0' + 52);
  if (letter == '+' || letter == '-') return 62;
  if (letter == '/' || letter == '_') return 63;
  return 64;
}

/// With or without padding.
std::optional<Bytes> decodeBase64(std::string_view text) {
  constexpr std::string_view kIgnored = " \t\r\n=";
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  std::size_t letters = 0;
  for (const char letter : text) {
    if (kIgnored.find(letter) != std::string_view::npos) continue;
    const std::uint32_t digit = base64Digit(letter);
    if (digit == 64) return {};
    ++letters;
    bits = (bits << 6 | digit) & 0xFFFFFF;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  if (letters % 4 == 1) return {};
  return bytes;
}

}  // namespace

bool isData(std::string_view uri) { return lowerCase(uri.substr(0, kDataScheme.size())) == kDataScheme; }

Result<Bytes> decodeData(const std::string& uri, const std::string& key) {
  constexpr std::string_view kBase64 = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos) return fail(ErrorCode::bad_file, key + " is data without a comma before its bytes");
  const std::string_view data = std::string_view(uri).substr(comma + 1);
  if (!lowerCase(trimmed(uri.substr(0, comma))).ends_with(kBase64)) {
    const std::string bytes = percentDecoded(data);
    return Bytes(bytes.begin(), bytes.end());
  }
  std::optional<Bytes> bytes = decodeBase64(data);
  if (!bytes) return fail(ErrorCode::bad_file, key + " is no base64 data: '" + excerpt(uri) + "'");
  return std::move(*bytes);
}

std::string percentDecoded(std::string_view text) {
  const auto digit = [](char letter) {
    if (letter >= '0' && letter <= '9') return letter - '0';
    if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
    if (letter >= 'A' && letter <= 'F') return letter - 'A' + 10;
    return -1;
  };
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      decoded += static_cast<char>(digit(text[i + 1]) * 16 + digit(text[i + 2]));
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

}  // namespace mirrorball::gltf
