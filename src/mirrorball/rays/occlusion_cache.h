#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/rays/scene_occlusion.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What vertices know of their scene (findOcclusion) in a cache, found by the content of all that it is found from.
class OcclusionCache {
 public:
  /// Increased whenever findOcclusion gives other values or the file format changes: older files are then not found.
  static constexpr std::uint32_t kVersion = 1;
  /// Of fewer rays nothing is kept: 20 ms on one core.
  static constexpr std::size_t kFewestRays = 40'000;

  explicit OcclusionCache(CacheFolder folder) : folder_(std::move(folder)) {}

  /// Whether so much is to be found that it is worth a file.
  static bool isWorthAFile(const Scene& scene, const SceneOcclusionSettings& settings);

  /// The key of a scene: of its instances, meshes, the numbers of their materials, and the textures that findOcclusion
  /// reads.
  ///
  /// cost     one pass over them, on all cores for the textures
  static std::string keyOf(const Scene& scene, const SceneOcclusionSettings& settings);

  /// Sets Instance::occlusion, and with `has_looks` Instance::looks, of all instances.
  ///
  /// returns  false: there is none, or it is damaged; then the scene is as before
  bool find(const std::string& key, bool has_looks, Scene& scene) const;
  void keep(const std::string& key, bool has_looks, const Scene& scene) const;

 private:
  CacheFolder folder_;
};

/// findOcclusion, unless the cache has it; then it is kept there.
///
/// errors   as findOcclusion's and Geometry::make's
Result<void> findOcclusionOnce(Scene& scene, const SceneOcclusionSettings& settings,
                               const std::optional<CacheFolder>& cache, const ProgressFunction& progress = {});

}  // namespace mirrorball
