#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// The parts of the renderer's environment that are slow to make.
struct Prefiltered {
  ImageSet chain;
  ImageSet irradiance;
};

/// The sides of those cubes' levels.
struct PrefilteredShape {
  std::vector<int> chain;
  std::vector<int> irradiance;
};

/// Prefiltered environments in a folder, found by the content of the environment's cube. The cache is only a
/// convenience: if something cannot be read or written, it is made again.
class PrefilterCache {
 public:
  /// Increased whenever prefiltering gives other values or the file format changes: older files are then not found.
  static constexpr std::uint32_t kVersion = 7;
  static constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 30;

  /// folder   made when something is first written
  explicit PrefilterCache(std::filesystem::path folder, std::uintmax_t max_bytes = kMaxBytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  /// The user's own: $MIRRORBALL_CACHE, $XDG_CACHE_HOME/mirrorball or ~/.cache/mirrorball; nothing if the first is
  /// empty or none is set. $MIRRORBALL_CACHE_SIZE, as in 500M or 2G, says how large it may grow, else it is kMaxBytes.
  ///
  /// errors   usage: not a size
  static Result<std::optional<PrefilterCache>> ofUser();

  const std::filesystem::path& folder() const { return folder_; }
  std::uintmax_t maxBytes() const { return max_bytes_; }

  /// The contents of the folder.
  struct Contents {
    std::size_t files = 0;
    std::uintmax_t bytes = 0;
  };
  Contents contents() const;

  /// Removes all cached files, and no other file in the folder.
  ///
  /// returns  what was removed
  /// errors   io: a file cannot be removed
  Result<Contents> clear() const;

  /// The key of an environment: hexadecimal digits.
  ///
  /// cube     of the environment; its largest level counts
  /// cost     one pass over its texels
  static std::string keyOf(const ImageSet& cube);

  /// returns  nothing if there is none of that shape
  std::optional<Prefiltered> find(const std::string& key, const PrefilteredShape& shape) const;
  /// Stores them, and removes the least recently used files while the cache takes more than maxBytes().
  ///
  /// format   that holds all values, half or float32
  void keep(const std::string& key, const Prefiltered& prefiltered, TexelFormat format) const;

 private:
  struct Kept {
    std::filesystem::file_time_type used;
    std::filesystem::path path;
    std::uintmax_t bytes;
  };
  std::vector<Kept> kept() const;
  void dropOldest() const;

  std::filesystem::path folder_;
  std::uintmax_t max_bytes_;
};

}  // namespace mirrorball
