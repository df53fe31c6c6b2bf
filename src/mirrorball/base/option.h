#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// What a person reads of an option or a parameter: one row of a table of data from which the command line,
/// its help, the documentation and a viewer's panels are made.
struct OptionText {
  std::string_view name;        ///< "fov", "perceptual_roughness": without dashes
  std::string_view value = {};  ///< how the value is written in help: "DEG"; empty for a flag
  std::string_view unit = {};   ///< "degrees"; empty for a pure number
  double minimum = -std::numeric_limits<double>::infinity();  ///< of each number
  double maximum = std::numeric_limits<double>::infinity();
  int min_count = 1;  ///< how many numbers a list takes
  int max_count = 1;
  std::string_view choices = {};  ///< "exact|schlick|empirical": the values of an enumeration, in its order
  std::string_view aliases = {};  ///< "linear=bilinear|cubic=bicubic": other ways to write a choice
  /// One sentence. Another option is named {option:NAME}, since each face has its own way to write that: filledIn().
  std::string_view help = {};
  std::string_view letter = {};   ///< "o" where -o is a short form
  std::string_view implied = {};  ///< what is meant when the option is given without a value; empty: it needs one
  std::string_view group = {};    ///< heading in help
  std::string_view also = {};     ///< "env-rotation": the option's other name
  bool takes_path = false;        ///< the value is a file's or a folder's name
  bool is_daily = false;          ///< most people use it: the help of a command with many options shows it at once
  /// The names that a text may be, or begin with; they complete it on the command line.
  std::span<const std::string_view> (*names)() = nullptr;

  // For who sets it by hand (base/option_control.h):
  double soft_minimum = -std::numeric_limits<double>::infinity();  ///< of a slider, within the range
  double soft_maximum = std::numeric_limits<double>::infinity();
  double step = 0.0;           ///< of a slider; 0: none
  bool is_number = false;      ///< a field of a kind of its own holds nothing else
  bool is_color = false;       ///< three numbers are linear light
  char between_numbers = ',';  ///< as the field writes and reads them
};

/// A text of the library in the words of a face: each {option:NAME} gives way to `nameOf(NAME)`.
template <typename NameOf>
std::string filledIn(std::string_view text, const NameOf& nameOf) {
  constexpr std::string_view kBegin = "{option:";
  std::string filled;
  while (true) {
    const std::size_t begin = text.find(kBegin);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('}', begin);
    if (end == std::string_view::npos) return filled += text;
    filled += text.substr(0, begin);
    filled += nameOf(text.substr(begin + kBegin.size(), end - begin - kBegin.size()));
    text.remove_prefix(end + 1);
  }
}

/// Numbers written "1,2.5,3", as many as `text` allows and each in its range; without one up to ±1e30, so that what is
/// computed from them stays finite.
///
/// errors   usage: names the option, its unit and range
Result<std::vector<float>> parseNumbers(const OptionText& text, std::string_view written);

/// "a,b,c"
std::string writeNumbers(std::span<const float> numbers);

/// An enumeration field of `Target` as an index into its choices.
template <typename Target>
struct ChoiceField {
  int (*get)(const Target&);
  void (*set)(Target&, int);
};

/// Fields of `Target` that take a text of their own kind: a size "640x480", a colour.
template <typename Target>
struct ParsedField {
  /// As the user would write them; "" where they hold nothing.
  std::string (*write)(const Target&);
  /// errors   usage: names the option by its text
  Result<void> (*parse)(const OptionText&, std::string_view written, Target&);
  bool may_repeat = false;
};

namespace detail {
/// The struct that the first member of a path belongs to.
template <auto First, auto... Rest>
struct OwnerOf;
template <typename Owner, typename Field, Field Owner::*First, auto... Rest>
struct OwnerOf<First, Rest...> {
  using type = Owner;
};
}  // namespace detail

/// An enumeration, by the members that lead to it: `choiceField<&FrameSettings::camera, &Camera::lens>`.
template <auto... Path>
inline constexpr ChoiceField<typename detail::OwnerOf<Path...>::type> choiceField{
    [](const auto& target) { return static_cast<int>((target.*....*Path)); },
    [](auto& target, int index) {
      auto& field = (target.*....*Path);
      field = static_cast<std::remove_reference_t<decltype(field)>>(index);
    }};

/// A number that lies deeper in `Target` than a member of its own, by the members that lead to it.
template <auto... Path>
inline constexpr ParsedField<typename detail::OwnerOf<Path...>::type> numberField{
    [](const auto& target) {
      return writeNumbers({&(target.*....*Path), 1});
    },
    [](const OptionText& text, std::string_view written, auto& target) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      (target.*....*Path) = numbers[0];
      return {};
    }};

/// One row of a table: its text, and the field of `Target` that it sets. The field's initialiser is the default.
template <typename Target>
struct Option {
  OptionText text;
  std::variant<bool Target::*, int Target::*, std::optional<int> Target::*, float Target::*, glm::vec3 Target::*,
               std::string Target::*, std::vector<float> Target::*, std::vector<std::string> Target::*,
               ChoiceField<Target>, ParsedField<Target>>
      field;

  bool isFlag() const { return std::holds_alternative<bool Target::*>(field); }
  bool mayRepeat() const {
    const auto* parsed = std::get_if<ParsedField<Target>>(&field);
    return parsed ? parsed->may_repeat : std::holds_alternative<std::vector<std::string> Target::*>(field);
  }
};

/// What is said of options that have nothing to act on: "--rays changes nothing: no occlusion is made", "--blur and
/// --probes change nothing: ...".
///
/// options   as they are to be said; not empty
std::string changesNothing(std::span<const std::string> options, std::string_view why);

/// "fov takes a number in degrees (1 … 170); it was given 'wide'", with the option's own name, unit and range.
tl::unexpected<Error> misused(const OptionText& text, std::string_view wants, std::string_view given);

/// Three numbers, or one that stands for all three.
Result<glm::vec3> parseVector(const OptionText& text, std::string_view written);

/// A whole number in the option's range.
Result<int> parseInteger(const OptionText& text, std::string_view written);

/// The option's choices, in their order.
std::vector<std::string_view> choicesOf(const OptionText& text);

/// The index of one of the option's choices, as indexOfName finds it.
Result<int> parseChoice(const OptionText& text, std::string_view written);

/// "yes/no", "true/false", "on/off" or "1/0".
Result<bool> parseFlag(const OptionText& text, std::string_view written);

/// "0 … 1", "at least 0" or "" when there is no bound.
std::string rangeText(const OptionText& text);

/// The choice with that index.
std::string_view choiceAt(const OptionText& text, int index);

/// Sets the option's field of `target` from what the user wrote. A list of texts grows by one.
///
/// errors   usage
template <typename Target>
Result<void> assign(const Option<Target>& option, Target& target, std::string_view written) {
  return std::visit(
      [&](auto field) -> Result<void> {
        using Field = decltype(field);
        if constexpr (std::is_same_v<Field, bool Target::*>) {
          MIRRORBALL_TRY(flag, parseFlag(option.text, written));
          target.*field = flag;
        } else if constexpr (std::is_same_v<Field, int Target::*> ||
                             std::is_same_v<Field, std::optional<int> Target::*>) {
          MIRRORBALL_TRY(integer, parseInteger(option.text, written));
          target.*field = integer;
        } else if constexpr (std::is_same_v<Field, ChoiceField<Target>>) {
          MIRRORBALL_TRY(index, parseChoice(option.text, written));
          field.set(target, index);
        } else if constexpr (std::is_same_v<Field, ParsedField<Target>>) {
          return field.parse(option.text, written, target);
        } else if constexpr (std::is_same_v<Field, glm::vec3 Target::*>) {
          MIRRORBALL_TRY(vector, parseVector(option.text, written));
          target.*field = vector;
        } else if constexpr (std::is_same_v<Field, std::string Target::*>) {
          target.*field = std::string(written);
        } else if constexpr (std::is_same_v<Field, std::vector<std::string> Target::*>) {
          (target.*field).emplace_back(written);
        } else {
          MIRRORBALL_TRY(numbers, parseNumbers(option.text, written));
          if constexpr (std::is_same_v<Field, float Target::*>)
            target.*field = numbers[0];
          else
            target.*field = std::move(numbers);
        }
        return {};
      },
      option.field);
}

/// The value that the field has in `target`, as the user would write it; "" for an empty list or text and for
/// a number that is not there.
template <typename Target>
std::string written(const Option<Target>& option, const Target& target) {
  return std::visit(
      [&](auto field) -> std::string {
        using Field = decltype(field);
        if constexpr (std::is_same_v<Field, bool Target::*>) {
          return target.*field ? "yes" : "no";
        } else if constexpr (std::is_same_v<Field, int Target::*>) {
          return std::to_string(target.*field);
        } else if constexpr (std::is_same_v<Field, std::optional<int> Target::*>) {
          return target.*field ? std::to_string(*(target.*field)) : "";
        } else if constexpr (std::is_same_v<Field, float Target::*>) {
          return writeNumbers({&(target.*field), 1});
        } else if constexpr (std::is_same_v<Field, glm::vec3 Target::*>) {
          return writeNumbers({&(target.*field).x, 3});
        } else if constexpr (std::is_same_v<Field, std::string Target::*>) {
          return target.*field;
        } else if constexpr (std::is_same_v<Field, std::vector<float> Target::*>) {
          return writeNumbers(target.*field);
        } else if constexpr (std::is_same_v<Field, std::vector<std::string> Target::*>) {
          return "";
        } else if constexpr (std::is_same_v<Field, ParsedField<Target>>) {
          return field.write(target);
        } else {
          return std::string(choiceAt(option.text, field.get(target)));
        }
      },
      option.field);
}

}  // namespace mirrorball
