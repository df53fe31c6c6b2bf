#include "mirrorball/base/folder.h"

#include <filesystem>
#include <system_error>

namespace mirrorball {

bool isFolder(const std::string& output) {
  std::error_code status;
  return output.ends_with('/') || std::filesystem::is_directory(output, status);
}

bool isOneFile(const std::string& output) { return !isFolder(output) && std::filesystem::path(output).has_extension(); }

Result<void> makeFolder(const std::string& folder) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  if (status) return fail(ErrorCode::io, folder + ": cannot be made: " + status.message());
  return {};
}

Result<OutputFolder> OutputFolder::make(const std::string& folder) {
  std::error_code status;
  std::string made;
  for (std::filesystem::path above = folder; !above.empty() && !std::filesystem::exists(above, status);
       above = above.parent_path())
    made = above.string();
  OutputFolder output(std::move(made));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  return output;
}

}  // namespace mirrorball
