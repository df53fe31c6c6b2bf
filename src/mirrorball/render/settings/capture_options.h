#pragma once

#include <set>
#include <span>
#include <string_view>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// Those rows of frameOptions() that say what a scene looks like, for a map of all directions: without those that say
/// how a picture of it is taken, and without what is right for one viewing direction alone.
std::span<const Option<FrameSettings>> captureFrameOptions();

/// As checkSettings, for such a map.
///
/// errors   usage: as checkSettings'; what it cannot show
Result<void> checkCapture(const FrameSettings& settings, const std::set<std::string_view>& given);

}  // namespace mirrorball
