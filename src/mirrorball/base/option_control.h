#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

// What a panel is made of: how each option of a table is set by hand, and its value as a type of C++ and not as a text.

/// What an option is set by.
enum class ControlKind {
  flag,     ///< a box to tick
  choice,   ///< one of choicesOf
  integer,  ///< a whole number
  number,   ///< a number
  numbers,  ///< several
  color,    ///< linear light: red, green, blue
  file,     ///< a name of a file, or one of OptionText::names
  text,     ///< what only a line of text can say: "ground:2.5"
};

/// How an option is set by hand.
struct OptionControl {
  ControlKind kind = ControlKind::text;
  std::size_t least_count = 1;  ///< of numbers
  std::size_t count = 1;        ///< at most
  double minimum = 0.0;         ///< from where to where a slider goes; not finite: it has no end there
  double maximum = 0.0;
  double step = 0.0;  ///< of it; 0: none
};

/// A value: of a flag, of a choice (its index) or an integer, of numbers and colours, of files and texts. No numbers:
/// the option holds none.
using ControlValue = std::variant<bool, int, std::vector<float>, std::string>;

namespace detail {
OptionControl controlOf(const OptionText& text, ControlKind kind);
/// The numbers of a text that the option has written.
std::vector<float> numbersIn(const OptionText& text, const std::string& written);
/// As the option reads them.
std::string textOf(const OptionText& text, const std::vector<float>& numbers);
/// Of a field with a text of its own kind.
ControlKind kindOfText(const OptionText& text);
}  // namespace detail

/// How it is set by hand.
template <typename Target>
OptionControl controlOf(const Option<Target>& option) {
  return std::visit(
      [&](auto field) {
        using Field = decltype(field);
        ControlKind kind = detail::kindOfText(option.text);
        if constexpr (std::is_same_v<Field, bool Target::*>)
          kind = ControlKind::flag;
        else if constexpr (std::is_same_v<Field, ChoiceField<Target>>)
          kind = ControlKind::choice;
        else if constexpr (std::is_same_v<Field, int Target::*> || std::is_same_v<Field, std::optional<int> Target::*>)
          kind = ControlKind::integer;
        else if constexpr (std::is_same_v<Field, float Target::*>)
          kind = ControlKind::number;
        else if constexpr (std::is_same_v<Field, glm::vec3 Target::*> ||
                           std::is_same_v<Field, std::vector<float> Target::*>)
          kind = option.text.is_color ? ControlKind::color : ControlKind::numbers;
        OptionControl control = detail::controlOf(option.text, kind);
        if constexpr (std::is_same_v<Field, glm::vec3 Target::*>) control.least_count = control.count = 3;
        return control;
      },
      option.field);
}

/// Its value.
template <typename Target>
ControlValue valueOf(const Option<Target>& option, const Target& target) {
  const std::string text = written(option, target);
  switch (controlOf(option).kind) {
    case ControlKind::flag:
      return text == "yes";
    case ControlKind::choice:
      return std::get<ChoiceField<Target>>(option.field).get(target);
    case ControlKind::integer:
      if (!text.empty()) return static_cast<int>(detail::numbersIn(option.text, text).at(0));
      [[fallthrough]];
    case ControlKind::number:
    case ControlKind::numbers:
    case ControlKind::color:
      return detail::numbersIn(option.text, text);
    case ControlKind::file:
    case ControlKind::text:
      break;
  }
  return text;
}

/// Sets it: checked as what a user writes is.
///
/// value    of the kind that valueOf gives
/// errors   usage
template <typename Target>
Result<void> setValue(const Option<Target>& option, Target& target, const ControlValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return assign(option, target, *flag ? "yes" : "no");
  if (const auto* number = std::get_if<int>(&value)) {
    if (option.text.choices.empty()) return assign(option, target, std::to_string(*number));
    const auto choices = choicesOf(option.text);
    if (*number < 0 || static_cast<std::size_t>(*number) >= choices.size())
      return misused(option.text, "one of its " + std::to_string(choices.size()) + " choices", std::to_string(*number));
    return assign(option, target, choices[static_cast<std::size_t>(*number)]);
  }
  if (const auto* numbers = std::get_if<std::vector<float>>(&value))
    return assign(option, target, detail::textOf(option.text, *numbers));
  return assign(option, target, std::get<std::string>(value));
}

}  // namespace mirrorball
