#include "mirrorball/codec/color/hex_color.h"

#include <cstddef>

#include <glm/glm.hpp>

#include "formula/color.h"

namespace mirrorball {

bool isHexCode(std::string_view text) {
  return text.size() == 6 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

std::optional<glm::vec3> parseHexColor(std::string_view text) {
  if (text.empty() || text[0] != '#' || !isHexCode(text.substr(1))) return std::nullopt;
  const unsigned long bits = std::stoul(std::string(text.substr(1)), nullptr, 16);
  const glm::vec3 encoded((bits >> 16) & 255u, (bits >> 8) & 255u, bits & 255u);
  return formula::linearFromSrgb(encoded / 255.0f);
}

std::string hexColor(glm::vec3 linear) {
  const glm::ivec3 codes(glm::round(glm::clamp(formula::srgbFromLinear(linear), 0.0f, 1.0f) * 255.0f));
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (int channel = 0; channel < 3; ++channel) {
    text += kDigits[static_cast<std::size_t>(codes[channel] / 16)];
    text += kDigits[static_cast<std::size_t>(codes[channel] % 16)];
  }
  return text;
}

}  // namespace mirrorball
