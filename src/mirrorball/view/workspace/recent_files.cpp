#include "mirrorball/view/workspace/recent_files.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "mirrorball/base/environment_variable.h"
#include "mirrorball/base/file.h"
#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {

std::optional<RecentFiles> RecentFiles::ofUser() {
  const std::string state = environmentVariable("XDG_STATE_HOME").value_or("");
  const std::string home = environmentVariable("HOME").value_or("");
  if (!state.empty()) return RecentFiles(std::filesystem::path(state) / "mirrorball" / "recent.txt");
  if (home.empty()) return std::nullopt;
  return RecentFiles(std::filesystem::path(home) / ".local" / "state" / "mirrorball" / "recent.txt");
}

std::vector<std::string> RecentFiles::list() const {
  constexpr std::size_t kLargest = std::size_t{1} << 16;
  const auto bytes = readFile(file_, kLargest);
  if (!bytes) return {};
  std::vector<std::string> files;
  std::istringstream lines(std::string(bytes->begin(), bytes->end()));
  for (std::string line; files.size() < kMost && std::getline(lines, line);) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(line, ignored)) files.push_back(line);
  }
  return files;
}

void RecentFiles::note(const std::string& path) const {
  std::error_code error;
  const std::string file = std::filesystem::absolute(path, error).lexically_normal().string();
  // A line is a file.
  if (error || !std::filesystem::is_regular_file(file, error) || file.find('\n') != std::string::npos) return;
  std::vector<std::string> files = list();
  files.erase(std::remove(files.begin(), files.end(), file), files.end());
  files.insert(files.begin(), file);
  files.resize(std::min(files.size(), kMost));
  std::string text;
  for (const std::string& each : files) text += each + "\n";
  std::filesystem::create_directories(file_.parent_path(), error);
  (void)writeFile(file_, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

Result<std::string> RecentFiles::keep(const Workspace& workspace) const {
  std::error_code seen_when_writing;
  std::filesystem::create_directories(file_.parent_path(), seen_when_writing);
  std::string path = (file_.parent_path() / "kept.json").string();
  std::filesystem::remove(path, seen_when_writing);  // which may be of another version
  MIRRORBALL_TRY_VOID(saveWorkspace(path, workspace));
  return path;
}

}  // namespace mirrorball
