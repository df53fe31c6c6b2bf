#pragma once

#include <string>

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

/// Removes all that is unfinished. From then on nothing can be begun or finished: whoever tries waits for the end of
/// the program, which must follow.
void removeUnfinished();

}  // namespace mirrorball
