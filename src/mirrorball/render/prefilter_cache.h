#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// What takes long to make of an environment for the renderer.
struct Prefiltered {
  ImageSet chain;
  ImageSet irradiance;
};

/// Prefiltered environments in a folder, found by the content of the environment's cube. It is only a convenience: what
/// cannot be read or written there is made anew.
class PrefilterCache {
 public:
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

  /// folder   made when something is first written
  explicit PrefilterCache(std::filesystem::path folder, std::uintmax_t most_bytes = kMostBytes)
      : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// The user's own: $MIRRORBALL_CACHE, $XDG_CACHE_HOME/mirrorball or ~/.cache/mirrorball; nothing where the first is
  /// empty or there is none.
  static std::optional<PrefilterCache> ofUser();

  /// cube     of the environment, its largest level
  std::optional<Prefiltered> find(const ImageSet& cube) const;
  /// Keeps them, and drops what has not been used for longest while all that was kept
  /// takes more than `most_bytes`.
  void keep(const ImageSet& cube, const Prefiltered& prefiltered) const;

 private:
  void dropOldest() const;

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_;
};

}  // namespace mirrorball
