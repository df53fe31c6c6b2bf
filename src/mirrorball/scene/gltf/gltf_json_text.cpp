#include "mirrorball/scene/gltf/gltf_json_text.h"

#include <array>
#include <cstddef>

namespace mirrorball::gltf {
namespace {

constexpr std::array<std::string_view, 3> kWords{"-Infinity", "Infinity", "NaN"};

/// The end of the string that begins at `at`, behind its closing quote.
std::size_t endOfString(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return at + 1;
}

}  // namespace

std::optional<std::string> withoutNan(std::string_view json) {
  std::string plain;
  std::size_t copied = 0;
  for (std::size_t at = 0; at < json.size();) {
    if (json[at] == '"') {
      at = endOfString(json, at);
      continue;
    }
    std::size_t length = 0;
    for (const std::string_view word : kWords)
      if (json.substr(at).starts_with(word)) length = word.size();
    if (length > 0) {
      plain.append(json.substr(copied, at - copied)).append("null");
      copied = at + length;
    }
    at += length > 0 ? length : 1;
  }
  if (copied == 0) return {};
  return plain.append(json.substr(copied));
}

}  // namespace mirrorball::gltf
