#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/lobe.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/environment/point_batch.h"

namespace mirrorball {

/// Where a blurred map is likeliest to be wrong: some directions all over the sphere, and the finest details of those
/// parts of the map that have most of them for their light.
///
/// panorama   equirect, of at least 32 × 16 texels
/// returns    16 unit directions, none near a pole
/// cost       one pass over a quarter of the texels
std::vector<glm::vec3> doubtfulDirections(const EnvironmentMap& panorama);

/// At most PointBatch::kCapacity of them.
PointBatch batchOf(const std::vector<glm::vec3>& directions);

/// The mean of a panorama under a lobe around some directions, by a sum over all texels, each a point of light at its
/// centre with the flux of its area.
///
/// lobe         at least 2.5 texels wide, so that the texels' sum is its integral
/// directions   at most PointBatch::kCapacity, unit
/// cost         with AVX2 0.4 ns for GGX, for each texel and direction; bit-identical for any number of threads
std::vector<glm::vec3> sumOverTexels(const EnvironmentMap& panorama, const Lobe& lobe,
                                     const std::vector<glm::vec3>& directions);

}  // namespace mirrorball
