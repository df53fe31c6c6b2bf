#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "mirrorball/base/observer.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// From now on nothing is said but errors, and no progress is shown.
void beQuiet();

/// From now on no error suggests a smaller --size: the command has no such option.
void suggestNoSize();

/// From now on whatever is said has `name` where it would have `path`.
void showAs(const std::string& path, const std::string& name);

/// A text as it is said: with the names of showAs.
std::string shown(std::string text);

/// From now on standard output belongs to a file, and what `tell` and `print` write goes to standard error.
void keepStandardOutputFree();
bool isStandardOutputTaken();

/// A progress bar with the time left, on standard error if that is a terminal; else a line there twice a minute. Stops
/// the work when the program is interrupted.
///
/// unit     what is counted, if `what` leaves that open: "pictures"
ProgressFunction progressBar(const std::string& what, const std::string& unit = {});
/// Whether they are seen.
bool showsProgress();
/// The same with a text that changes.
ProgressFunction progressBar(std::function<std::string()> what, const std::string& unit = {});

/// Says on standard error what was written, if that is a terminal; and notes it (interruption.h).
void announce(const std::string& path);

/// Says what was found out on the way to a file, a line on standard output.
void tell(const std::string& line);

/// Says on standard error how the work went that was asked for.
void tellAside(const std::string& line);

/// Prints text of several lines, each ended by '\n', on standard output, or where that belongs to a file on standard
/// error, as a terminal may show it (base/text.h: printable). A foreign name in it may not end a line, and is made
/// printable by who puts it there.
void print(const std::string& text);

/// Sends off what was printed on standard output, by whomever.
///
/// errors   io: it, or something before it, could not be written, as where a disk is full
Result<void> flushStandardOutput();

/// Says on standard error what the user did not ask for but should know: "note: …".
void remark(const std::string& text);

/// Shows the progress of library work, announces its files, and says its remarks with the options that help.
Observer terminalObserver();

/// An error as it is said: its message, and how the command line mends it.
std::string lineOf(const Error& error);

/// Says on standard error what is wrong.
void complain(const Error& error);

/// What there is to say at the end of many files.
///
/// done     what became of the others: "converted"
/// folder   where they are; empty: nowhere
/// errors   interrupted; bad_file: some failed
Result<void> outcomeOfMany(std::size_t failed, std::size_t all, const std::string& done, const std::string& folder);

/// Removes the bar, so that the next line starts clean.
void clearProgress();

}  // namespace mirrorball::cli
