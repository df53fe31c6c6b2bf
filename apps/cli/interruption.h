#pragma once

#include <cstddef>
#include <string>

namespace mirrorball::cli {

/// From now on Ctrl-C, SIGTERM and a terminal that goes away (SIGHUP) ask long work to stop at its next step, so that
/// no half file stays. Where that takes longer than a quarter of a second, as inside of other libraries, the program
/// takes its half files away and ends all the same; a second signal ends it at once. Signals that whoever started the
/// program had ignored stay ignored (nohup). And a file beyond the limit for files (ulimit -f) is an error of writing,
/// as on a full disk.
void catchSignals();

/// Whether one of them came.
bool interrupted();

/// What is said where the program ends before its work has stopped. Without it that is "interrupted; nothing was
/// written", and from noteWritten on that what was finished stays.
void whenInterrupted(const std::string& message);

/// Notes that a file is finished.
void noteWritten();

/// "interrupted after 3 of 200 pictures; those are whole", and "interrupted; nothing was written" before the first one.
std::string interruptedAfter(std::size_t whole, std::size_t all);

/// "interrupted; what was finished stays in out"
std::string interruptedAmongMany(const std::string& folder);

/// From now on the program ends as its caller ends it: to be called before an outcome is told, or before work that an
/// interruption must not cut off. Does not return where the program is ending already. May be called again, and
/// by several threads.
void claimEnd();

/// Ends the program by the signal that came, if one did: whoever started it, a loop of a shell, then knows why.
void endByCaughtSignal();

}  // namespace mirrorball::cli
