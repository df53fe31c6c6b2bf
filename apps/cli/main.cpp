#include <array>
#include <cstdio>
#include <new>

#include "cli/commands.h"
#include "cli/terminal.h"

namespace mirrorball::cli {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;

constexpr std::array<AddCommand, 7> kCommands{addRenderCommand,   addConvertCommand, addBakeCommand,
                                              addCaptureCommand,  addInfoCommand,    addPhotoCommand,
                                              addReferenceCommand};

int report(const Error& error) {
  clearProgress();
  std::fprintf(stderr, "mirrorball: %s\n", error.message.c_str());
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

int run(int argc, char** argv) {
  const Result<Action> action = readCommandLine(argc, argv, kCommands);
  if (!action) return report(action.error());
  catchSignals();
  const Result<void> done = withinMemory(*action);
  clearProgress();
  return done ? kDone : report(done.error());
}

}  // namespace
}  // namespace mirrorball::cli

int main(int argc, char** argv) { return mirrorball::cli::run(argc, argv); }
