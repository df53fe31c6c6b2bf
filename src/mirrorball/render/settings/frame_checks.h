#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

// What settings say against each other and against a scene. Messages name options as {option:NAME} (filledIn).

/// Before anything is loaded.
///
/// given    names of options that someone has given, others having their defaults
/// errors   usage: two of them contradict each other, or one says nothing without another
Result<void> checkSettings(const FrameSettings& settings, const std::set<std::string_view>& given);

/// For the scene that is shown.
///
/// returns  what is doubtful, a line each: a model or a camera that the proxy does not hold
/// errors   usage: the camera is below the ground; as placedProxy's and framedCamera's
Result<std::vector<std::string>> checkFrame(const FrameSettings& settings, const Scene& scene);

/// How the built-in showcase stands where no environment is asked for: on the ground of the built-in sunset, or in a
/// build that has none, in the studio.
///
/// given        names of options that stay as they are
/// environment  becomes the name of that environment
void setShowcase(const std::set<std::string_view>& given, std::string& environment, FrameSettings& settings);

}  // namespace mirrorball
