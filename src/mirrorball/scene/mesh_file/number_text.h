#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace mirrorball {

/// A number as a text has it.
struct NumberText {
  enum class Kind {
    plain,
    decimal_comma,  ///< "0,5", as programs write it that take their user's language
    comma_behind,   ///< "0.5,", of a list that a comma separates, too
    not_finite,     ///< "nan", "-nan(ind)", "1.#QNAN", "-1.#IND00", "inf", "1e999": C's words, and those of Microsoft's
    none,           ///< no number
  };
  double value = 0.0;  ///< the nearest to the text; NaN where it is not finite, or none
  Kind kind = Kind::none;
};

/// Reads one word as a number, independent of the locale.
///
/// cost   15 ns for up to 15 digits; others ten times as much
/// from   Clinger 1990, "How to read floating point numbers accurately": up to 2⁵³ · 10^±22 one operation rounds it
///        rightly
NumberText readNumber(std::string_view word);

/// The nearest float; NaN where there is none, of numbers beyond the largest float.
float toFloat(double number);

/// A whole number with a sign or without; nothing where the word is anything else, or does not fit.
std::optional<int> readInteger(std::string_view word);

/// A place as it can be drawn: NaN, as a whole, where floats do not hold it.
glm::dvec3 toPlace(glm::dvec3 place);

/// Reads the numbers of a text, and keeps what is unusual about them.
class NumberReader {
 public:
  /// The number of a word, as readNumber() has it.
  ///
  /// line   of the text, from 1, for remarks
  NumberText read(std::string_view word, std::size_t line);

  /// "has decimal commas (the first in line 3: '0,5'), which are read as points"; "has commas behind numbers …"; "line
  /// 7: 'abc' is not a number".
  /// NaN and infinities are not among them: what uses these numbers reports what became of it.
  std::vector<std::string> remarks() const;

 private:
  struct Oddity {
    std::size_t count = 0;
    std::size_t line = 0;  // of the first
    std::string word;
    void add(std::string_view of, std::size_t in_line);
  };
  Oddity commas_;
  Oddity commas_behind_;
  Oddity words_;
};

}  // namespace mirrorball
