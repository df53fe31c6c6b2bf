#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// What a subcommand does once the command line is read; its Error becomes the exit code.
using Action = std::function<Result<void>()>;

/// What one option or argument does with a value; a flag is given "yes".
using SetValue = std::function<Result<void>(const std::string& written)>;

/// An option of a subcommand.
struct CommandOption {
  OptionText text;
  std::string default_value;
  bool is_flag = false;
  bool may_repeat = false;
  SetValue set = {};
};

/// A word of a subcommand that has no name before it. Words are taken in the order in which arguments are added.
struct Argument {
  std::string_view name;          ///< "MODEL"
  std::string help;               ///< one sentence
  std::string_view missing = {};  ///< what to say where it is missing: "name an input map"; empty: it may be left out
  std::span<const std::string_view> (*names)() = nullptr;  ///< of what is built in
  bool takes_path = false;
  bool may_repeat = false;
  SetValue set = {};
};

/// A command line to begin with.
struct Example {
  std::string_view line;  ///< without the program's name
  std::string_view what;  ///< it does
};

/// A subcommand, as data: the command line, its help, docs/options.md, the manual and the completions are made from it.
struct Command {
  std::string_view name;
  std::string help;        ///< one sentence
  std::string about = {};  ///< more, for the reference
  std::vector<Argument> arguments = {};
  std::vector<CommandOption> options = {};
  std::vector<Example> examples = {};
  Action action = {};
};

/// A text of the library as the command line says it: {option:proxy} is --proxy.
std::string inCommandWords(std::string_view text);

/// The row of a table, in those words.
OptionText inCommandWords(OptionText text);

/// Adds an argument that sets `target`, which must outlive the command's action.
void addArgument(Command& command, Argument argument, std::string& target);
/// The same for one or more words.
void addArgument(Command& command, Argument argument, std::vector<std::string>& target);

/// The names of options that the user gave, for those whose default says nothing of that.
using GivenOptions = std::set<std::string_view>;

/// Adds a table of options that set the fields of `target`, which must outlive the command's action.
///
/// given    learns which were given; must outlive it too
template <typename Target>
void addOptions(Command& command, std::type_identity_t<std::span<const Option<Target>>> table, Target& target,
                GivenOptions* given = nullptr) {
  for (const Option<Target>& option : table)
    command.options.push_back({inCommandWords(option.text), written(option, target), option.isFlag(),
                               option.mayRepeat(), [&option, &target, given](const std::string& value) {
                                 if (given != nullptr) given->insert(option.text.name);
                                 return assign(option, target, value);
                               }});
}

/// The rows of a table that have one of these names, in the table's order.
template <typename Target>
std::vector<Option<Target>> rowsNamed(std::span<const Option<Target>> table, std::span<const std::string_view> names) {
  std::vector<Option<Target>> rows;
  for (const Option<Target>& option : table)
    if (std::ranges::find(names, option.text.name) != names.end()) rows.push_back(option);
  return rows;
}

/// How the subcommand is written: "convert IN…", "render [MODEL]".
std::string synopsisOf(const Command& command);

/// The text of an option for help: its sentence, unit, range and default.
std::string describe(const OptionText& text, const std::string& default_value);

/// How the value of an option is written in help: "DEG", "ggx|phong"; a flag has none.
std::string valueOf(const CommandOption& option);

/// The words that a value may be: choices, or names; none for numbers and free texts.
std::vector<std::string_view> wordsOf(const OptionText& text);

}  // namespace mirrorball::cli
