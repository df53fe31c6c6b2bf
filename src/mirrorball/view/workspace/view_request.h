#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// The colours of menus and panels.
enum class Theme { dark, light };

/// How a window works, whatever it shows.
struct WindowOptions {
  float frame_ms = 16.0f;  ///< that a picture may take while something moves
  bool waits_for_screen = true;
  Theme theme = Theme::dark;
  std::string keys = {};            ///< that are pressed first, as chordOf writes them, with spaces between
  std::vector<float> pointer = {};  ///< where it is in the picture of a screenshot [pixels]; empty: nowhere
  std::string find = {};            ///< what rows of the panels are found by
  std::string screenshot = {};      ///< the file for what the window would show; empty: it is opened
};

/// The table of them.
std::span<const Option<WindowOptions>> windowOptions();

/// What `view` is asked for.
struct ViewRequest {
  Workspace workspace = {};
  WindowOptions window = {};
  bool wants_help = false;
};

/// Of the words after `mirrorball view`: windowOptions(), --help, and all that workspaceOf takes.
///
/// errors   as workspaceOf's
Result<ViewRequest> viewRequestOf(std::span<const std::string> arguments);

/// What --help prints.
std::string viewHelp();

}  // namespace mirrorball
