#pragma once

#include <vector>

#include "cli/command.h"

namespace mirrorball::cli {

/// Each makes one subcommand with all its options.
Command renderCommand();
Command convertCommand();
Command bakeCommand();
Command captureCommand();
Command exportCommand();
Command infoCommand();
Command lightsCommand();
Command compareCommand();
Command contactCommand();
Command photoCommand();
Command surfaceCommand();
Command transferCommand();
Command studyCommand();
Command fresnelCommand();
Command cacheCommand();
Command referenceCommand();

/// All of them, in the order of the help, with the options that every one has.
std::vector<Command> allCommands();

}  // namespace mirrorball::cli
