#include "mirrorball/scene/place_text.h"

#include <array>
#include <cstdio>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

std::string exactText(double number) {
  if (double(static_cast<float>(number)) == number) return formatNumber(number);
  constexpr int kMostDigits = 17;  // tell any double from its neighbours
  std::array<char, 32> letters{};
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    std::snprintf(letters.data(), letters.size(), "%.*g", digits, number);
    if (parseNumber(letters.data()) == number) break;
  }
  return letters.data();
}

}  // namespace

Result<std::vector<double>> parseExactNumbers(const OptionText& text, std::string_view written) {
  // It says what is wrong with them.
  MIRRORBALL_TRY_VOID(parseNumbers(text, written));
  std::vector<double> numbers;
  for (const std::string& part : split(written, ',')) numbers.push_back(*parseNumber(part));
  return numbers;
}

std::string writtenPlace(glm::dvec3 place) {
  return exactText(place.x) + "," + exactText(place.y) + "," + exactText(place.z);
}

}  // namespace mirrorball
