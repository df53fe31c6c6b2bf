#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// Puts the path of a file in the place of each input that is "-": of standard input, which becomes a file in memory
/// first where it is none yet, so that it can be read from any place and more than once.
///
/// inputs   names as the user gave them
/// errors   usage (nothing is piped in: it is a terminal; more than one asks for it); io; bad_file (it begins neither
///          as an image nor as a model); too_large: more than memoryLimit()
Result<void> readStandardInput(const std::vector<std::string*>& inputs);

/// Runs work whose output may be "-.EXTENSION", which is standard output in that format: then the work writes an
/// unnamed file (UnnamedOutput), whose bytes follow when it is finished, so that nothing stays of a run that is killed.
/// All messages go to standard error.
///
/// output   as the user gave it; while the work runs, the name of the file
/// errors   usage ("-" alone tells no format; it is a terminal); io; as the work's
Result<void> writeStandardOutput(std::string& output, const std::function<Result<void>()>& work);

/// Both.
Result<void> withStandardStreams(const std::vector<std::string*>& inputs, std::string& output,
                                 const std::function<Result<void>()>& work);

/// The same for a list of inputs.
std::vector<std::string*> pointersTo(std::vector<std::string>& inputs);

}  // namespace mirrorball::cli
