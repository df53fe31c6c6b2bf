#pragma once

#include <string>

#include "mirrorball/environment/file/load.h"

namespace mirrorball::cli {

/// loadEnvironment, whose error names the command for a file that is a model; says what it doubts.
///
/// errors   as loadEnvironment's
Result<LoadedEnvironment> loadMap(const std::string& name_or_path, const EnvironmentLoadOptions& options = {},
                                  const ProgressFunction& progress = {});

}  // namespace mirrorball::cli
