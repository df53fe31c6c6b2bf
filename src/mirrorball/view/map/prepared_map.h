#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/light_edit/map_lamp.h"
#include "mirrorball/view/map/faulty_texels.h"
#include "mirrorball/view/map/map_view_settings.h"
#include "mirrorball/view/map/waveform.h"

namespace mirrorball {

/// A map with all that takes long to find of it. It does not change: copies share its images.
struct PreparedMap {
  static constexpr int kMostLamps = 16;
  static constexpr float kLeastShareOfLamp = 1e-3f;

  using Light = std::shared_ptr<const Environment>;

  Light given;                          ///< as it was loaded, with texels that are no light
  Light mended;                         ///< without them: mendFaults; the same where there are none
  std::vector<Light> mips = {};         ///< cubes, from about the map's own detail down to one texel a face
  std::vector<Light> prefiltered = {};  ///< cubes, for levels 1 and up of a chain whose last has roughness 1
  Harmonics harmonics = {};             ///< of the radiance, up to MapViewSettings::kMaxDegree
  FaultyTexels faulty = {};
  std::vector<MapLamp> lamps = {};  ///< the strongest, at most kMostLamps
  Waveform waveform = {};           ///< of a panorama of at most 1024 × 512 texels
  /// The light of a photograph that it was unwrapped from; null: it was from none.
  std::shared_ptr<const Image> photograph = {};
};

/// Finds it. May go on beside others (BackgroundTask).
///
/// environment  as loaded with EnvironmentLoadOptions::keep_bad: NaN, infinite and negative values may be in it
/// cache        where prefiltered environments are kept; optional
/// errors       too_large; interrupted (when `progress` says so)
/// cost         that of prepareEnvironment, 0.7 s on one core for a panorama of 1024 × 512; memory of about 1.7 times
///              the map besides it, and of one map more if something had to be mended. Bit-identical for any number of
///              threads
Result<PreparedMap> prepareMap(Environment environment, const std::optional<CacheFolder>& cache = {},
                               const ProgressFunction& progress = {});

/// The light of one of the sources that are mixed, and its share.
struct LightShare {
  PreparedMap::Light light;
  float share = 1.0f;
};

/// The light that settings choose, of the sources that show it: the shares sum to 1.
///
/// texels_per_radian  detail that is enough: of a map with more, the smallest mip level that has it, in which no light
///                    is lost, so that a picture costs what its pixels cost however large the map is. Infinite: all
std::vector<LightShare> lightOf(const PreparedMap& map, const MapViewSettings& settings, float texels_per_radian);

/// The radiance in a direction (unit) of what settings choose, with all its detail.
glm::vec3 shownRadiance(const PreparedMap& map, const MapViewSettings& settings, glm::vec3 direction);

}  // namespace mirrorball
