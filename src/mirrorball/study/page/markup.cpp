#include "mirrorball/study/page/markup.h"

#include "mirrorball/codec/format_registry.h"

namespace mirrorball {

std::string escaped(std::string_view text) {
  std::string written;
  for (const char letter : text) {
    if (letter == '&')
      written += "&amp;";
    else if (letter == '<')
      written += "&lt;";
    else if (letter == '>')
      written += "&gt;";
    else if (letter == '"')
      written += "&quot;";
    else
      written += letter;
  }
  return written;
}

std::string base64Of(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string written;
  written.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    // Three bytes are four letters; what the last lack is written as '='.
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) written += i + k <= bytes.size() ? kLetters[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return written;
}

Result<std::string> dataAddressOf(const Image8& picture) {
  MIRRORBALL_TRY(png, encodePicture(ImageFormatId::png, picture, {}));
  return "data:image/png;base64," + base64Of(png);
}

}  // namespace mirrorball
