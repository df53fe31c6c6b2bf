#pragma once

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Blurs what was added up from single rays: where they lie apart by wide lobes, where they are close by narrow ones,
/// so that each texel is the mean of enough of them (Jensen 1996, "Global illumination using photon maps").
///
/// picture   three channels of light, and the number of rays; the number is used up
/// cost      some 50 operations a texel
void smoothByCount(Image& picture);

}  // namespace mirrorball
