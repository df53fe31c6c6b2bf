#pragma once

#include "cli/command_line.h"

namespace mirrorball::cli {

/// Each adds its subcommand with all options to the program and returns what it does.
Action addRenderCommand(CLI::App& program);
Action addConvertCommand(CLI::App& program);
Action addBakeCommand(CLI::App& program);
Action addCaptureCommand(CLI::App& program);
Action addInfoCommand(CLI::App& program);
Action addPhotoCommand(CLI::App& program);
Action addReferenceCommand(CLI::App& program);

}  // namespace mirrorball::cli
