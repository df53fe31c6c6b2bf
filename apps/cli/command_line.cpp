#include "cli/command_line.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/help.h"
#include "cli/suggestions.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball::cli {

Result<glm::vec3> unitVector(const std::string& option, const std::vector<float>& numbers) {
  // In double, in which no square of a float is 0 or infinite.
  const glm::dvec3 vector(numbers[0], numbers[1], numbers[2]);
  if (vector == glm::dvec3(0.0)) return fail(ErrorCode::usage, option + " takes a vector that has a length, not 0,0,0");
  return glm::vec3(glm::normalize(vector));
}

Result<void> useMemoryLimit(const OptionText& text, std::string_view written) {
  auto bytes = parseBytes(written);
  if (!bytes) return fail(ErrorCode::usage, std::string(text.name) + ": " + bytes.error().message);
  setMemoryLimit(*bytes);
  return {};
}

namespace {

/// All words behind it are arguments, even those that begin with a dash (POSIX, Utility Syntax Guidelines, 10).
constexpr std::string_view kEndOfOptions = "--";
/// Behind --help it asks for all options.
constexpr std::string_view kAllOfHelp = "all";
/// Behind "help" it asks for what --material and --set take.
constexpr std::string_view kMaterials = "materials";

/// Whether a word is written as an option, which is no value: a number may be negative.
bool isOption(const Command& command, std::string_view word) {
  if (word.starts_with("--") || word == "-h") return true;
  return std::ranges::any_of(command.options, [&](const CommandOption& option) {
    return !option.text.letter.empty() && word == "-" + std::string(option.text.letter);
  });
}

bool isFile(const std::string& word) {
  std::error_code status;
  return std::filesystem::is_regular_file(word, status);
}

/// What is said where an option is given without its value.
std::string neededBy(const CommandOption& option) {
  return "--" + std::string(option.text.name) + " needs " +
         (option.text.takes_path ? "a file name" : "a value: " + valueOf(option));
}

/// errors   usage: what was given is no value, or there are more than count
Result<void> checkValues(const Command& command, const CommandOption& option, const std::vector<std::string>& values) {
  for (const std::string& value : values)
    if (value.empty() || isOption(command, value))
      return fail(ErrorCode::usage, neededBy(option) + "; it was given '" + value + "', which is " +
                                        (value.empty() ? "empty" : "an option"));
  if (option.may_repeat || values.size() < 2) return {};
  const std::string times = values.size() == 2 ? "twice" : std::to_string(values.size()) + " times";
  return fail(ErrorCode::usage, "--" + std::string(option.text.name) + " is given " + times + ", as '" +
                                    values.front() + "' and as '" + values.back() +
                                    "', and only one counts; leave the other out");
}

/// Hands on the words that CLI11 found for an option or an argument, in whose language an error is an exception.
void takeAll(const SetValue& set, const std::vector<std::string>& values) {
  for (const std::string& value : values)
    if (const auto done = set(value); !done) throw CLI::ValidationError("--" + done.error().message);
}

void addArgumentTo(CLI::App& app, const Argument& argument) {
  CLI::Option* option = app.add_option_function<std::vector<std::string>>(
      std::string(argument.name),
      [&argument](const std::vector<std::string>& values) {
        if (std::ranges::find(values, "") != values.end())
          throw CLI::ValidationError(
              std::string(argument.name) + " was given '', which is empty; " +
              std::string(argument.missing.empty() ? "name one, or leave it out" : argument.missing));
        takeAll(argument.set, values);
      },
      std::string(argument.help));
  if (!argument.may_repeat) option->expected(1)->allow_extra_args(false);
  option->required(!argument.missing.empty())->type_name("");
}

/// is_shown   in help
void addOptionTo(CLI::App& app, const Command& command, const CommandOption& command_option, bool is_shown) {
  const OptionText& text = command_option.text;
  std::string flags = "--" + std::string(text.name);
  if (!text.letter.empty()) flags = "-" + std::string(text.letter) + "," + flags;
  if (!text.also.empty()) flags += ",--" + std::string(text.also);
  CLI::Option* option = nullptr;
  if (command_option.is_flag) {
    option = app.add_flag_callback(
        flags, [&command_option] { takeAll(command_option.set, {"yes"}); }, describe(text, ""));
  } else {
    option = app.add_option_function<std::vector<std::string>>(
        flags,
        [&command, &command_option](const std::vector<std::string>& values) {
          if (const auto valid = checkValues(command, command_option, values); !valid)
            throw CLI::ValidationError(valid.error().message);
          takeAll(command_option.set, values);
        },
        describe(text, command_option.default_value));
    option->type_name(valueOf(command_option));
    // One value at a time, so that the model's name may follow an option; and all of them, so that a second one is
    // seen.
    option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  if (!is_shown)
    option->group("");
  else if (!text.group.empty())
    option->group(std::string(text.group));
}

/// The error for arguments that no option or positional takes: says what may have been meant.
Error unexpectedArgument(const Command& command, const std::string& argument) {
  const std::string help = "mirrorball " + std::string(command.name) + " --help";
  const std::string name = argument.substr(0, argument.find('='));
  if (!name.starts_with('-'))
    return {ErrorCode::usage,
            "'" + argument + "' was not expected; " + hintForWord(command, argument).value_or("see " + help)};
  const auto is_meant = [&](const CommandOption& option) { return name == "--" + std::string(option.text.name); };
  if (std::ranges::any_of(command.options, is_meant))
    return {ErrorCode::usage, "'" + name + "' stands after --, where all words are inputs; put options before it"};
  std::string message = "there is no option " + name;
  const auto hint =
      isFile(argument) ? std::optional("for the file of that name say ./" + argument) : hintForOption(command, name);
  if (hint) message += "; " + *hint;
  return {ErrorCode::usage, message + " (" + help + " lists them)"};
}

/// The error for an option that would be read as a short one with an odd value: "-output" as -o with the value "utput",
/// "-o=a.png" as -o with the value "=a.png".
///
/// errors   usage
Result<void> checkDashes(std::span<const std::string> words, std::span<const Command> commands) {
  const auto command =
      words.empty() ? commands.end() : std::ranges::find(commands, std::string_view(words.front()), &Command::name);
  if (command == commands.end()) return {};
  for (const std::string& word : words) {
    if (word == kEndOfOptions) return {};
    const std::string name = word.substr(0, word.find('='));
    for (const CommandOption& option : command->options) {
      if (name.size() > 2 && name == "-" + std::string(option.text.name))
        return fail(ErrorCode::usage, "'" + name + "': options of more than one letter have two dashes: -" + name);
      const bool is_letter = !option.text.letter.empty() && name == "-" + std::string(option.text.letter);
      if (is_letter && word != name)
        return fail(ErrorCode::usage, "'" + word + "': after a letter no = stands; say " + name + " " +
                                          word.substr(name.size() + 1) + " or --" + std::string(option.text.name) +
                                          word.substr(name.size()));
    }
  }
  return {};
}

/// The error for an argument that is missing, or was taken for an option.
///
/// not_taken   the words that nothing takes
Error missingArgument(const Command& command, const Argument& argument, const std::vector<std::string>& not_taken) {
  const auto option = std::ranges::find_if(not_taken, [](const std::string& word) { return word.starts_with('-'); });
  if (option != not_taken.end()) return unexpectedArgument(command, *option);
  return {ErrorCode::usage, std::string(argument.missing) + ": mirrorball " + synopsisOf(command)};
}

/// The one line of a CLI11 error, in our words where CLI11 speaks of its own types.
///
/// command     null: none was named
/// not_taken   the words that nothing takes
Error parseError(const CLI::ParseError& error, const Command* command, const std::vector<std::string>& not_taken) {
  std::string message = error.what();
  // It puts the name of an exception in front of its own.
  if (message.starts_with("--: ")) message.erase(0, 4);
  if (command == nullptr) return {ErrorCode::usage, message};
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    for (const Argument& argument : command->arguments)
      if (message.starts_with(argument.name)) return missingArgument(*command, argument, not_taken);
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr)
    for (const CommandOption& option : command->options)
      if (const std::string name = "--" + std::string(option.text.name); message.find(name + " ") != std::string::npos)
        return {ErrorCode::usage, name + " is there or not, and takes no value"};
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    for (const CommandOption& option : command->options)
      if (message.substr(0, message.find(':')) == "--" + std::string(option.text.name))
        return {ErrorCode::usage, neededBy(option)};
  return {ErrorCode::usage, message};
}

std::vector<std::string_view> namesOf(std::span<const Command> commands) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

/// The error for an option where a command should be: one of a command's own comes behind that.
Error optionWithoutCommand(const std::string& word, std::span<const Command> commands) {
  std::vector<std::string_view> owners;
  for (const Command& command : commands)
    for (const CommandOption& option : command.options)
      if (word.substr(0, word.find('=')) == "--" + std::string(option.text.name)) owners.push_back(command.name);
  if (owners.empty()) return unknownName("option", word, std::array<std::string_view, 2>{"--help", "--version"});
  return {ErrorCode::usage, "the command comes before its options: " + word + " is one of " + join(owners)};
}

/// The error for a command line without a subcommand, or with a wrong one.
Error missingCommand(const std::vector<std::string>& words, std::span<const Command> commands) {
  const std::string help = "; mirrorball --help tells what each does";
  const std::vector<std::string_view> names = namesOf(commands);
  if (words.empty()) return {ErrorCode::usage, "name a command: " + join(names) + help};
  const std::string& word = words.front();
  if (isFile(word))
    return {ErrorCode::usage, "'" + word + "' is a file; say what is to be done with it: " + join(names) + help};
  Error error = word.starts_with('-') ? optionWithoutCommand(word, commands)
                                      : unknownName("command", word, names, commandMeantBy(word, commands));
  error.message += help;
  return error;
}

bool isCommand(const std::string& word, std::span<const Command> commands) {
  return std::ranges::find(commands, word, &Command::name) != commands.end();
}

/// errors   usage: a word too many behind "help render" or "help materials"
Result<void> checkWordsOfHelp(const std::vector<std::string>& words, std::span<const Command> commands) {
  if (words.size() < 3 || words[0] != "help") return {};
  const bool names_command = isCommand(words[1], commands);
  if (!names_command && words[1] != kMaterials) return {};  // which is said then
  const bool shows_all = names_command && words[2] == kAllOfHelp;
  if (shows_all && words.size() == 3) return {};
  return fail(ErrorCode::usage, "'" + words[shows_all ? 3 : 2] + "' was not expected; say mirrorball help " + words[1] +
                                    (names_command ? ", or mirrorball help " + words[1] + " all" : ""));
}

/// "help render" asks for what "render --help" does, "version" for what "--version" does.
std::vector<std::string> withHelpLast(std::vector<std::string> words, std::span<const Command> commands) {
  if (words.size() == 1 && words.front() == "version") return {"--version"};
  if (words.empty() || words.front() != "help") return words;
  if (words.size() == 1) return {"--help"};
  std::vector<std::string> asked(words.begin() + 1, words.end());
  if (!isCommand(asked.front(), commands)) return {asked.front()};
  asked.insert(asked.begin() + 1, "--help");
  return asked;
}

/// Takes "all" away behind --help.
///
/// returns   whether it was there
bool takeAllOfHelp(std::vector<std::string>& words) {
  if (words.size() < 2 || words.back() != kAllOfHelp) return false;
  const std::string& before = words[words.size() - 2];
  if (before != "--help" && before != "-h") return false;
  words.pop_back();
  return true;
}

/// An option whose value may be missing has one only where a number follows: what else does may be a model's name.
std::vector<std::string> withImpliedValues(std::vector<std::string> words, std::span<const Command> commands) {
  for (const Command& command : commands)
    for (const CommandOption& option : command.options)
      for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string name = "--" + std::string(option.text.name);
        if (option.text.implied.empty() || words.front() != command.name || words[i] != name) continue;
        const bool has_value = i + 1 < words.size() && parseNumber(split(words[i + 1], ',').front());
        if (!has_value) words[i] = name + "=" + std::string(option.text.implied);
      }
  return words;
}

/// CLI11's view of the commands.
struct Reader {
  CLI::App program{
      wrapped("Environment mapping: what mirrors, glass, rough metal and bumpy surfaces look like in a place",
              helpColumns(), 0)};
  std::vector<CLI::App*> apps;

  Reader(std::span<const Command> commands, bool shows_all) {
    const std::string left_out = MIRRORBALL_LEFT_OUT;
    const std::string version =
        std::string("mirrorball ") + MIRRORBALL_VERSION + (left_out.empty() ? "" : "\nbuilt without " + left_out);
    program.name("mirrorball");
    program.formatter(helpFormatter());
    program.set_version_flag("--version", version);
    program.set_help_flag("-h,--help", "Print this help");
    program.footer(
        wrapped("mirrorball help COMMAND tells what a command takes, mirrorball help COMMAND all the options "
                "that few people need too, and mirrorball help materials what --set changes; the pages are "
                "in docs/ and `man mirrorball`.",
                helpColumns(), 0));
    for (const Command& command : commands) {
      CLI::App& app = *program.add_subcommand(std::string(command.name), std::string(command.help));
      app.allow_extras()->set_version_flag("--version", version);
      app.footer(endOfHelp(command, shows_all));
      for (const Argument& argument : command.arguments) addArgumentTo(app, argument);
      for (const CommandOption& option : command.options)
        addOptionTo(app, command, option, shows_all || isInShortHelp(command, option));
      apps.push_back(&app);
    }
    program.allow_extras()->require_subcommand(0, 1);
  }

  /// The subcommand that was named; nothing before it was read.
  const Command* parsed(std::span<const Command> commands) const {
    const auto app = std::ranges::find_if(apps, [](const CLI::App* candidate) { return candidate->parsed(); });
    return app == apps.end() ? nullptr : &commands[static_cast<std::size_t>(app - apps.begin())];
  }

  /// The words behind a subcommand that it does not take.
  std::vector<std::string> notTaken() const {
    std::vector<std::string> words;
    for (const CLI::App* app : program.get_subcommands())
      for (const std::string& word : app->remaining()) words.push_back(word);
    // CLI11 counts what ends the options among them.
    std::erase(words, kEndOfOptions);
    return words;
  }
};

/// errors   usage: no subcommand, or what nothing takes
Result<void> checkAllTaken(const Reader& reader, const Command* command, const std::vector<std::string>& words,
                           std::span<const Command> commands) {
  if (command == nullptr) return tl::unexpected<Error>(missingCommand(words, commands));
  if (const auto extras = reader.program.remaining(); !extras.empty() && extras.front().starts_with('-'))
    return tl::unexpected<Error>(optionWithoutCommand(extras.front(), commands));
  else if (!extras.empty())
    return fail(ErrorCode::usage, "'" + extras.front() + "' was not expected; mirrorball --help tells what may be");
  const std::vector<std::string> extras = reader.notTaken();
  if (!extras.empty()) return tl::unexpected<Error>(unexpectedArgument(*command, extras.front()));
  return {};
}

}  // namespace

Result<Action> readCommandLine(int argc, const char* const* argv, std::span<const Command> commands) {
  const std::vector<std::string> given(argv + std::min(argc, 1), argv + argc);
  MIRRORBALL_TRY_VOID(checkWordsOfHelp(given, commands));
  std::vector<std::string> words = withImpliedValues(withHelpLast(given, commands), commands);
  if (given == std::vector<std::string>{"help", std::string(kMaterials)})
    return Action([]() -> Result<void> {
      std::fputs(helpOnMaterials().c_str(), stdout);
      return {};
    });
  const bool shows_all = takeAllOfHelp(words);
  MIRRORBALL_TRY_VOID(checkDashes(words, commands));
  Reader reader(commands, shows_all);
  try {
    // CLI11 takes them from the last to the first.
    reader.program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& help_or_version) {
    reader.program.exit(help_or_version);
    return Action([]() -> Result<void> { return {}; });
  } catch (const CLI::ParseError& error) {
    return tl::unexpected<Error>(parseError(error, reader.parsed(commands), reader.notTaken()));
  }
  const Command* command = reader.parsed(commands);
  MIRRORBALL_TRY_VOID(checkAllTaken(reader, command, words, commands));
  return command->action;
}

}  // namespace mirrorball::cli
