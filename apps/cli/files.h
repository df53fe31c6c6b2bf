#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "mirrorball/base/result.h"
#include "mirrorball/base/unfinished.h"

namespace mirrorball::cli {

/// Refuses outputs that would overwrite what is read.
///
/// errors   usage
Result<void> refuseOverwriting(std::span<const std::string> inputs, std::span<const std::string> outputs);

/// Refuses a file whose folder is not there, before long work is begun for it. It is not made: a slip in its name would
/// go unnoticed. A folder that is itself the output is (makeFolder).
///
/// errors   usage (no name at all, or a folder's); io
Result<void> checkFolder(const std::string& output);

/// Refuses --exposure, --tone-map and --resolve, which say how light becomes a picture, for an output that holds light.
///
/// instead  what else may be done: ", or scale the light"; empty: nothing
/// errors   usage: one of them was given
Result<void> refusePictureOptions(const GivenOptions& given, const std::string& output, const std::string& instead);

/// Whether an output names a folder: one that is there, or a name that ends in '/'.
bool isFolder(const std::string& output);

/// Makes a folder, and those above it, if it is not there.
///
/// errors   io
Result<void> makeFolder(const std::string& folder);

/// A folder for files that belong together. What was not there before goes away again with all that was put into it,
/// unless it is kept.
class OutputFolder {
 public:
  /// errors   io
  static Result<OutputFolder> make(const std::string& folder);

  /// Whether it was not there before.
  bool isNew() const { return !made_.empty(); }
  void keep() { made_.keep(); }

 private:
  explicit OutputFolder(std::string made) : made_(std::move(made)) {}

  UnfinishedPath made_;  // the uppermost folder that was made
};

/// A name in a folder for each of many inputs: its own, without the folders before it and its extension, and an ending. Of
/// a folder with a cube's six files it is the folder's, of a built-in environment that without parameters.
///
/// ending   of an input's own name: ".exr", or nothing
/// errors   usage: two inputs would get the same
Result<std::vector<std::string>> namesInFolder(
    const std::vector<std::string>& inputs, const std::string& folder,
    const std::function<Result<std::string>(const std::filesystem::path& name)>& ending);

/// The error for several inputs and an output that is one file: names them, since one may be a word too many.
Error manyForOneFile(const std::string& output, const std::vector<std::string>& inputs);

/// "exr", also of ".exr".
std::string withoutDot(const std::string& extension);

/// Whether a name ends as a file that can be written does.
bool isOutputName(const std::string& name);

/// Refuses `IN OUT`, without -o: the last of several words is no file, and a name for one.
///
/// is_output  whether such a name could be an output's
/// errors     usage
Result<void> refuseUnnamedOutput(const std::vector<std::string>& inputs,
                                 const std::function<bool(const std::string&)>& is_output);

/// "turn_007.png" of "turn.png": the name with a suffix before its extension.
std::string suffixed(const std::string& path, const std::string& suffix);

}  // namespace mirrorball::cli
