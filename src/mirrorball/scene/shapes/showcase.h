#pragma once

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A small scene that shows what the program is for: a mirror, glass, gold, rough metal and an orange with its skin,
/// arranged to be seen from azimuth 30°, elevation 15°.
Scene showcaseScene();

}  // namespace mirrorball
