#pragma once

#include <string_view>

#include "mirrorball/bake/blurred_light.h"
#include "mirrorball/bake/lobe.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {

/// Which roughness each level of a chain is for; docs/prefiltering.md has a table of them.
enum class MipMapping {
  filament,   ///< lod = M r (2 − r), three.js' too
  linear,     ///< lod = M r
  unreal,     ///< lod = M + 1.2 log₂ r
  unity,      ///< lod = M r (1.7 − 0.7 r)
  frostbite,  ///< lod = M √r
};

/// The perceptual roughness of a level, from 1 to `last`, the level of roughness 1. Level 0 is the mirror's, 0.
float roughnessOfLevel(MipMapping mapping, int level, int last);

struct PrefilterOptions {
  int size = 256;  ///< of level 0, at least 1
  Distribution distribution = Distribution::ggx;
  MipMapping mip_mapping = MipMapping::filament;
};

/// The last level of a chain: the one of 4² texels a face, or of 1² where there are fewer.
int lastLevel(int size);

/// The reflections of an environment for all roughnesses: a cube whose level 0 is the environment itself, and whose
/// further levels hold, for the direction of each texel's centre, the mean of its light under the lobe of that level.
///
/// environment   finite
/// returns  levels 0 to lastLevel(size); three channels. Where a level's lobe is narrower than Lobe::kLeastAlpha, it is
///          the environment itself
/// errors   too_large; interrupted (when `progress` says so)
/// cost     as LightHarmonics::make's, that again for the first blurred level, and about 60 ns a texel;
///          bit-identical for any number of threads
Result<ImageSet> prefilter(const Environment& environment, const PrefilterOptions& options,
                           const ProgressFunction& progress = {});

/// A cube of means under one lobe.
Result<EnvironmentMap> cubeOf(const BlurredLight& light, int size);

}  // namespace mirrorball
