#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"

namespace CLI {
class App;  // CLI11 is included by command_line.cpp only: it takes seconds to compile
}

namespace mirrorball::cli {

/// What a subcommand does once the command line is read; its Error becomes the exit code.
using Action = std::function<Result<void>()>;

/// Adds a subcommand with all its options to the program and returns what it does.
using AddCommand = Action (*)(CLI::App& program);

/// Reads the command line of a program with these subcommands. Prints help or the version where they are asked for.
///
/// returns  what is to be done
/// errors   usage
Result<Action> readCommandLine(int argc, char** argv, std::span<const AddCommand> commands);

/// Adds a subcommand.
///
/// help     one sentence
CLI::App& addCommand(CLI::App& program, const std::string& name, const std::string& help);

/// Adds an argument without a name to a subcommand, which takes them in the order in which they are added; that of a list
/// takes one or more words. `target` must outlive the parsing.
void addArgument(CLI::App& command, const std::string& name, std::string& target, const std::string& help);
void addArgument(CLI::App& command, const std::string& name, std::vector<std::string>& target, const std::string& help);

/// The same for one that may be left out: `target` then stays as it is.
void addOptionalArgument(CLI::App& command, const std::string& name, std::string& target, const std::string& help);

/// The text of an option for help: its sentence, choices, unit, range and default.
std::string describe(const OptionText& text, const std::string& default_value);

/// --max-memory, of every command that reads maps.
inline constexpr OptionText kMaxMemoryText{
    .name = "max-memory",
    .value = "BYTES",
    .help = "the most memory that images may take, as in 1.5G or 800M; else 3/4 of what the machine has"};

/// --rotate, of commands that can turn the light.
inline constexpr OptionText kRotateText{
    .name = "rotate",
    .value = "YAW[,PITCH[,ROLL]]",
    .unit = "degrees",
    .most = 3,
    .help = "turns the light about +Z by ROLL, then about +X by PITCH, then about +Y by YAW, +Z towards +X"};

/// What --rotate was given, as a `source_from_target`.
///
/// angles_deg  up to three; those that are missing are 0
glm::mat3 sourceFromRotated(std::vector<float> angles_deg);

/// Sets the limit that --max-memory was given; empty leaves it.
///
/// errors   usage
Result<void> useMemoryLimit(const std::string& written);

/// What one option of the command line does with a value; a flag is given "yes".
using SetValue = std::function<Result<void>(const std::string& written)>;

/// Adds one option that is told by its text. A wrong value becomes a CLI::ValidationError with the Error's message.
void addOption(CLI::App& command, const OptionText& text, const std::string& default_value, bool is_flag,
               bool may_repeat, SetValue set);

/// Adds a table of options that set the fields of `target`, which must outlive the parsing.
template <typename Target>
void addOptions(CLI::App& command, std::span<const Option<Target>> table, Target& target) {
  for (const Option<Target>& option : table)
    addOption(command, option.text, written(option, target), std::holds_alternative<bool Target::*>(option.field),
              std::holds_alternative<std::vector<std::string> Target::*>(option.field),
              [&option, &target](const std::string& value) { return assign(option, target, value); });
}

}  // namespace mirrorball::cli
