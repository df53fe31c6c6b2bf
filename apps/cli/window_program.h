#pragma once

#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// Becomes the program of the window, which is a file of its own beside this one: who draws pictures alone need not
/// have what windows need.
///
/// words     after `mirrorball view`, with a null at the end
/// returns   only if it cannot
/// errors    not_found
Result<void> becomeWindow(char* const* words);

}  // namespace mirrorball::cli
