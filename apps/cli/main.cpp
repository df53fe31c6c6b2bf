#include <array>
#include <cstdio>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"

namespace mirrorball::cli {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int report(const Error& error) {
  clearProgress();
  std::fprintf(stderr, "mirrorball: %s\n", error.message.c_str());
  return error.code == ErrorCode::usage ? kWrongUsage : kFailed;
}

/// The one line of a CLI11 error: without the name of the exception that it puts in front of its own.
int reportParseError(const CLI::ParseError& error) {
  std::string message = error.what();
  if (const std::size_t colon = message.find("--: "); colon == 0) message.erase(0, 4);
  return report({ErrorCode::usage, message});
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

/// Codecs refuse what is too large for them; anything else that outgrows the memory ends here.
Result<void> withinMemory(const Action& action) {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "there is not enough memory for this; use smaller inputs or a smaller --size");
  }
}

int run(int argc, char** argv) {
  CLI::App program("Environment mapping: what mirrors, glass, rough metal and bumpy surfaces look like in a place");
  program.name("mirrorball");
  const std::string version = std::string("mirrorball ") + MIRRORBALL_VERSION;
  program.set_version_flag("--version", version);
  program.set_help_flag("-h,--help", "Print this help");
  const std::vector<std::pair<const char*, Action>> commands{
      {"render", addRenderCommand(program)},      {"convert", addConvertCommand(program)},
      {"bake", addBakeCommand(program)},          {"capture", addCaptureCommand(program)},
      {"info", addInfoCommand(program)},          {"photo", addPhotoCommand(program)},
      {"reference", addReferenceCommand(program)}};
  for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
    command->allow_extras();
    command->set_version_flag("--version", version);
  }
  std::vector<std::string_view> names;
  for (const auto& [name, action] : commands) names.emplace_back(name);
  program.allow_extras();
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return program.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    return reportParseError(error);
  }
  if (program.get_subcommands().empty()) return report(missingCommand(argc, argv, names));
  if (const auto extras = program.remaining(); !extras.empty())
    return report({ErrorCode::usage, "'" + extras.front() + "' was not expected; mirrorball --help tells what may be"});
  catchSignals();
  for (const auto& [name, action] : commands) {
    const CLI::App* command = program.get_subcommand(name);
    if (!command->parsed()) continue;
    if (const auto extras = command->remaining(); !extras.empty())
      return report(unexpectedArgument(*command, extras.front()));
    const Result<void> done = withinMemory(action);
    clearProgress();
    if (!done) return report(done.error());
  }
  return kDone;
}

}  // namespace
}  // namespace mirrorball::cli

int main(int argc, char** argv) { return mirrorball::cli::run(argc, argv); }
