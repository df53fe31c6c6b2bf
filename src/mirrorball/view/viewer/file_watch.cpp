#include "mirrorball/view/viewer/file_watch.h"

#include <system_error>
#include <utility>

namespace mirrorball {
namespace {

/// The least time of one that is not there.
std::filesystem::file_time_type timeOf(const std::string& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  return error ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

void FileWatch::watch(const std::vector<std::string>& files) {
  files_.clear();
  for (const std::string& file : files) {
    const auto time = timeOf(file);
    files_.push_back({file, time, time});
  }
}

bool FileWatch::hasChanged() {
  bool has_changed = false;
  for (Watched& each : files_) {
    const auto now = timeOf(each.file);
    const bool rests = std::exchange(each.seen, now) == now;
    // While one is replaced by another it may not be there.
    if (!rests || now == each.known || now == std::filesystem::file_time_type::min()) continue;
    each.known = now;
    has_changed = true;
  }
  return has_changed;
}

}  // namespace mirrorball
