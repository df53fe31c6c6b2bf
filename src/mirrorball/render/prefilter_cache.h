#pragma once

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
  /// folder   made when something is first written
  explicit PrefilterCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The user's own: $MIRRORBALL_CACHE, $XDG_CACHE_HOME/mirrorball or ~/.cache/mirrorball; nothing where the first is
  /// empty or there is none.
  static std::optional<PrefilterCache> ofUser();

  /// cube     of the environment, its largest level
  std::optional<Prefiltered> find(const ImageSet& cube) const;
  /// Keeps them, and drops what has not been used for longest while all take more than 1 GB.
  void keep(const ImageSet& cube, const Prefiltered& prefiltered) const;

 private:
  void dropOldest() const;

  std::filesystem::path folder_;
};

}  // namespace mirrorball
