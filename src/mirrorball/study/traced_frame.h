#pragma once

#include <glm/glm.hpp>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/trace/trace_settings.h"

namespace mirrorball {

/// What a path tracer is told so that it shows what a renderer shows with those settings: size, display, environment,
/// background and lights. How many paths there are stays as it is, but where noise or time end them: then they may be
/// many.
TraceSettings tracedFrame(const FrameSettings& frame, TraceSettings settings);

/// What lies behind a traced picture with those settings, as displayedPicture takes it: their colour of the display, or
/// nothing.
glm::vec4 backdropOf(const FrameSettings& frame);

}  // namespace mirrorball
