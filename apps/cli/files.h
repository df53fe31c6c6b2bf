#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "mirrorball/base/folder.h"
#include "mirrorball/base/result.h"

namespace mirrorball::cli {

/// Refuses a file whose folder is not there, before long work is begun for it. It is not made: a slip in its name would
/// go unnoticed. A folder that is itself the output is (makeFolder).
///
/// errors   usage (a folder's name); io
Result<void> checkFolder(const std::string& output);

/// Refuses a name that two outputs have, of which one would be lost.
///
/// errors   usage
Result<void> refuseSharedNames(std::span<const std::string> outputs);

/// Refuses --exposure, --tone-map and --resolve, which say how light becomes a picture, for an output that holds light.
///
/// instead  what else may be done: ", or scale the light"; empty: nothing
/// errors   usage: one of them was given
Result<void> refusePictureOptions(const GivenOptions& given, const std::string& output, const std::string& instead);

/// A name in a folder for each of many inputs: its own, without the folders before it and its extension, and an ending.
/// Of a folder with a cube's six files it is the folder's, of a built-in environment that without parameters.
///
/// ending   of an input's own name: ".exr", or nothing
/// errors   usage: two inputs would get the same
Result<std::vector<std::string>> namesInFolder(
    const std::vector<std::string>& inputs, const std::string& folder,
    const std::function<Result<std::string>(const std::filesystem::path& name)>& ending);

/// The error for several inputs and an output that is one file: names them, since one may be a word too many.
Error manyForOneFile(const std::string& output, const std::vector<std::string>& inputs);

/// Whether a name ends as a file that can be written does.
bool isOutputName(const std::string& name);

/// Refuses `IN OUT`, without -o: the last of several words is no file, and a name for one.
///
/// is_output  whether such a name could be an output's
/// errors     usage
Result<void> refuseUnnamedOutput(const std::vector<std::string>& inputs,
                                 const std::function<bool(const std::string&)>& is_output);

}  // namespace mirrorball::cli
