#include "mirrorball/scene/mesh_file/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// Digits as a decimal number has them.
struct Decimal {
  bool is_negative = false;
  std::uint64_t digits = 0;  // the first 19, without the zeros before them
  int exponent = 0;          // of ten
  bool is_whole = true;      // no digit was left out
  bool has_comma = false;
};

/// The digits after an 'e', of which no more are looked at than a number of doubles can need.
std::optional<int> readExponent(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty()) return {};
  int exponent = 0;
  for (const char letter : text) {
    if (!isDigit(letter)) return {};
    exponent = std::min(10 * exponent + (letter - '0'), 100'000);
  }
  return is_negative ? -exponent : exponent;
}

/// Nothing where the word is not a decimal number.
std::optional<Decimal> readDecimal(std::string_view word) {
  constexpr std::uint64_t kMostDigits = 1'000'000'000'000'000'000;
  Decimal decimal;
  std::size_t at = 0;
  if (at < word.size() && (word[at] == '-' || word[at] == '+')) decimal.is_negative = word[at++] == '-';
  bool has_digits = false, behind_point = false;
  for (; at < word.size(); ++at) {
    const char letter = word[at];
    if (isDigit(letter)) {
      has_digits = true;
      const bool fits = decimal.digits < kMostDigits;
      if (fits)
        decimal.digits = 10 * decimal.digits + std::uint64_t(letter - '0');
      else
        decimal.is_whole = false;
      if (fits && behind_point) --decimal.exponent;
      if (!fits && !behind_point) ++decimal.exponent;
    } else if ((letter == '.' || letter == ',') && !behind_point) {
      behind_point = true;
      decimal.has_comma = letter == ',';
    } else {
      break;
    }
  }
  if (!has_digits) return {};
  if (at == word.size()) return decimal;
  if (word[at] != 'e' && word[at] != 'E') return {};
  const std::optional<int> exponent = readExponent(word.substr(at + 1));
  if (!exponent) return {};
  decimal.exponent += *exponent;
  return decimal;
}

/// Whether a word is how C's or Microsoft's library writes NaN or infinity: "-nan(ind)", "1.#IND00", "infinity".
bool isWordForNotFinite(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  const std::string small = lowerCase(word.substr(0, 12));
  for (const std::string_view begin : {"nan", "1.#", "1,#"})
    if (small.starts_with(begin)) return small.size() > 3 || begin == "nan";
  return small == "inf" || small == "infinity";
}

/// The value of a decimal number where one rounding is right.
std::optional<double> exactValue(const Decimal& decimal) {
  constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  if (!decimal.is_whole || decimal.digits > kExact || decimal.exponent < -22 || decimal.exponent > 22) return {};
  const auto digits = static_cast<double>(decimal.digits);
  return decimal.exponent < 0 ? digits / kPowers[std::size_t(-decimal.exponent)]
                              : digits * kPowers[std::size_t(decimal.exponent)];
}

}  // namespace

NumberText readNumber(std::string_view word) {
  using Kind = NumberText::Kind;
  if (word.size() > 1 && word.ends_with(',') && word[word.size() - 2] != ',') {
    NumberText number = readNumber(word.substr(0, word.size() - 1));
    if (number.kind == Kind::plain) number.kind = Kind::comma_behind;
    return number;
  }
  const std::optional<Decimal> decimal = readDecimal(word);
  if (!decimal) return {kNotANumber, isWordForNotFinite(word) ? Kind::not_finite : Kind::none};
  const Kind kind = decimal->has_comma ? Kind::decimal_comma : Kind::plain;
  if (decimal->digits == 0) return {decimal->is_negative ? -0.0 : 0.0, kind};
  if (const std::optional<double> exact = exactValue(*decimal)) return {decimal->is_negative ? -*exact : *exact, kind};
  std::string text(word);
  std::replace(text.begin(), text.end(), ',', '.');
  if (const std::optional<double> value = parseNumber(text)) return {*value, kind};
  // It is a number, so that it lies beyond all that a double holds: at one end or the other.
  if (decimal->exponent < 0) return {0.0, kind};
  return {kNotANumber, Kind::not_finite};
}

std::optional<int> readInteger(std::string_view word) {
  constexpr long long kGreatest = std::numeric_limits<int>::max();
  const bool is_negative = word.starts_with('-');
  if (is_negative || word.starts_with('+')) word.remove_prefix(1);
  if (word.empty()) return {};
  long long number = 0;
  for (const char letter : word) {
    if (!isDigit(letter) || number > kGreatest) return {};
    number = 10 * number + (letter - '0');
  }
  if (number > kGreatest) return {};
  return static_cast<int>(is_negative ? -number : number);
}

float toFloat(double number) {
  constexpr float kGreatest = std::numeric_limits<float>::max();
  return std::abs(number) <= double{kGreatest} ? static_cast<float>(number) : std::numeric_limits<float>::quiet_NaN();
}

glm::dvec3 toPlace(glm::dvec3 place) {
  const auto isLost = [](double number) { return std::isnan(toFloat(number)); };
  return isLost(place.x) || isLost(place.y) || isLost(place.z) ? glm::dvec3(kNotANumber) : place;
}

void NumberReader::Oddity::add(std::string_view of, std::size_t in_line) {
  if (count++ > 0) return;
  line = in_line;
  constexpr std::size_t kLongest = 24;  // a line may have several
  word = excerpt(of, kLongest);
}

NumberText NumberReader::read(std::string_view word, std::size_t line) {
  const NumberText number = readNumber(word);
  if (number.kind == NumberText::Kind::decimal_comma) commas_.add(word, line);
  if (number.kind == NumberText::Kind::comma_behind) commas_behind_.add(word, line);
  if (number.kind == NumberText::Kind::none) words_.add(word, line);
  return number;
}

std::vector<std::string> NumberReader::remarks() const {
  std::vector<std::string> remarks;
  if (commas_.count > 0)
    remarks.push_back("has decimal commas (the first in line " + std::to_string(commas_.line) + ": '" + commas_.word +
                      "'), which are read as points");
  if (commas_behind_.count > 0)
    remarks.push_back("has commas behind numbers (the first in line " + std::to_string(commas_behind_.line) + ": '" +
                      commas_behind_.word + "'), which are passed over");
  if (words_.count == 1)
    remarks.push_back("line " + std::to_string(words_.line) + ": '" + words_.word + "' is not a number");
  if (words_.count > 1)
    remarks.push_back("has " + std::to_string(words_.count) + " words for numbers that are none (the first in line " +
                      std::to_string(words_.line) + ": '" + words_.word + "')");
  return remarks;
}

}  // namespace mirrorball
