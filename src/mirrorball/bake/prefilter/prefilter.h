#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mirrorball/bake/prefilter/blurred_light.h"
#include "mirrorball/bake/prefilter/lobe.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Which roughness each level of a chain is for; docs/prefiltering.md has a table of them.
enum class MipMapping {
  filament,   ///< lod = M r (2 − r)
  linear,     ///< lod = M r
  unreal,     ///< lod = M + 1.2 log₂ r
  unity,      ///< lod = M r (1.7 − 0.7 r)
  frostbite,  ///< lod = M √r
  babylon,    ///< lod = 0.8 log₂(w α), w texels a side of level 0, whatever M is: the last levels have an α above 1
  gltf,       ///< lod = M (1 + log₂ α / log₂ w)
};

/// The perceptual roughness of a level, from 1 to `last`, the level of roughness 1 (but for babylon). Level 0 is a
/// mirror: 0.
///
/// size     of level 0 [texels]
float roughnessOfLevel(MipMapping mapping, int level, int last, int size);

struct PrefilterOptions {
  int size = 256;  ///< of level 0, at least 1
  Distribution distribution = Distribution::ggx;
  MipMapping mip_mapping = MipMapping::filament;
  int levels = 0;  ///< at most maxLevels(size); 0: to lastLevel(size)
};

/// The last level of a chain that has at least 4² texels a face: 0 for sizes below 8.
int lastLevel(int size);

/// The number of levels down to 1² texel per face.
int maxLevels(int size);

/// One level of a chain.
struct PrefilterLevel {
  int size;  ///< texels a side
  float perceptual_roughness;
  std::optional<Lobe> lobe;  ///< nothing: the environment itself
};

/// The levels of a chain; the last one has roughness 1, but for MipMapping::babylon. The first one is the environment
/// itself, and so are the next ones if their lobes would be narrower than Lobe::kMinAlpha.
///
/// cost     2 ms, for the bands of narrow lobes
std::vector<PrefilterLevel> prefilterLevels(const PrefilterOptions& options);

/// The lobes of those levels that have one.
std::vector<Lobe> lobesOf(const std::vector<PrefilterLevel>& levels);

/// The reflections of an environment for all roughnesses: cubes that hold, for the direction of each texel's centre,
/// the mean of its light under the lobe of that level.
///
/// environment   finite
/// light         of that environment, for at least lobesOf(levels)
/// source_from_target   turns the cubes' directions into the environment's: a rotation
/// returns  three channels
/// errors   too_large; interrupted (when `progress` says so)
/// cost     for the narrowest lobe as LightHarmonics::make's, and about 60 ns a texel; bit-identical for any number of
///          threads
Result<ImageSet> prefilter(const Environment& environment, const LightHarmonics& light,
                           const std::vector<PrefilterLevel>& levels,
                           const glm::mat3& source_from_target = glm::mat3(1.0f),
                           const ProgressFunction& progress = {});

/// The same, but frees the environment's memory as soon as it is not needed any more.
Result<ImageSet> prefilter(Environment&& environment, const LightHarmonics& light,
                           const std::vector<PrefilterLevel>& levels,
                           const glm::mat3& source_from_target = glm::mat3(1.0f),
                           const ProgressFunction& progress = {});

/// The memory of a cube as it is returned here [bytes].
std::uint64_t cubeBytes(int size);

/// The maximum memory [bytes] of LightHarmonics::make, then the second prefilter, then cubeOf for one more lobe: the
/// environment, their results and their temporary data.
///
/// size     of that lobe's cube; 0: none is made, but the light is analysed for it
std::uint64_t prefilterMemory(const Environment& environment, const std::vector<PrefilterLevel>& levels,
                              const Lobe& lobe, int size);

/// The mean of an environment under one lobe in each direction, as a cube.
///
/// light    of that environment, for that lobe among others
/// errors   too_large; interrupted (when `progress` says so)
Result<EnvironmentMap> cubeOf(const LightHarmonics& light, const Lobe& lobe, int size,
                              const glm::mat3& source_from_target = glm::mat3(1.0f),
                              const ProgressFunction& progress = {});

}  // namespace mirrorball
