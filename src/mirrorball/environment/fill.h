#pragma once

#include <functional>
#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The light of a direction; nothing where it is not known.
using KnownRadiance = std::function<std::optional<glm::vec3>(glm::vec3 direction)>;

/// Continues known light smoothly into the directions where none is known: a cube of size × size faces that holds what
/// is known, and elsewhere the mean of the light along the unknown region's edge, weighted by the inverse square of the
/// distance.
///
/// For a circular region, such as the blind cone of one photograph, that mean is the membrane stretched over the edge,
/// the solution of Laplace's equation: stereographic projection lays the region onto a disc, keeps harmonic functions
/// harmonic and makes Poisson's kernel (1 − |z|²) / |z − ζ|² of the inverse square of the chord, up to factors that the
/// normalisation removes. For regions of other shapes it is Shepard's interpolation, as smooth, and between the least
/// and the greatest light of the edge as well.
///
/// size     texels a side of a face; regions of less than about two texels across may be missed
/// errors   bad_shape: nothing is known anywhere
/// cost     (unknown texels) × (texels along the edge)
/// from     Shepard 1968, "A two-dimensional interpolation function for irregularly-spaced data"
Result<EnvironmentMap> continueSmoothly(const KnownRadiance& known, int size);

}  // namespace mirrorball
