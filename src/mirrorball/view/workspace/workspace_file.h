#pragma once

#include <string>
#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// A workspace as JSON, which readWorkspace reads: names of files as they are in it, and options as a command line has
/// them, so that people can read and write it too.
std::string writtenWorkspace(const Workspace& workspace);

/// The workspace of a JSON. What it does not name is as in a new one; so files of older programs are read.
///
/// errors   bad_file: no JSON, or no workspace (the key is named); usage: an option that there is not, or a text that
///          it refuses
Result<Workspace> readWorkspace(std::string_view json);

/// Refuses a file that a workspace shows, as an output in its place.
///
/// errors   usage
Result<void> refuseInputs(const Workspace& workspace, const std::string& path);

/// Writes it to a file, in which there may be another workspace, and reads it. The names of its model and its maps
/// are seen from the file's folder if they lie in it, else absolute: both move together, and it is the same from any
/// folder.
///
/// errors   io; usage: something else is in the file; as refuseInputs' and readWorkspace's
Result<void> saveWorkspace(const std::string& path, const Workspace& workspace);
Result<Workspace> loadWorkspace(const std::string& path);

}  // namespace mirrorball
