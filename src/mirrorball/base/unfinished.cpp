#include "mirrorball/base/unfinished.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace mirrorball {

namespace fs = std::filesystem;

struct UnfinishedFolder::Content {
  std::vector<std::string> folders;  ///< the innermost first
  std::vector<std::string> files;

  bool holds(const std::string& file) const;
  void remove() const;
};

namespace {

/// All that is unfinished in this process. It outlives every thread that may ask for it.
struct UnfinishedPaths {
  std::mutex guard;
  std::multiset<std::string> paths;
  std::set<std::shared_ptr<UnfinishedFolder::Content>> contents;
};
UnfinishedPaths& unfinishedPaths() {
  static auto* const all = new UnfinishedPaths;
  return *all;
}

void removeWithAllInIt(const std::string& path) {
  std::error_code status;
  fs::remove_all(path, status);
}

/// Without links' being followed, so that two spellings of one place are the same.
fs::path absolutePath(const std::string& path) {
  std::error_code status;
  const fs::path absolute = fs::absolute(path, status).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

}  // namespace

bool UnfinishedFolder::Content::holds(const std::string& file) const {
  return absolutePath(file).parent_path() == absolutePath(folders.front());
}

void UnfinishedFolder::Content::remove() const {
  std::error_code status;
  for (const std::string& file : files) fs::remove(file, status);
  // A folder that is not empty is not removed, and neither are those above it.
  for (const std::string& folder : folders) fs::remove(folder, status);
}

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
      for (const auto& content : unfinishedPaths().contents)
        if (content->holds(name)) content->files.push_back(name);
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

UnfinishedFolder::UnfinishedFolder(std::vector<std::string> folders) {
  if (folders.empty()) return;
  content_ = std::make_shared<Content>(Content{std::move(folders), {}});
  const std::scoped_lock lock(unfinishedPaths().guard);
  unfinishedPaths().contents.insert(content_);
}

UnfinishedFolder::~UnfinishedFolder() {
  if (empty()) return;
  content_->remove();
  keep();
}

void UnfinishedFolder::keep() {
  if (empty()) return;
  const std::scoped_lock lock(unfinishedPaths().guard);
  unfinishedPaths().contents.erase(std::exchange(content_, nullptr));
}

void removeUnfinished() {
  // For good: nothing that the other threads still do may stay.
  unfinishedPaths().guard.lock();
  for (const std::string& path : unfinishedPaths().paths) removeWithAllInIt(path);
  for (const auto& content : unfinishedPaths().contents) content->remove();
}

}  // namespace mirrorball
