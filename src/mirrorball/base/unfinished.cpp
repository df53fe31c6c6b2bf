#include "mirrorball/base/unfinished.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace mirrorball {
namespace {

/// All that is unfinished in this process. It outlives every thread that may ask for it.
struct UnfinishedPaths {
  std::mutex guard;
  std::multiset<std::string> paths;
};
UnfinishedPaths& unfinishedPaths() {
  static auto* const all = new UnfinishedPaths;
  return *all;
}

void removeWithAllInIt(const std::string& path) {
  std::error_code status;
  std::filesystem::remove_all(path, status);
}

}  // namespace

UnfinishedPath::UnfinishedPath(std::string path) : path_(std::move(path)) {
  if (path_.empty()) return;
  const std::scoped_lock lock(unfinishedPaths().guard);
  unfinishedPaths().paths.insert(path_);
}

UnfinishedPath::UnfinishedPath(UnfinishedPath&& other) noexcept : path_(std::exchange(other.path_, {})) {}

void UnfinishedPath::keep() {
  if (path_.empty()) return;
  const std::scoped_lock lock(unfinishedPaths().guard);
  auto& paths = unfinishedPaths().paths;
  paths.erase(paths.find(std::exchange(path_, {})));
}

bool UnfinishedPath::finishAs(const std::string& name) {
  {
    const std::scoped_lock lock(unfinishedPaths().guard);
    if (std::rename(path_.c_str(), name.c_str()) == 0) {
      auto& paths = unfinishedPaths().paths;
      paths.erase(paths.find(std::exchange(path_, {})));
      return true;
    }
  }
  const int why = errno;
  remove();
  errno = why;
  return false;
}

void UnfinishedPath::remove() {
  if (path_.empty()) return;
  removeWithAllInIt(path_);
  keep();
}

void removeUnfinished() {
  // For good: nothing that the other threads still do may stay.
  unfinishedPaths().guard.lock();
  for (const std::string& path : unfinishedPaths().paths) removeWithAllInIt(path);
}

}  // namespace mirrorball
