#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The parts in which two scenes differ (StagePart). Meshes, textures and heights are the same if they are shared:
/// those of a changed copy are. Cameras count as transforms.
///
/// cost     proportional to the instances, materials and textures
unsigned differingParts(const Scene& a, const Scene& b);

/// Whether two scenes have the same meshes and heights, and materials that show the same of those: so that what
/// prepareRelief makes of one serves the other.
bool haveSameRelief(const Scene& a, const Scene& b);

/// Whether all of two materials is the same but for the name.
bool areSameMaterials(const Material& a, const Material& b);

/// Whether two materials differ in numbers alone, so that no texture and no mesh on the GPU changes with them.
bool haveSameBuffers(const Material& a, const Material& b);

/// Whether one is another body, or shows another side, or is cut away elsewhere: all that is not only light on a
/// surface.
bool changesShape(const Material& a, const Material& b);

}  // namespace mirrorball
