#include "mirrorball/codec/numbered_paths.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

/// Where a file name has a picture's number: "%04d" as printf has it, or at least two "#", a digit each.
struct NumberPlace {
  std::size_t begin;
  std::size_t length;
  std::size_t digits;
};

/// The place that begins at `at`, or none.
std::optional<NumberPlace> numberPlaceAt(std::string_view path, std::size_t at) {
  const auto isDigit = [&](std::size_t i) { return i < path.size() && path[i] >= '0' && path[i] <= '9'; };
  const std::size_t hashes = std::min(path.find_first_not_of('#', at), path.size()) - at;
  if (hashes >= 2) return NumberPlace{at, hashes, hashes};
  if (path[at] != '%') return std::nullopt;
  std::size_t after = at + 1;
  std::size_t digits = 1;
  if (path.substr(after).starts_with('0') && isDigit(after + 1)) {
    const std::size_t first = after + 1;
    after = isDigit(first + 1) ? first + 2 : first + 1;
    digits = static_cast<std::size_t>(std::stoul(std::string(path.substr(first, after - first))));
  }
  if (!path.substr(after).starts_with('d')) return std::nullopt;
  return NumberPlace{at, after + 1 - at, digits};
}

std::vector<NumberPlace> numberPlaces(const std::string& path) {
  std::vector<NumberPlace> places;
  const std::size_t name = path.find_last_of('/') == std::string::npos ? 0 : path.find_last_of('/') + 1;
  for (std::size_t at = name; at < path.size();) {
    const auto place = numberPlaceAt(path, at);
    if (place) places.push_back(*place);
    at += place ? place->length : 1;
  }
  return places;
}

}  // namespace

bool hasNumberPlace(const std::string& path) { return !numberPlaces(path).empty(); }

Result<std::vector<std::string>> numberedPaths(const std::string& output, int count) {
  std::string name = output;
  if (!hasNumberPlace(name)) {
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(count - 1).size());
    name = suffixed(name, "_" + std::string(digits, '#'));
  }
  const std::vector<NumberPlace> places = numberPlaces(name);
  if (places.size() != 1)
    return fail(ErrorCode::usage,
                output + ": has " + std::to_string(places.size()) + " places for a picture's number; leave one");
  std::vector<std::string> paths;
  for (int picture = 0; picture < count; ++picture) {
    std::string number = std::to_string(picture);
    if (number.size() < places[0].digits) number.insert(0, places[0].digits - number.size(), '0');
    paths.push_back(std::string(name).replace(places[0].begin, places[0].length, number));
  }
  return paths;
}

}  // namespace mirrorball
