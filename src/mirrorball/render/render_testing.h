#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/render/light/environment_light.h"

namespace mirrorball::testing {

/// prepareEnvironment with a cache that lasts as long as this process: tests in the same light prefilter it once, which
/// takes longer than to draw in it.
inline Result<PreparedEnvironment> prepareOnce(const Environment& environment) {
  struct Folder {
    std::filesystem::path path =
        std::filesystem::path(::testing::TempDir()) / ("mirrorball_prepared_" + std::to_string(::getpid()));
    // A run that crashed may have left the folder of another process of that number.
    Folder() { std::filesystem::remove_all(path); }
    ~Folder() {
      std::error_code status;
      std::filesystem::remove_all(path, status);
    }
  };
  static const Folder folder;
  return prepareEnvironment(environment, PrefilterCache(folder.path));
}

}  // namespace mirrorball::testing
