#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/rays/scene_occlusion.h"
#include "mirrorball/scene/mesh_refinement.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What vertices know of their scene (findOcclusion) in a cache, found by the content of all that it is found from.
class OcclusionCache {
 public:
  /// Increased whenever findOcclusion gives other values or the file format changes: older files are then not found.
  static constexpr std::uint32_t kVersion = 5;
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

  /// Cuts the scene's meshes, and sets Instance::occlusion, and with `has_materials` Instance::vertex_materials, of all
  /// instances.
  ///
  /// returns  false: there is none, or it is damaged; then the scene is as before
  bool find(const std::string& key, bool has_materials, Scene& scene) const;
  /// refinements   how the scene's meshes have been cut; one for each
  void keep(const std::string& key, bool has_materials, const Scene& scene,
            std::span<const MeshRefinement> refinements) const;

 private:
  CacheFolder folder_;
};

/// Cuts the meshes if that is asked for, and then findOcclusion, unless the cache has both; then they are kept there.
///
/// errors   as findOcclusion's and Geometry::make's; meshes may then have been cut
Result<void> findOcclusionOnce(Scene& scene, const SceneOcclusionSettings& settings,
                               const std::optional<CacheFolder>& cache, const ProgressFunction& progress = {});

}  // namespace mirrorball
