#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Whether a file's name has a place for a picture's number: "%04d" as printf has it, or at least two "#", a digit
/// each.
bool hasNumberPlace(const std::string& path);

/// The files of pictures that are numbered from 0, of a name with one place for the number; of one without, that comes
/// before the extension.
///
/// errors   usage: the name has several places
Result<std::vector<std::string>> numberedPaths(const std::string& output, int count);

}  // namespace mirrorball
