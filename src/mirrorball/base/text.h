#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Parses a whole text as one number, independent of the locale. Infinity and NaN are refused.
std::optional<double> parseNumber(std::string_view text);

/// Splits at every `separator`; "a,,b" has three parts, "" has one.
std::vector<std::string> split(std::string_view text, char separator);

/// "a, b, c"
std::string join(std::span<const std::string_view> words, std::string_view separator = ", ");

/// "1 texel is", "3 texels are"
std::string countedAre(std::size_t count, std::string_view noun);

/// The shortest text that reads back as the same float: "0.3", "1000000", "1e-07".
std::string formatNumber(double number);

/// A foreign file's text as it may stand in a message: one line, with '?' for every control character.
std::string printable(std::string_view text);

/// The word nearest to `text` by edit distance, if one is near enough to be a slip of the finger.
std::optional<std::string_view> nearestWord(std::string_view text, std::span<const std::string_view> words);

/// The error for a name that is not in a list: names the thing, suggests the nearest and lists the right ones.
///
/// what     what the name should name, as in "material"
Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right);

}  // namespace mirrorball
