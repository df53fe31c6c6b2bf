#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// The files that somebody has opened last, in a file of the user's. It is only a convenience: what cannot be read or
/// written is left out.
class RecentFiles {
 public:
  static constexpr std::size_t kMost = 16;

  /// In that file, which is made with its folder when something is first noted.
  explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

  /// $XDG_STATE_HOME/mirrorball/recent.txt or ~/.local/state/mirrorball/recent.txt; nothing if neither is set.
  static std::optional<RecentFiles> ofUser();

  /// The last first; those that are not there any more are left out.
  std::vector<std::string> list() const;

  /// Notes a file that was opened; what is no file, as a built-in model, is left out.
  void note(const std::string& path) const;

  /// Writes a workspace beside it, over the one before: what somebody has not saved when a program must end.
  ///
  /// returns  the file that was written
  /// errors   io
  Result<std::string> keep(const Workspace& workspace) const;

 private:
  std::filesystem::path file_;
};

}  // namespace mirrorball
