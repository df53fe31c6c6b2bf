#pragma once

#include <span>
#include <vector>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Surfaces that see what has been drawn before them (seesScreen), and not each other.
struct ScreenLayer {
  std::vector<int> instances;
  Box shown;  ///< around all that has been drawn before them
};

/// In which order such surfaces are drawn: what lies in a body before the body, which so shows it.
///
/// boxes    of the instances (boxesOf)
/// radius   of the scene (boundingSphere)
/// order    the instances of the frame, those of a layer in the order in which they are here
/// returns  none where nothing sees what has been drawn
std::vector<ScreenLayer> screenLayers(const Scene& scene, std::span<const Box> boxes, float radius,
                                      std::span<const int> order, const FrameSettings& settings);

}  // namespace mirrorball
