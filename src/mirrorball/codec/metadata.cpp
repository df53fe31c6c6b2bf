#include "mirrorball/codec/metadata.h"

#include <algorithm>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr std::string_view kPrefix = "mirrorball:";

/// PNG keywords have at most 79 bytes, and a '=' would end the key in a comment line.
constexpr std::size_t kLongestKey = 79;

bool isPrintable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

}  // namespace

bool isMetadataKey(std::string_view key) {
  return key == "envmap" || key == kFilamentHarmonicsKey || (key.starts_with(kPrefix) && key.size() > kPrefix.size());
}

Result<void> checkMetadata(const Metadata& metadata) {
  for (const auto& [key, value] : metadata) {
    if (!isMetadataKey(key) || key.size() > kLongestKey || !isPrintable(key) ||
        key.find_first_of(" =") != std::string::npos)
      return fail(ErrorCode::usage,
                  "the metadata key '" + excerpt(key) + "' cannot be stored; use envmap, sh or mirrorball:WORD");
    if (!isPrintable(value))
      return fail(ErrorCode::usage,
                  "the metadata value of " + excerpt(key) + " cannot be stored; use printable ASCII only");
    if (key == "envmap" && value != "latlong" && value != "cube")
      return fail(ErrorCode::usage, "the metadata value envmap=" + excerpt(value) + " is unknown; use latlong or cube");
  }
  return {};
}

std::string metadataLine(const std::string& key, const std::string& value) { return key + "=" + value; }

void readMetadataLine(std::string_view line, Metadata& metadata) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || !isMetadataKey(line.substr(0, equals))) return;
  metadata[std::string(line.substr(0, equals))] = std::string(line.substr(equals + 1));
}

}  // namespace mirrorball
