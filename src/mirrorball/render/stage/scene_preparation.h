#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <vector>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/rays/scene_occlusion.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What is made of a scene before frames of a kind show it: kinds with the same preparation show the same scene.
struct ScenePreparation {
  ReliefKind relief = ReliefKind::bump;   ///< bump, steep, cone or geometry: the first of those that are prepared alike
  bool finds_occlusion = false;           ///< what vertices know of the scene
  SceneOcclusionSettings occlusion = {};  ///< where it is found

  bool operator==(const ScenePreparation&) const = default;
};

/// Of frames with those settings.
ScenePreparation preparationFor(const FrameSettings& settings);

/// How what vertices know is found for frames with those settings.
SceneOcclusionSettings occlusionSettingsFor(const FrameSettings& settings);

/// Whether nothing is left to be made. What vertices are known to see (Instance::occlusion) is left as it is, whoever
/// has found it.
bool isPrepared(const Scene& scene, const ScenePreparation& preparation);

/// Leaves what vertices knew of a scene that has changed to be found again.
void forgetOcclusion(Scene& scene);

/// Of a scene that is prepared for ReliefKind::exact, those whose relief is searched for in prisms.
std::vector<int> meshesWithPrisms(const Scene& scene);

/// What preparing takes beside the scene.
struct PreparationMeans {
  std::function<int()> largest_texture = {};  ///< as of prepareRelief
  std::optional<CacheFolder> cache = {};      ///< where occlusion is kept, if it is
  ProgressFunction progress = {};             ///< of finding it
};

/// Makes it: prepareRelief, then findOcclusionOnce.
///
/// scene    as it was loaded
/// errors   as theirs
/// cost     as theirs
Result<void> prepareScene(Scene& scene, const ScenePreparation& preparation, const PreparationMeans& means);

}  // namespace mirrorball
