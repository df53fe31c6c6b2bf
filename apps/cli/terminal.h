#pragma once

#include <string>

#include "mirrorball/base/progress.h"

namespace mirrorball::cli {

/// From now on Ctrl-C asks long work to stop at its next step, so that no half file stays; a second one ends the program.
/// And a file beyond the limit for files (ulimit -f) is an error of writing, as on a full disk.
void catchSignals();

/// Whether Ctrl-C was pressed.
bool interrupted();

/// A progress bar with the time left, on standard error if that is a terminal; else silent. Stops the work on Ctrl-C.
ProgressFunction progressBar(const std::string& what);

/// Says on standard error what was written, if that is a terminal.
void announce(const std::string& path);

/// Says on standard error what the user did not ask for but should know.
void remark(const std::string& text);

/// Removes the bar, so that the next line starts clean.
void clearProgress();

}  // namespace mirrorball::cli
