#pragma once

#include <vector>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/observer.h"

namespace mirrorball {

/// What is made of an environment, and how.
struct BakeSettings {
  int size = 256;  ///< a face's side of level 0 of the specular chain, at least 1
  int levels = 0;  ///< of the chain, level 0 included, at most maxLevels(size); 0: down to 4 × 4 texels a face
  Distribution distribution = Distribution::ggx;
  MipMapping mip_mapping = MipMapping::filament;
  int irradiance_size = 32;            ///< a face's side; 0: none is made
  int harmonics_degree = 2;            ///< the last band, up to 4; 0: none are made
  int skybox_size = 0;                 ///< a face's side; 0: none is made
  glm::mat3 source_from_target{1.0f};  ///< turns the cubes' directions into the environment's
};

/// The maps of an environment that an engine needs for image-based lighting. (The BRDF table, which is of no environment, is
/// brdf/brdf_table.h's.)
struct BakedMaps {
  std::vector<PrefilterLevel> levels;  ///< of the chain
  ImageSet specular;                   ///< a cube with these levels, three channels of radiance
  EnvironmentMap irradiance = {};      ///< a cube, divided by π
  EnvironmentMap skybox = {};          ///< the environment as it is, a cube
  Harmonics radiance = {};             ///< irradiance is irradianceOf(radiance)
};

/// Makes them.
///
/// environment   finite
/// returns       those that the settings ask for
/// errors        too_large; interrupted
/// cost          docs/performance.md; bit-identical for any number of threads
Result<BakedMaps> bake(Environment environment, const BakeSettings& settings = {}, const Observer& observer = {});

/// The levels of the chain that these settings describe.
std::vector<PrefilterLevel> levelsOf(const BakeSettings& settings);

/// The memory that `bake` takes at a time, at most [bytes], the environment and what it returns included.
std::uint64_t memoryToBake(const Environment& environment, const BakeSettings& settings);

}  // namespace mirrorball
