#pragma once

#include "mirrorball/image/image.h"
#include "mirrorball/output/baked/packed_light.h"

namespace mirrorball {

/// The roughness that PlayCanvas' shader reads in levels 0 to 5 of its atlas: i / 5.
inline constexpr int kAtlasLevels = 6;

/// PlayCanvas' environment atlas, 512²: panoramas of the environment and of all roughnesses, in RGBP, as a PNG.
///
/// maps     as PackLight's, with kAtlasLevels levels of MipMapping::linear
/// errors   as PackLight's
/// cost     up to 1 s on two cores, and 20 ns for each texel of level 0; bit-identical for any number of threads
/// from     PlayCanvas 2.23, envAtlas.js, reflectionEnv.js and ambient.js
Result<PackedLight> playcanvasAtlas(const BakedMaps& maps, const ProgressFunction& progress = {});

/// The same as light.
Result<Image> atlasOf(const BakedMaps& maps, const ProgressFunction& progress = {});

}  // namespace mirrorball
