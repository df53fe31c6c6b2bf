#include "mirrorball/base/text.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

#include "mirrorball/base/unicode.h"

namespace mirrorball {
namespace {

constexpr std::string_view kWhiteSpace = " \t\v\f\r\n";

/// Small letters, and '-' for '_': what is the same for indexOfName.
std::string folded(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char letter) { return letter == '_' ? '-' : static_cast<char>(std::tolower(letter)); });
  return result;
}

/// How many letters have to be put in, left out, replaced or swapped with their neighbours: Damerau's distance without
/// edits inside swapped pairs (optimal string alignment), with three rows of memory.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), last[j] + 1, row[j - 1] + 1});
      const bool is_swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

/// An option's name without its dashes.
std::string_view withoutDashes(std::string_view name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

/// How far a text is from the nearest of the parts between '-' that a word is made of; of a word of one part it is
/// nothing.
std::optional<std::size_t> distanceToPart(std::string_view text, const std::string& word) {
  std::optional<std::size_t> min;
  const std::vector<std::string> parts = split(word, '-');
  for (const std::string& part : parts)
    if (const std::size_t distance = editDistance(text, part); parts.size() > 1 && (!min || distance < *min))
      min = distance;
  return min;
}

/// Of numbers with a decimal point, whatever the program's locale is.
locale_t plainLocale() {
  static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

/// The fewest digits that read back as the same float, the nearest to it of those, of which the first stands before the
/// decimal point.
struct ShortestDigits {
  std::string digits;
  int exponent = 0;  ///< of ten
};

ShortestDigits shortestDigits(float size) {
  // Floats are twice as dense below a power of two as above it: there the decimal nearest to it may be the neighbour's,
  // and the next one its own, which is the nearest to what lies a quarter of a step above.
  const double above = size * (1.0 + 0x1p-25);
  char text[24];
  const auto readsBack = [&](int behind_point, double near) {
    std::snprintf(text, sizeof text, "%.*e", behind_point, near);
    return std::strtof(text, nullptr) == size;
  };
  for (int behind_point = 0; !readsBack(behind_point, size) && !readsBack(behind_point, above);) ++behind_point;
  const std::string_view written = text;
  const std::size_t e = written.find('e');
  ShortestDigits shortest{"", std::atoi(text + e + 1)};
  for (const char letter : written.substr(0, e))  // all but the point, which is the locale's
    if (letter >= '0' && letter <= '9') shortest.digits += letter;
  return shortest;
}

std::string fixedText(float size, const ShortestDigits& shortest) {
  const auto& [digits, exponent] = shortest;
  if (exponent < 0) return "0." + std::string(std::size_t(-exponent - 1), '0') + digits;
  const auto before_point = std::size_t(exponent) + 1;
  if (before_point < digits.size()) return digits.substr(0, before_point) + "." + digits.substr(before_point);
  char text[48];
  std::snprintf(text, sizeof text, "%.0f", size);  // all digits of a whole number
  return text;
}

std::string scientificText(const ShortestDigits& shortest) {
  const auto& [digits, exponent] = shortest;
  char end[8];
  std::snprintf(end, sizeof end, "e%+03d", exponent);
  return digits.substr(0, 1) + (digits.size() > 1 ? "." + digits.substr(1) : "") + end;
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  // strtod also takes blanks, hexadecimal digits and words.
  if (text.empty() || text.front() == '+' || text.find_first_not_of("0123456789.eE+-") != std::string_view::npos)
    return {};
  const std::string terminated(text);
  char* end = nullptr;
  errno = 0;
  const double number = ::strtod_l(terminated.c_str(), &end, plainLocale());
  const bool is_too_small = errno == ERANGE && number == 0;
  if (end != terminated.c_str() + terminated.size() || is_too_small || !std::isfinite(number)) return {};
  return number;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kWhiteSpace), text.size()));
  return text.substr(0, text.find_last_not_of(kWhiteSpace) + 1);
}

std::string_view takeWord(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(kWhiteSpace));
  text = trimmed(text.substr(word.size()));
  return word;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
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

std::string join(std::span<const std::string_view> words, std::string_view separator,
                 std::optional<std::string_view> before_last) {
  std::string joined;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) joined += i + 1 < words.size() ? separator : before_last.value_or(separator);
    joined += words[i];
  }
  return joined;
}

std::string join(std::span<const std::string> words, std::string_view separator,
                 std::optional<std::string_view> before_last) {
  return join(std::vector<std::string_view>(words.begin(), words.end()), separator, before_last);
}

std::string counted(std::uint64_t count, std::string_view noun) {
  const char* ending = count == 1 ? "" : noun.ends_with("sh") ? "es" : "s";
  return std::to_string(count) + " " + std::string(noun) + ending;
}

std::string countedAre(std::uint64_t count, std::string_view noun) {
  return counted(count, noun) + (count == 1 ? " is" : " are");
}

std::string thereAre(std::uint64_t count, std::string_view noun) {
  return (count == 1 ? "there is " : "there are ") + counted(count, noun);
}

std::string formatNumber(double number) {
  const auto short_number = static_cast<float>(number);
  const float size = std::abs(short_number);
  const std::string sign = std::signbit(short_number) ? "-" : "";
  if (!std::isfinite(size)) return sign + (std::isnan(size) ? "nan" : "inf");
  const ShortestDigits shortest = shortestDigits(size);
  const std::string fixed = fixedText(size, shortest);
  const std::string scientific = scientificText(shortest);
  const bool is_plain = size == 0.0f || (size >= 1e-4f && size < 1e9f);
  return sign + (is_plain || fixed.size() <= scientific.size() ? fixed : scientific);
}

namespace {

/// Whether it acts on a terminal instead of being shown there: controls, line separators, directions of writing.
bool isControl(char32_t point) {
  return point < 0x20 || (point >= 0x7F && point < 0xA0) || point == 0x200E || point == 0x200F ||
         (point >= 0x2028 && point <= 0x202E) || (point >= 0x2066 && point <= 0x2069);
}

/// Whether it marks the letter before it: Unicode's blocks of combining diacritical marks.
bool isMark(char32_t point) {
  constexpr struct {
    char32_t first, last;
  } kBlocks[] = {{0x300, 0x36F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x20D0, 0x20FF}, {0xFE20, 0xFE2F}};
  return std::any_of(std::begin(kBlocks), std::end(kBlocks),
                     [&](const auto& block) { return point >= block.first && point <= block.last; });
}

}  // namespace

std::size_t columnsOf(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const CodePoint point = firstCodePoint(text);
    if (!isMark(point.value)) ++columns;
    text.remove_prefix(point.bytes);
  }
  return columns;
}

std::string printable(std::string_view text) { return excerpt(text, text.size()); }

std::string excerpt(std::string_view text, std::size_t longest) {
  std::string clean;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == longest) return clean + "… (" + std::to_string(text.size()) + " bytes more)";
    const CodePoint point = firstCodePoint(text);
    clean += point.is_valid && !isControl(point.value) ? text.substr(0, point.bytes) : "?";
    text.remove_prefix(point.bytes);
  }
  return clean;
}

std::optional<std::size_t> indexOfName(std::string_view written, std::span<const std::string_view> names,
                                       std::span<const Alias> aliases) {
  std::string wanted = folded(written);
  for (const Alias& alias : aliases)
    if (wanted == folded(alias.written)) wanted = folded(alias.name);
  for (std::size_t index = 0; index < names.size(); ++index)
    if (wanted == folded(names[index])) return index;
  return std::nullopt;
}

std::optional<std::string_view> nearestWord(std::string_view text, std::span<const std::string_view> words) {
  constexpr std::size_t kMaxEdits = 3;
  constexpr std::size_t kShortestPart = 3;
  const std::string given = folded(withoutDashes(text));
  std::optional<std::string_view> nearest;
  const auto look = [&](std::size_t max_edits, const auto& distance_to) {
    std::size_t min = max_edits + 1;
    for (const std::string_view word : words) {
      const std::optional<std::size_t> distance = distance_to(folded(withoutDashes(word)));
      if (!distance || *distance >= min) continue;
      min = *distance;
      nearest = word;
    }
  };
  look(std::min((given.size() + 1) / 3, kMaxEdits),
       [&](const std::string& word) { return std::optional(editDistance(given, word)); });
  // A part says less than a whole word, and so has to be closer.
  if (!nearest && given.size() >= kShortestPart)
    look(given.size() / 5, [&](const std::string& word) { return distanceToPart(given, word); });
  return nearest;
}

Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right,
                  std::span<const Alias> aliases) {
  std::vector<std::string_view> known(right.begin(), right.end());
  for (const Alias& alias : aliases) known.push_back(alias.written);
  return unknownName(what, given, right, nearestWord(given, known));
}

Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right,
                  std::optional<std::string_view> meant) {
  std::string message = "no " + std::string(what) + " is named '" + excerpt(given) + "'";
  if (meant) message += "; did you mean '" + excerpt(*meant) + "'?";
  std::vector<std::string> shown;
  for (const std::string_view name : right) shown.push_back(excerpt(name));
  return {ErrorCode::usage, message + " (there are: " + join(shown) + ")"};
}

bool isUrl(std::string_view name) {
  return name.starts_with("https://") || name.starts_with("http://") || name.starts_with("ftp://");
}

Error downloadsNothing(std::string_view url) {
  return {ErrorCode::not_found, std::string(url) + ": nothing is downloaded; curl -L " + std::string(url) +
                                    " | mirrorball … - reads what is piped in"};
}

}  // namespace mirrorball
