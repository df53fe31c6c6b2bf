#pragma once

#include <cstdint>
#include <vector>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/observer.h"
#include "mirrorball/image/value_counts.h"

namespace mirrorball {

/// Which maps are made from an environment, and how.
struct BakeSettings {
  int size = 256;  ///< side of a face in level 0 of the specular mip chain; 0: not made
  int levels = 0;  ///< number of mip levels, level 0 included, at most maxLevels(size); 0: down to 4 × 4 texels
  Distribution distribution = Distribution::ggx;
  MipMapping mip_mapping = MipMapping::filament;
  int irradiance_size = 32;            ///< side of a face; 0: not made
  int harmonics_degree = 2;            ///< highest band, up to 4; 0: not made
  int skybox_size = 0;                 ///< side of a face; 0: not made
  glm::mat3 source_from_target{1.0f};  ///< turns the cubes' directions into the environment's
  std::uint64_t memory_meanwhile = 0;  ///< that the caller needs besides, while the maps are made and after [bytes]
  std::uint64_t memory_after = 0;      ///< that the caller needs besides the maps once they are made [bytes]
};

/// The maps of an environment that an engine needs for image-based lighting. (The BRDF table does not depend on an
/// environment: it is made by brdf/brdf_table.h.)
struct BakedMaps {
  std::vector<PrefilterLevel> levels;  ///< of the specular mip chain; none where it is not made
  ImageSet specular = {};              ///< a cube with these levels, three channels of radiance
  EnvironmentMap irradiance = {};      ///< a cube, divided by π
  EnvironmentMap skybox = {};          ///< the environment as it is, a cube
  Harmonics radiance = {};             ///< irradiance is irradianceOf(radiance)
  ValueCounts values = {};             ///< of the environment, if it is a map
};

/// Makes these maps.
///
/// environment   finite; values below 0 are taken as 0, which a remark tells
/// returns       those that the settings ask for
/// errors        too_large, told before anything is made; out_of_range (a value above 1e36 is too bright to be summed);
///               interrupted
/// cost          docs/performance/prefiltering.md; bit-identical for any number of threads
Result<BakedMaps> bake(Environment environment, const BakeSettings& settings = {}, const Observer& observer = {});

}  // namespace mirrorball
