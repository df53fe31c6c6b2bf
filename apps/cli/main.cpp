#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/terminal.h"

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

int run(int argc, char** argv) {
  CLI::App program("Environment mapping: what mirrors, glass, rough metal and bumpy surfaces look like in a place");
  program.name("mirrorball");
  program.set_version_flag("--version", std::string("mirrorball ") + MIRRORBALL_VERSION);
  program.set_help_flag("-h,--help", "Print this help");
  const std::vector<std::pair<const char*, Action>> commands{{"render", addRenderCommand(program)},
                                                             {"convert", addConvertCommand(program)},
                                                             {"info", addInfoCommand(program)},
                                                             {"photo", addPhotoCommand(program)},
                                                             {"reference", addReferenceCommand(program)}};
  for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) command->allow_extras();
  program.require_subcommand(1);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return program.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    return reportParseError(error);
  }
  catchInterrupt();
  for (const auto& [name, action] : commands) {
    const CLI::App* command = program.get_subcommand(name);
    if (!command->parsed()) continue;
    if (const auto extras = command->remaining(); !extras.empty())
      return report(unexpectedArgument(*command, extras.front()));
    const Result<void> done = action();
    clearProgress();
    if (!done) return report(done.error());
  }
  return kDone;
}

}  // namespace
}  // namespace mirrorball::cli

int main(int argc, char** argv) { return mirrorball::cli::run(argc, argv); }
