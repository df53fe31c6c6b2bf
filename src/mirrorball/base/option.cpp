#include "mirrorball/base/option.h"

#include <cmath>
#include <limits>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// What a number may be where its option says nothing of a range.
constexpr double kLargestNumber = 1e30;

/// The parts of a text between '|'; none of an empty one.
std::vector<std::string_view> partsOf(std::string_view rest) {
  std::vector<std::string_view> parts;
  while (!rest.empty()) {
    const std::size_t end = rest.find('|');
    parts.push_back(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  return parts;
}

std::vector<Alias> aliasesOf(const OptionText& text) {
  std::vector<Alias> aliases;
  for (const std::string_view part : partsOf(text.aliases)) {
    const std::size_t equals = part.find('=');
    aliases.push_back({part.substr(0, equals), part.substr(equals + 1)});
  }
  return aliases;
}

/// The option with the limits that there are where it has none of its own.
OptionText bounded(OptionText text, double limit) {
  if (!std::isfinite(text.minimum)) text.minimum = -limit;
  if (!std::isfinite(text.maximum)) text.maximum = limit;
  return text;
}

bool isWithin(const OptionText& bounds, double number) { return number >= bounds.minimum && number <= bounds.maximum; }

/// The option as it is told of: without those limits, unless a number is beyond them.
OptionText toldOf(const OptionText& text, const OptionText& bounds, std::string_view written) {
  for (const std::string& part : split(written, ','))
    if (const auto number = parseNumber(part); number && !isWithin(bounds, *number)) return bounds;
  return text;
}

std::string wantedNumbers(const OptionText& text) {
  if (text.max_count == 1) return "a number";
  if (text.min_count == text.max_count) return std::to_string(text.max_count) + " numbers with commas between";
  return std::to_string(text.min_count) + " to " + std::to_string(text.max_count) + " numbers with commas between";
}

/// The numbers between commas, if each is one and within the range.
std::optional<std::vector<float>> numbersIn(const OptionText& bounds, std::string_view written) {
  std::vector<float> numbers;
  for (const std::string& part : split(written, ',')) {
    const auto number = parseNumber(part);
    if (!number || !isWithin(bounds, *number)) return {};
    numbers.push_back(static_cast<float>(*number));
  }
  return numbers;
}

}  // namespace

std::string changesNothing(std::span<const std::string> options, std::string_view why) {
  return join(options, ", ", " and ") + (options.size() == 1 ? " changes nothing: " : " change nothing: ") +
         std::string(why);
}

tl::unexpected<Error> misused(const OptionText& text, std::string_view wants, std::string_view given) {
  std::string message = std::string(text.name) + " takes " + std::string(wants);
  if (!text.unit.empty()) message += (text.max_count > 1 ? ", in " : " in ") + std::string(text.unit);
  if (const std::string range = rangeText(text); !range.empty()) message += " (" + range + ")";
  return fail(ErrorCode::usage, message + "; it was given '" + excerpt(given) + "'");
}

Result<std::vector<float>> parseNumbers(const OptionText& text, std::string_view written) {
  const OptionText bounds = bounded(text, kLargestNumber);
  const auto numbers = numbersIn(bounds, written);
  const int count = numbers ? static_cast<int>(numbers->size()) : 0;
  if (count < text.min_count || count > text.max_count)
    return misused(toldOf(text, bounds, written), wantedNumbers(text), written);
  return *numbers;
}

Result<glm::vec3> parseVector(const OptionText& text, std::string_view written) {
  const OptionText bounds = bounded(text, kLargestNumber);
  const auto numbers = numbersIn(bounds, written);
  if (numbers && numbers->size() == 1) return glm::vec3((*numbers)[0]);
  if (numbers && numbers->size() == 3) return glm::vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  OptionText several = toldOf(text, bounds, written);
  several.max_count = 3;
  return misused(several, "one or three numbers with commas between", written);
}

Result<int> parseInteger(const OptionText& text, std::string_view written) {
  const OptionText bounds = bounded(text, std::numeric_limits<int>::max());
  const auto number = parseNumber(written);
  if (!number || *number != std::floor(*number) || !isWithin(bounds, *number))
    return misused(toldOf(text, bounds, written), "a whole number", written);
  return static_cast<int>(*number);
}

std::vector<std::string_view> choicesOf(const OptionText& text) { return partsOf(text.choices); }

Result<int> parseChoice(const OptionText& text, std::string_view written) {
  const auto choices = choicesOf(text);
  if (const auto index = indexOfName(written, choices, aliasesOf(text))) return static_cast<int>(*index);
  Error error = unknownName("value", written, choices, aliasesOf(text));
  error.message = std::string(text.name) + ": " + error.message;
  return tl::unexpected<Error>(error);
}

Result<bool> parseFlag(const OptionText& text, std::string_view written) {
  if (written == "yes" || written == "true" || written == "on" || written == "1") return true;
  if (written == "no" || written == "false" || written == "off" || written == "0") return false;
  return misused(text, "yes or no", written);
}

std::string rangeText(const OptionText& text) {
  const bool low = std::isfinite(text.minimum);
  const bool high = std::isfinite(text.maximum);
  if (low && high) return formatNumber(text.minimum) + " … " + formatNumber(text.maximum);
  if (low) return "at least " + formatNumber(text.minimum);
  if (high) return "at most " + formatNumber(text.maximum);
  return "";
}

std::string writeNumbers(std::span<const float> numbers) {
  std::string written;
  for (const float number : numbers) written += (written.empty() ? "" : ",") + formatNumber(number);
  return written;
}

std::string_view choiceAt(const OptionText& text, int index) {
  const auto choices = choicesOf(text);
  return choices.at(static_cast<std::size_t>(index));
}

}  // namespace mirrorball
