#pragma once

#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image.h"

namespace mirrorball::gl {

/// The colour of the framebuffer that is bound for reading: 4 channels, in OpenGL's order of rows
/// (the picture's bottom or a texture's t = 0 first), bytes as they are kept.
Image8 readPixelBytes(int width, int height);

/// The same as floats, sRGB decoded.
///
/// format   of the framebuffer's colour
Image readPixelFloats(Format format, int width, int height);

}  // namespace mirrorball::gl
