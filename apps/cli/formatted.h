#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

#include <glm/vec3.hpp>

namespace mirrorball::cli {

/// As printf writes it.
template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)), '\0');
  std::snprintf(text.data(), text.size() + 1, format, values...);
  return text;
}

/// A number, or three, with the digits that a reader wants.
inline std::string shortText(double number) { return formatted("%.5g", number); }
inline std::string shortText(glm::vec3 v) { return formatted("%.5g %.5g %.5g", double(v.x), double(v.y), double(v.z)); }

}  // namespace mirrorball::cli
