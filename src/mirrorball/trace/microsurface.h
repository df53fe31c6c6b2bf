#pragma once

#include <glm/glm.hpp>

#include "mirrorball/rays/sample_sequence.h"

namespace mirrorball {

/// A rough surface as a random height field of GGX facets (Smith's model: heights and slopes do not know of their
/// neighbours), and a ray's walk between them: facets are met and left until the ray escapes, which is multiple
/// scattering without an approximation (Heitz, Hanika, d'Eon & Dachsbacher 2016, "Multiple-scattering microfacet BSDFs
/// with the Smith model"). Heights are uniform in [−1, 1]; results do not depend on their distribution. Directions are
/// unit, in the frame of the surface, whose normal is +Z; alpha is the facets' width along X and along Y.

/// A height from which a ray enters the microsurface.
inline constexpr float kAboveAllFacets = 1.0f;

/// The probability that a ray along w escapes from a height without meeting a facet: 0 downwards.
float escapeProbability(glm::vec2 alpha, glm::vec3 w, float height);

/// The height at which a ray meets the next facet, if it does not escape. (2016, algorithm 2)
///
/// w        along the ray, upwards or downwards
/// height   where the ray is
/// u        uniform in [0, 1)
float heightOfNextFacet(glm::vec2 alpha, glm::vec3 w, float height, float u);

/// The density of the facets' normals h that a ray against w meets; w may point downwards, too, where a ray comes from
/// between the facets (2016, eq. 17). formula::sampleVisibleNormal samples it.
float densityOfMetFacets(glm::vec2 alpha, glm::vec3 w, glm::vec3 h);

}  // namespace mirrorball
