#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "mirrorball/base/text.h"

namespace mirrorball::cli {

using Json = nlohmann::ordered_json;

/// A float by its shortest text: 0.1 rather than 0.10000000149; null for what is not finite.
inline Json numberOf(double value) {
  const auto shortest = parseNumber(formatNumber(value));
  return shortest ? Json(*shortest) : Json();
}

inline Json arrayOf(glm::vec3 v) { return {numberOf(double(v.x)), numberOf(double(v.y)), numberOf(double(v.z))}; }
inline Json arrayOf(glm::ivec2 v) { return {v.x, v.y}; }

/// The text that is printed: in ASCII, since a terminal would obey some characters that JSON leaves as they are. File
/// names need not be UTF-8, which JSON is.
inline std::string printedJson(const Json& json) {
  constexpr bool kAsciiAlone = true;
  return json.dump(2, ' ', kAsciiAlone, Json::error_handler_t::replace) + "\n";
}

}  // namespace mirrorball::cli
