#include "cli/command_line.h"

#include <algorithm>
#include <array>
#include <utility>

#include <CLI/CLI.hpp>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball::cli {

CLI::App& addCommand(CLI::App& program, const std::string& name, const std::string& help) {
  return *program.add_subcommand(name, help);
}

void addArgument(CLI::App& command, const std::string& name, std::string& target, const std::string& help) {
  command.add_option(name, target, help)->required();
}

void addArgument(CLI::App& command, const std::string& name, std::vector<std::string>& target,
                 const std::string& help) {
  command.add_option(name, target, help)->required();
}

void addOptionalArgument(CLI::App& command, const std::string& name, std::string& target, const std::string& help) {
  command.add_option(name, target, help);
}

std::string describe(const OptionText& text, const std::string& default_value) {
  std::string description(text.help);
  std::string facts;
  const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : "; ") + fact; };
  if (!text.unit.empty()) add("in " + std::string(text.unit));
  if (const std::string range = rangeText(text); !range.empty()) add(range);
  if (!default_value.empty()) add("default " + default_value);
  if (!text.implied.empty()) add("without a value " + std::string(text.implied));
  return facts.empty() ? description : description + " (" + facts + ")";
}

glm::mat3 sourceFromRotated(std::vector<float> angles_deg) {
  angles_deg.resize(3, 0.0f);
  return glm::transpose(
      turnedBy(glm::radians(angles_deg[0]), glm::radians(angles_deg[1]), glm::radians(angles_deg[2])));
}

Result<void> useMemoryLimit(const std::string& written) {
  if (written.empty()) return {};
  auto bytes = parseBytes(written);
  if (!bytes) return fail(ErrorCode::usage, "--max-memory: " + bytes.error().message);
  setMemoryLimit(*bytes);
  return {};
}

void addOption(CLI::App& command, const OptionText& text, const std::string& default_value, bool is_flag,
               bool may_repeat, SetValue set) {
  const std::string name(text.name);
  const std::string flags = (text.letter.empty() ? "" : "-" + std::string(text.letter) + ",") + "--" + name;
  const auto take = [set](const std::string& value) {
    if (const auto done = set(value); !done) throw CLI::ValidationError("--" + done.error().message);
  };
  CLI::Option* option = nullptr;
  if (is_flag) {
    option = command.add_flag_callback(
        flags, [take] { take("yes"); }, describe(text, ""));
  } else {
    option = command.add_option_function<std::vector<std::string>>(
        flags, [take](const std::vector<std::string>& values) { std::for_each(values.begin(), values.end(), take); },
        describe(text, default_value));
    option->type_name(std::string(text.value.empty() ? (text.choices.empty() ? "NUMBER" : text.choices) : text.value));
    if (!text.implied.empty())
      option->expected(0, 1)->default_str(std::string(text.implied));
    else
      option->expected(1);
    // One value at a time, so that the model's name may follow an option.
    option->allow_extra_args(false);
    option->multi_option_policy(may_repeat ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast);
  }
  if (!text.group.empty()) option->group(std::string(text.group));
}

namespace {

/// The error for arguments that no option or positional takes: suggests the nearest option.
Error unexpectedArgument(const CLI::App& command, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  if (!name.starts_with('-'))
    return {ErrorCode::usage, "'" + argument + "' was not expected; see mirrorball " + command.get_name() + " --help"};
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& long_name : option->get_lnames()) options.push_back("--" + long_name);
  const std::vector<std::string_view> views(options.begin(), options.end());
  std::string message = "there is no option " + name;
  if (const auto nearest = nearestWord(name, views)) message += "; did you mean " + std::string(*nearest) + "?";
  return {ErrorCode::usage, message + " (mirrorball " + command.get_name() + " --help lists them)"};
}

/// The one line of a CLI11 error: without the name of the exception that it puts in front of its own.
Error parseError(const CLI::ParseError& error) {
  std::string message = error.what();
  if (const std::size_t colon = message.find("--: "); colon == 0) message.erase(0, 4);
  return {ErrorCode::usage, message};
}

/// The error for a command line without a subcommand, or with a wrong one.
Error missingCommand(int argc, char** argv, const std::vector<std::string_view>& names) {
  constexpr const char* kHelp = "; mirrorball --help tells what each does";
  if (argc < 2) return {ErrorCode::usage, "name a command: " + join(names) + kHelp};
  Error error = argv[1][0] == '-'
                    ? unknownName("option", argv[1], std::array<std::string_view, 2>{"--help", "--version"})
                    : unknownName("command", argv[1], names);
  error.message += kHelp;
  return error;
}

/// errors   usage: no subcommand, or what nothing takes
Result<void> checkAllTaken(const CLI::App& program, const std::vector<CLI::App*>& commands, int argc, char** argv) {
  if (program.get_subcommands().empty()) {
    std::vector<std::string_view> names;
    for (const CLI::App* command : commands) names.emplace_back(command->get_name());
    return tl::unexpected<Error>(missingCommand(argc, argv, names));
  }
  if (const auto extras = program.remaining(); !extras.empty())
    return fail(ErrorCode::usage, "'" + extras.front() + "' was not expected; mirrorball --help tells what may be");
  for (const CLI::App* command : program.get_subcommands())
    if (const auto extras = command->remaining(); !extras.empty())
      return tl::unexpected<Error>(unexpectedArgument(*command, extras.front()));
  return {};
}

}  // namespace

Result<Action> readCommandLine(int argc, char** argv, std::span<const AddCommand> add_commands) {
  CLI::App program("Environment mapping: what mirrors, glass, rough metal and bumpy surfaces look like in a place");
  program.name("mirrorball");
  const std::string version = std::string("mirrorball ") + MIRRORBALL_VERSION;
  program.set_version_flag("--version", version);
  program.set_help_flag("-h,--help", "Print this help");
  std::vector<Action> actions;
  for (const AddCommand add : add_commands) actions.push_back(add(program));
  // In the order in which they were added.
  const std::vector<CLI::App*> commands = program.get_subcommands([](CLI::App*) { return true; });
  for (CLI::App* command : commands) command->allow_extras()->set_version_flag("--version", version);
  program.allow_extras()->require_subcommand(0, 1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    program.exit(help_or_version);
    return Action([]() -> Result<void> { return {}; });
  } catch (const CLI::ParseError& error) {
    return tl::unexpected<Error>(parseError(error));
  }
  MIRRORBALL_TRY_VOID(checkAllTaken(program, commands, argc, argv));
  const auto parsed = std::ranges::find_if(commands, [](const CLI::App* command) { return command->parsed(); });
  return std::move(actions[static_cast<std::size_t>(parsed - commands.begin())]);
}

}  // namespace mirrorball::cli
