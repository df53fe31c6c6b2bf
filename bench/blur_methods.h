#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mirrorball/bake/prefilter/lobe.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball::bench {

/// What is asked of each method: an environment's mean under one lobe, at the texels of a cube.
struct BlurTarget {
  std::string name;  ///< "level 3", "irradiance"
  int size;          ///< texels a side
  float perceptual_roughness;
  bool is_irradiance;  ///< the cosine lobe instead of GGX
  Lobe lobe;
};

/// Levels 1 to the last of a prefiltered chain, and an irradiance cube.
std::vector<BlurTarget> blurTargets(int size);

/// Makes the cube of one target.
using Blur = std::function<EnvironmentMap(const BlurTarget& target)>;

/// A way to blur environments.
struct BlurMethod {
  std::string name;
  std::string family;  ///< what differs from it only by a number of samples has the same
  bool makes_levels;
  bool makes_irradiance;
  /// What all targets share. The panorama outlives the result.
  std::function<Blur(const EnvironmentMap& panorama, const std::vector<BlurTarget>& targets)> prepare;
};

/// All but brute force: `mirrorball bake`'s; importance sampling with 32, 128 and 1024 samples, of the map itself and
/// of its mip levels; one look-up of a plain mip level; for irradiance nine spherical harmonics.
std::vector<BlurMethod> blurMethods();

}  // namespace mirrorball::bench
