#pragma once

#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// Refuses an output that would overwrite what is being read.
///
/// errors   usage
Result<void> refuseOverwriting(const std::string& input, const std::string& output);

/// "turn_007.png" of "turn.png": the name with a suffix before its extension.
std::string suffixed(const std::string& path, const std::string& suffix);

}  // namespace mirrorball::cli
