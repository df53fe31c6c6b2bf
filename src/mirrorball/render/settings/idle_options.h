#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What was asked for and changes nothing in a picture of a scene, a line each with the reason:
/// "{option:light-intensity}: the model has no lights of its own"; and what its materials ask for that is not drawn.
///
/// given   names of options
std::vector<std::string> idleOptions(const Scene& scene, const FrameSettings& settings,
                                     const std::set<std::string_view>& given);

}  // namespace mirrorball
