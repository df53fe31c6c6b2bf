#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/lobe.h"
#include "mirrorball/environment/environment_map.h"
#include "mirrorball/environment/point_batch.h"

namespace mirrorball {

/// Where a blurred map is likeliest to be wrong: some texels all over the sphere, and the finest details of those parts of
/// the map that have most of them for their light.
///
/// panorama   equirect, of at least 32 × 16 texels
/// returns    16 texels, none near a pole
/// cost       one pass over a quarter of the texels
std::vector<glm::ivec2> doubtfulTexels(const EnvironmentMap& panorama);

/// The directions of the centres of a panorama's texels.
///
/// extent   of the panorama
std::vector<glm::vec3> directionsOf(const std::vector<glm::ivec2>& texels, glm::ivec2 extent);

/// At most PointBatch::kCapacity of them.
PointBatch batchOf(const std::vector<glm::vec3>& directions);

/// The mean of a panorama under a lobe around some of its texels, by a sum over all texels, each a point of light at its
/// centre with the flux of its area.
///
/// lobe     at least 2.5 texels wide, so that the texels' sum is its integral
/// cost     with AVX2 0.3 ns for GGX, for each texel and point; bit-identical for any number of threads
std::vector<glm::vec3> sumOverTexels(const EnvironmentMap& panorama, const Lobe& lobe,
                                     const std::vector<glm::ivec2>& points);

}  // namespace mirrorball
