#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace mirrorball::testing {

/// A real input from the shared data folder, which is no part of the repository: $MIRRORBALL_DATA, else
/// ../shared/data beside the checkout. Nothing where it is absent: the test then skips itself and says so.
inline std::optional<std::filesystem::path> sharedData(const char* name) {
  const char* folder = std::getenv("MIRRORBALL_DATA");
  const std::filesystem::path path =
      (folder ? std::filesystem::path(folder) : std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "../shared/data") / name;
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) return std::nullopt;
  return path;
}

/// Whether the code under test is built with the sanitizers (tests/sanitized).
inline bool isSanitized() { return std::getenv("MIRRORBALL_SANITIZED") != nullptr; }

}  // namespace mirrorball::testing
