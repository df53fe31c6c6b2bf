#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/cache_folder.h"
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

/// Prefiltered environments in a cache, found by the content of the environment's cube.
class PrefilterCache {
 public:
  /// Increased whenever prefiltering gives other values or the file format changes: older files are then not found.
  static constexpr std::uint32_t kVersion = 7;

  explicit PrefilterCache(CacheFolder folder) : folder_(std::move(folder)) {}

  /// The key of an environment.
  ///
  /// cube     of the environment; its largest level counts
  /// cost     one pass over its texels
  static std::string keyOf(const ImageSet& cube);

  /// returns  nothing if there is none of that shape
  std::optional<Prefiltered> find(const std::string& key, const PrefilteredShape& shape) const;
  /// format   that holds all values, half or float32
  void keep(const std::string& key, const Prefiltered& prefiltered, TexelFormat format) const;

 private:
  CacheFolder folder_;
};

}  // namespace mirrorball
