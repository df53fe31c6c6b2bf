#pragma once

#include "mirrorball/gl/context.h"

namespace mirrorball::gl {

// OpenGL's state is the context's, and a context that is taken over has a host with a state of its own: a window's
// library that clips, blends and leaves its textures bound.

/// Sets all that this room and the renderer count on and do not set at each draw: as a new context has it, but for rows
/// of pixels, which are tightly packed, cube maps, which are filtered across their edges, and the encoding of sRGB
/// targets.
void setOurState(Api api);

/// Sets what this room and the renderer change, textures of the first 16 units included, as a new context has it.
void setInitialState(Api api);

}  // namespace mirrorball::gl
