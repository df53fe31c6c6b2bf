#pragma once

#include <functional>

#include "cli/command_line.h"
#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// What a subcommand does once the command line is read; its Error becomes the exit code.
using Action = std::function<Result<void>()>;

/// Each adds its subcommand with all options to the program and returns what it does.
Action addRenderCommand(CLI::App& program);
Action addConvertCommand(CLI::App& program);
Action addBakeCommand(CLI::App& program);
Action addCaptureCommand(CLI::App& program);
Action addInfoCommand(CLI::App& program);
Action addPhotoCommand(CLI::App& program);
Action addReferenceCommand(CLI::App& program);

}  // namespace mirrorball::cli
