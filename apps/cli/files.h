#pragma once

#include <span>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// Refuses outputs that would overwrite what is read.
///
/// errors   usage
Result<void> refuseOverwriting(std::span<const std::string> inputs, std::span<const std::string> outputs);

/// Refuses an output whose folder is not there, before long work is begun for it.
///
/// errors   usage (no name at all); io
Result<void> checkFolder(const std::string& output);

/// Whether an output names a folder: one that is there, or a name that ends in '/'.
bool isFolder(const std::string& output);

/// Makes a folder, and those above it, if it is not there.
///
/// errors   io
Result<void> makeFolder(const std::string& folder);

/// "turn_007.png" of "turn.png": the name with a suffix before its extension.
std::string suffixed(const std::string& path, const std::string& suffix);

}  // namespace mirrorball::cli
