#pragma once

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

// OpenEXR's registration of environment maps (ImfEnvmap.h, ImfEnvmap.cpp): the centres of the first and the last texel
// lie on the edges of a panorama or of a cube's face, at position · (n − 1), where ours lie half a texel inside. So the
// first and the last column of a panorama are one meridian, its first and last row are the poles, and neighbouring
// faces share the texels of their edge. The directions are the same.

/// A map in our registration resampled into OpenEXR's, bicubically at every texel centre.
///
/// map      equirect or cube; of size 1 it has no two edges, and stays as it is
/// returns  images of the same size, of three channels
/// cost     0.2 µs a texel on one core
EnvironmentMap toOpenExrRegistration(const EnvironmentMap& map);

/// The inverse: a map in OpenEXR's registration resampled into ours.
EnvironmentMap fromOpenExrRegistration(const EnvironmentMap& images);

}  // namespace mirrorball
