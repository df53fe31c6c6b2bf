#include "mirrorball/scene/place_text.h"

#include <array>
#include <cstdio>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

std::string exactText(double number) {
  if (std::string text = formatNumber(number); parseNumber(text) == number) return text;
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

glm::dvec3 placeInFile(glm::vec3 place, glm::dvec3 origin) {
  glm::dvec3 in_file = origin + glm::dvec3(place);
  if (origin != glm::dvec3(0.0)) return in_file;
  for (int axis = 0; axis < 3; ++axis)
    in_file[axis] = parseNumber(formatNumber(double(place[axis]))).value_or(in_file[axis]);
  return in_file;
}

}  // namespace mirrorball
