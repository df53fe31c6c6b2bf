#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mirrorball {

/// Tells when files have changed on the disk. Who writes one may take a while: so it says nothing until a file's time
/// of writing is the same at two askings.
class FileWatch {
 public:
  /// Watches these from now on, as they are.
  void watch(const std::vector<std::string>& files);

  /// Asks the disk.
  ///
  /// returns   whether one has changed since it was watched: once, until it changes again
  bool hasChanged();

 private:
  struct Watched {
    std::string file;
    std::filesystem::file_time_type known;
    std::filesystem::file_time_type seen;  // when it was last asked for
  };
  std::vector<Watched> files_;
};

}  // namespace mirrorball
