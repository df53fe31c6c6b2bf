#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mirrorball/rays/vertex_patches.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Adds what is known of one place, so many times, to a sum.
void addTo(VertexOcclusion& sum, const VertexOcclusion& each, float times);

/// Removes the noise of few rays from what patches know, by means with those beside them: the more often the farther
/// away is what they see, since what they know then changes slowly, and the fewer rays they have.
///
/// rays       from each patch
/// nearness   of each patch the mean of 1 over the distance of what its rays meet, where they meet nothing 0
/// found      of each patch; becomes smooth
/// cost       up to 24 rounds of 0.1 µs for each patch and neighbour
/// from       Ward, Rubinstein & Clear 1988, "A ray tracing solution for diffuse interreflection", whose bound by the
///            harmonic mean of all distances takes what is small for far away: here it is that of what is met
void smoothOcclusion(const VertexPatches& patches, std::span<const std::size_t> rays, std::span<const float> nearness,
                     std::vector<VertexOcclusion>& found);

}  // namespace mirrorball
