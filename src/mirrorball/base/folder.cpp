#include "mirrorball/base/folder.h"

#include <filesystem>
#include <optional>
#include <system_error>

namespace mirrorball {

bool isFolder(const std::string& output) {
  std::error_code status;
  return output.ends_with('/') || std::filesystem::is_directory(output, status);
}

bool isOneFile(const std::string& output) { return !isFolder(output) && std::filesystem::path(output).has_extension(); }

namespace {

/// What is in a folder's place, or in that of one above it, and is none: a file, or a link that leads to nothing.
std::optional<std::filesystem::path> obstacleTo(const std::string& folder) {
  std::error_code status;
  for (std::filesystem::path above = folder; !above.empty() && above != above.root_path();
       above = above.parent_path()) {
    if (!above.has_filename() || !std::filesystem::exists(std::filesystem::symlink_status(above, status))) continue;
    if (std::filesystem::is_directory(above, status)) return std::nullopt;
    return above;
  }
  return std::nullopt;
}

/// errors   io
Result<void> checkPlaceOf(const std::string& folder) {
  const auto obstacle = obstacleTo(folder);
  if (!obstacle) return {};
  std::error_code status;
  const bool exists = std::filesystem::exists(*obstacle, status);
  return fail(ErrorCode::io, folder + ": cannot be made a folder, since " + obstacle->string() +
                                 (exists ? " is a file" : " is a link that leads to nothing") +
                                 "; name another folder" +
                                 (folder.ends_with('/') ? ", or a file, without / behind it" : ""));
}

}  // namespace

Result<void> makeFolder(const std::string& folder) {
  MIRRORBALL_TRY_VOID(checkPlaceOf(folder));
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  if (status) return fail(ErrorCode::io, folder + ": cannot be made: " + status.message());
  return {};
}

Result<OutputFolder> OutputFolder::make(const std::string& folder) {
  // Before anything counts as made here, which goes away again.
  MIRRORBALL_TRY_VOID(checkPlaceOf(folder));
  std::error_code status;
  std::vector<std::string> made;
  for (std::filesystem::path above = folder; !above.empty() && !std::filesystem::exists(above, status);
       above = above.parent_path())
    if (above.has_filename()) made.push_back(above.string());  // "out/" and "out" are one
  OutputFolder output(std::move(made));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  return output;
}

}  // namespace mirrorball
