#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace mirrorball {

/// What stands below each of many inputs: its file's name, after as many of the folders above it as tell it from others
/// of that name.
///
/// names    of the inputs: paths, or built-ins
std::vector<std::string> cellLabels(std::span<const std::string> names);

/// A text with "..." in its middle where it is longer than that many letters, so that the extension stays.
///
/// letters  ASCII (plainLetters)
std::string shortenedInTheMiddle(const std::string& letters, std::size_t longest);

}  // namespace mirrorball
