#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/observer.h"
#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What says by which techniques a scene is drawn.
struct TechniqueWishes {
  Quality quality = Quality::draft;
  std::set<std::string_view> given = {};  ///< names of options that stay as they are
  bool has_strong_sun = false;            ///< SceneTraits'
  bool objects_move = false;              ///< among each other, from picture to picture
  bool needs_all = false;                 ///< where what is chosen is too large for the scene, that is an error
};

/// Fills in what a scene needs of what was not given (fillIn), and finds what its vertices are to know. Where that is
/// too large for the scene and nobody has asked for it, the scene goes without it.
///
/// scene     with its relief (prepareRelief)
/// cache     where occlusion is kept; optional
/// observer  told how far the occlusion is, and how long it takes
/// returns   what was chosen, as fillIn does
/// errors    as hidesItself's and findOcclusionOnce's
/// cost      as theirs
Result<std::string> chooseTechniques(Scene& scene, const TechniqueWishes& wishes, FrameSettings& settings,
                                     const std::optional<CacheFolder>& cache = {}, const Observer& observer = {});

}  // namespace mirrorball
