#pragma once

#include <glm/glm.hpp>

#include "mirrorball/gl/context.h"
#include "mirrorball/gl/framebuffer.h"

namespace mirrorball {

/// A part of a framebuffer, of 8 bits a channel and one sample a pixel.
struct FramebufferPart {
  unsigned framebuffer = 0;  ///< OpenGL's name; 0 is a window's
  glm::ivec2 corner{0};      ///< the lower left one [pixels]
  glm::ivec2 size_px{1};
};

/// Fills it with black.
void showNothing(const FramebufferPart& part);

/// Shows a picture, which is encoded for a display, stretched to the part. The framebuffer stays bound.
void showPicture(const gl::Context& context, const gl::Framebuffer& picture, const FramebufferPart& part);

/// Shows the first picture left of a line and the second right of it, each stretched to the whole part.
///
/// divider   place of the line, 0 … 1 of the width
void showBeside(const gl::Context& context, const gl::Framebuffer& first, const gl::Framebuffer& second, float divider,
                const FramebufferPart& part);

}  // namespace mirrorball
