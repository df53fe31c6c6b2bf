#pragma once

#include <memory>
#include <string>
#include <vector>

namespace mirrorball {

/// A file or a folder that must not stay unless it gets finished: it is removed, with all that is in it, when its owner
/// goes away. A program that cannot wait for that, when it is interrupted, calls removeUnfinished.
class UnfinishedPath {
 public:
  UnfinishedPath() = default;
  /// path     of what will be made; empty: nothing
  explicit UnfinishedPath(std::string path);
  UnfinishedPath(UnfinishedPath&& other) noexcept;
  UnfinishedPath& operator=(UnfinishedPath&&) = delete;
  ~UnfinishedPath() { remove(); }

  const std::string& path() const { return path_; }
  bool empty() const { return path_.empty(); }

  /// Lets it stay as it is.
  void keep();

  /// Gives a file its name. Where that fails it is removed; errno says why.
  bool finishAs(const std::string& name);

  /// Removes it now.
  void remove();

 private:
  std::string path_;
};

/// New folders whose files belong together. Unless they are kept, the files that this process finished in them
/// (UnfinishedPath::finishAs) are removed when the owner goes away, and then those folders that are empty: what another
/// program puts there stays.
class UnfinishedFolder {
 public:
  /// folders   those that are made here, the innermost first; none: nothing will be removed
  explicit UnfinishedFolder(std::vector<std::string> folders);
  UnfinishedFolder(UnfinishedFolder&&) noexcept = default;
  UnfinishedFolder& operator=(UnfinishedFolder&&) = delete;
  ~UnfinishedFolder();

  bool empty() const { return content_ == nullptr; }

  /// Lets them stay with all that is in them.
  void keep();

  /// The folders, and the files that were finished in them.
  struct Content;

 private:
  std::shared_ptr<Content> content_;
};

/// Removes all that is unfinished. From then on nothing can be begun or finished: whoever tries waits for the end of
/// the program, which must follow.
void removeUnfinished();

}  // namespace mirrorball
