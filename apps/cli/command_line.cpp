#include "cli/command_line.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/files.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball::cli {

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

namespace {

/// Help whose columns are as straight as code points make them: CLI11 counts bytes.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    std::string line = name;
    if (columnsOf(name) >= column_width_) line += "\n" + std::string(column_width_, ' ');
    if (columnsOf(name) < column_width_) line.append(column_width_ - columnsOf(name), ' ');
    return line + make_option_desc(option) + "\n";
  }
};

/// What CLI11 calls with the words that it found for an option or an argument.
auto takeAll(const SetValue& set) {
  return [&set](const std::vector<std::string>& values) {
    for (const std::string& value : values)
      if (const auto done = set(value); !done) throw CLI::ValidationError("--" + done.error().message);
  };
}

void addArgumentTo(CLI::App& app, const Argument& argument) {
  CLI::Option* option = app.add_option_function<std::vector<std::string>>(
      std::string(argument.name), takeAll(argument.set), std::string(argument.help));
  if (!argument.may_repeat) option->expected(1)->allow_extra_args(false);
  option->required(!argument.missing.empty())->type_name("");
}

void addOptionTo(CLI::App& app, const CommandOption& command_option) {
  const OptionText& text = command_option.text;
  std::string flags = "--" + std::string(text.name);
  if (!text.letter.empty()) flags = "-" + std::string(text.letter) + "," + flags;
  if (!text.also.empty()) flags += ",--" + std::string(text.also);
  CLI::Option* option = nullptr;
  if (command_option.is_flag) {
    option = app.add_flag_callback(
        flags, [take = takeAll(command_option.set)] { take({"yes"}); }, describe(text, ""));
  } else {
    option = app.add_option_function<std::vector<std::string>>(flags, takeAll(command_option.set),
                                                               describe(text, command_option.default_value));
    option->type_name(valueOf(command_option));
    if (!text.implied.empty())
      option->expected(0, 1)->default_str(std::string(text.implied));
    else
      option->expected(1);
    // One value at a time, so that the model's name may follow an option.
    option->allow_extra_args(false);
    option->multi_option_policy(command_option.may_repeat ? CLI::MultiOptionPolicy::TakeAll
                                                          : CLI::MultiOptionPolicy::TakeLast);
  }
  if (!text.group.empty()) option->group(std::string(text.group));
}

std::string examplesOf(const Command& command) {
  if (command.examples.empty()) return "";
  std::string text = "Examples:";
  for (const Example& example : command.examples)
    text += "\n  mirrorball " + std::string(example.line) + "\n      " + std::string(example.what);
  return text;
}

/// The error for arguments that no option or positional takes: suggests the nearest option.
Error unexpectedArgument(const Command& command, const std::string& argument) {
  const std::string help = "mirrorball " + std::string(command.name) + " --help";
  const std::string name = argument.substr(0, argument.find('='));
  if (!name.starts_with('-')) {
    const bool takes_output = std::ranges::find(command.options, "output", [](const CommandOption& option) {
                                return option.text.name;
                              }) != command.options.end();
    const std::string hint = takes_output && isOutputName(argument) ? "to write it say -o " + argument : "see " + help;
    return {ErrorCode::usage, "'" + argument + "' was not expected; " + hint};
  }
  std::vector<std::string> options{"--help", "--version"};
  for (const CommandOption& option : command.options) {
    options.push_back("--" + std::string(option.text.name));
    if (!option.text.also.empty()) options.push_back("--" + std::string(option.text.also));
  }
  const std::vector<std::string_view> views(options.begin(), options.end());
  std::string message = "there is no option " + name;
  if (const auto nearest = nearestWord(name, views)) message += "; did you mean " + std::string(*nearest) + "?";
  return {ErrorCode::usage, message + " (" + help + " lists them)"};
}

/// The one line of a CLI11 error, in our words where CLI11 speaks of its own types.
Error parseError(const CLI::ParseError& error, const Command* command) {
  std::string message = error.what();
  // It puts the name of an exception in front of its own.
  if (message.starts_with("--: ")) message.erase(0, 4);
  if (command == nullptr) return {ErrorCode::usage, message};
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    for (const Argument& argument : command->arguments)
      if (message.starts_with(argument.name))
        return {ErrorCode::usage, std::string(argument.missing) + ": mirrorball " + synopsisOf(*command)};
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    for (const CommandOption& option : command->options) {
      const std::string name = "--" + std::string(option.text.name);
      if (message.substr(0, message.find(':')) != name) continue;
      return {ErrorCode::usage,
              name + " needs " + (option.text.takes_path ? "a file name" : "a value: " + valueOf(option))};
    }
  return {ErrorCode::usage, message};
}

std::vector<std::string_view> namesOf(std::span<const Command> commands) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

/// The error for a command line without a subcommand, or with a wrong one.
Error missingCommand(const std::vector<std::string>& words, std::span<const Command> commands) {
  const std::string help = "; mirrorball --help tells what each does";
  const std::vector<std::string_view> names = namesOf(commands);
  if (words.empty()) return {ErrorCode::usage, "name a command: " + join(names) + help};
  Error error = words.front().starts_with('-')
                    ? unknownName("option", words.front(), std::array<std::string_view, 2>{"--help", "--version"})
                    : unknownName("command", words.front(), names);
  error.message += help;
  return error;
}

/// "help render" asks for what "render --help" does.
std::vector<std::string> withHelpLast(std::vector<std::string> words, std::span<const Command> commands) {
  if (words.empty() || words.front() != "help") return words;
  if (words.size() == 1) return {"--help"};
  const bool is_command = std::ranges::find(commands, words[1], &Command::name) != commands.end();
  if (is_command && words.size() == 2) return {words[1], "--help"};
  return {words.begin() + 1, words.end()};
}

/// CLI11's view of the commands.
struct Reader {
  CLI::App program{"Environment mapping: what mirrors, glass, rough metal and bumpy surfaces look like in a place"};
  std::vector<CLI::App*> apps;

  explicit Reader(std::span<const Command> commands) {
    const std::string version = std::string("mirrorball ") + MIRRORBALL_VERSION;
    program.name("mirrorball");
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_version_flag("--version", version);
    program.set_help_flag("-h,--help", "Print this help");
    program.footer("mirrorball help COMMAND tells what a command takes; the pages are in docs/ and `man mirrorball`.");
    for (const Command& command : commands) {
      CLI::App& app = *program.add_subcommand(std::string(command.name), std::string(command.help));
      app.allow_extras()->set_version_flag("--version", version);
      app.footer(examplesOf(command));
      for (const Argument& argument : command.arguments) addArgumentTo(app, argument);
      for (const CommandOption& option : command.options) addOptionTo(app, option);
      apps.push_back(&app);
    }
    program.allow_extras()->require_subcommand(0, 1);
  }

  /// The subcommand that was named; nothing before it was read.
  const Command* parsed(std::span<const Command> commands) const {
    const auto app = std::ranges::find_if(apps, [](const CLI::App* candidate) { return candidate->parsed(); });
    return app == apps.end() ? nullptr : &commands[static_cast<std::size_t>(app - apps.begin())];
  }
};

/// errors   usage: no subcommand, or what nothing takes
Result<void> checkAllTaken(const Reader& reader, const Command* command, const std::vector<std::string>& words,
                           std::span<const Command> commands) {
  if (command == nullptr) return tl::unexpected<Error>(missingCommand(words, commands));
  if (const auto extras = reader.program.remaining(); !extras.empty())
    return fail(ErrorCode::usage, "'" + extras.front() + "' was not expected; mirrorball --help tells what may be");
  for (const CLI::App* app : reader.program.get_subcommands())
    if (const auto extras = app->remaining(); !extras.empty())
      return tl::unexpected<Error>(unexpectedArgument(*command, extras.front()));
  return {};
}

}  // namespace

Result<Action> readCommandLine(int argc, const char* const* argv, std::span<const Command> commands) {
  const std::vector<std::string> words =
      withHelpLast(argc > 0 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>(), commands);
  Reader reader(commands);
  try {
    // CLI11 takes them from the last to the first.
    reader.program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& help_or_version) {
    reader.program.exit(help_or_version);
    return Action([]() -> Result<void> { return {}; });
  } catch (const CLI::ParseError& error) {
    return tl::unexpected<Error>(parseError(error, reader.parsed(commands)));
  }
  const Command* command = reader.parsed(commands);
  MIRRORBALL_TRY_VOID(checkAllTaken(reader, command, words, commands));
  return command->action;
}

}  // namespace mirrorball::cli
