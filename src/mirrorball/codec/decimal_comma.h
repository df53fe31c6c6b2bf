#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "mirrorball/base/text.h"

namespace mirrorball {

/// Parses "1,5" as 1.5: programs write their user's decimal comma into headers that have points. Nothing where the text
/// has no comma, several, or a point as well.
inline std::optional<double> parseDecimalComma(std::string_view text) {
  if (std::count(text.begin(), text.end(), ',') != 1 || text.find('.') != std::string_view::npos) return {};
  std::string with_point(text);
  with_point[with_point.find(',')] = '.';
  return parseNumber(with_point);
}

}  // namespace mirrorball
