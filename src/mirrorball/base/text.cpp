#include "mirrorball/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace mirrorball {
namespace {

/// Levenshtein's distance with one row of memory (Wagner & Fischer 1974).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return {};
  return number;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string join(std::span<const std::string_view> words, std::string_view separator) {
  std::string joined;
  for (const std::string_view word : words) {
    if (!joined.empty()) joined += separator;
    joined += word;
  }
  return joined;
}

std::string countedAre(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? " is" : "s are");
}

std::string formatNumber(double number) {
  char buffer[32];
  const auto short_number = static_cast<float>(number);
  const bool is_plain = short_number == 0.0f || (std::abs(short_number) >= 1e-4f && std::abs(short_number) < 1e9f);
  const auto [end, error] = is_plain
                                ? std::to_chars(buffer, buffer + sizeof buffer, short_number, std::chars_format::fixed)
                                : std::to_chars(buffer, buffer + sizeof buffer, short_number);
  return std::string(buffer, end);
}

std::string printable(std::string_view text) {
  constexpr char kDelete = 0x7f;
  std::string clean(text);
  std::replace_if(
      clean.begin(), clean.end(),
      [](char letter) { return (static_cast<unsigned char>(letter) < ' ') || letter == kDelete; }, '?');
  return clean;
}

std::optional<std::string_view> nearestWord(std::string_view text, std::span<const std::string_view> words) {
  std::optional<std::string_view> nearest;
  // Two letters swapped count as two edits.
  std::size_t least = std::clamp<std::size_t>(text.size() / 2, 1, 3) + 1;
  for (const std::string_view word : words) {
    const std::size_t distance = editDistance(text, word);
    if (distance < least) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right) {
  std::string message = "no " + std::string(what) + " is named '" + std::string(given) + "'";
  if (const auto nearest = nearestWord(given, right)) message += "; did you mean '" + std::string(*nearest) + "'?";
  return {ErrorCode::usage, message + " (there are: " + join(right) + ")"};
}

}  // namespace mirrorball
