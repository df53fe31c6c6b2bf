#pragma once

#include <string>
#include <vector>

#include "mirrorball/environment/file/load.h"

namespace mirrorball::cli {

/// loadEnvironment, whose error names the command for a file that is a model; says what it doubts.
///
/// errors   as loadEnvironment's
Result<LoadedEnvironment> loadMap(const std::string& name_or_path, const EnvironmentLoadOptions& options = {},
                                  const ProgressFunction& progress = {});

/// The error of reading a map, which names the command for a file that is a model.
Error ofMap(const std::string& input, Error error);

/// The inputs without those that stand for the same cube as one before them: its six files, as a shell lists them. Says
/// so.
std::vector<std::string> withEachCubeOnce(const std::vector<std::string>& inputs, const FormHint& from);

}  // namespace mirrorball::cli
