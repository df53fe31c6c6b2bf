#pragma once

#include "mirrorball/gl/context.h"

namespace mirrorball::gl {

// What Context::enter and leave set, of the current context.

/// As a new context has it, but for rows of pixels, which are tightly packed, cube maps, which are filtered across
/// their edges, and sRGB targets, which are encoded.
void setOurState(Api api);

/// As a new context has it.
void setInitialState(Api api);

}  // namespace mirrorball::gl
