#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// A workspace of the words of a command line: files to open (withFile), `-e MAP`, `--quality draft`, and options of
/// frameOptions() and materialOptions() as `render` takes them, `--name VALUE` or `--name=VALUE`.
///
/// errors   usage; as withFile's
Result<Workspace> workspaceOf(std::span<const std::string> arguments);

/// The path that somebody has typed, where no shell has read it: ~ at its beginning is the user's home.
std::string typedPath(const std::string& text);

/// The words after `mirrorball render` that draw a half of it; workspaceOf() them shows the same. Of a photograph they
/// name the panorama that the first command of renderCommandLine() writes.
///
/// errors   unsupported: single materials were changed, which no option says
Result<std::vector<std::string>> renderArguments(const Workspace& workspace, std::size_t side);

/// The same as a line for a shell, from `mirrorball render` on; if the map is a photograph, from `mirrorball photo` on.
///
/// errors   as renderArguments'
Result<std::string> renderCommandLine(const Workspace& workspace, std::size_t side);

/// Opens a file as what it is: a model, a panorama or another map of all directions, a photograph of a mirror ball
/// (isLikelyPhotograph), or a workspace.
///
/// path     or the name of a built-in model or environment, or a folder that holds the six faces of a cube
/// errors   not_found; unsupported: it is none of these; as loadWorkspace's
Result<Workspace> withFile(Workspace workspace, const std::string& path);

/// Files that were dropped together, without those that another one stands for: of a cube's six faces the first.
std::vector<std::string> filesToOpen(std::span<const std::string> paths);

}  // namespace mirrorball
