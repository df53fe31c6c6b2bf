#include <cstdio>
#include <new>
#include <string_view>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/terminal.h"
#include "cli/window_program.h"

namespace mirrorball::cli {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

int report(const Error& error) {
  complain(error);
  return error.code == ErrorCode::usage ? kWrongUsage : kFailed;
}

/// Codecs refuse what is too large for them; anything else that outgrows the memory ends here.
Result<void> withinMemory(const Action& action) {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "there is not enough memory for this; use smaller inputs or a smaller --size");
  }
}

int run(int argc, const char* const* argv) {
  const std::vector<Command> commands = allCommands();
  const Result<Action> action = readCommandLine(argc, argv, commands);
  if (!action) return report(action.error());
  catchSignals();
  Result<void> done = withinMemory(*action);
  claimEnd();
  clearProgress();
  if (done) done = flushStandardOutput();
  const int exit_code = done ? kDone : report(done.error());
  endByCaughtSignal();
  return exit_code;
}

}  // namespace
}  // namespace mirrorball::cli

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "view") {
    const auto opened = mirrorball::cli::becomeWindow(argv + 2);
    return mirrorball::cli::report(opened.error());
  }
  return mirrorball::cli::run(argc, argv);
}
