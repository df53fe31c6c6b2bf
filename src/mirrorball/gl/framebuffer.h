#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"

namespace mirrorball::gl {

/// A picture to draw into: one colour texture, and a 24-bit depth buffer if wanted.
class Framebuffer {
 public:
  /// errors   too_large; no_gl: this driver cannot draw into such a format (floats in OpenGL ES need the extension
  ///          EXT_color_buffer_float)
  static Result<Framebuffer> make(Format color, int width, int height, bool depth);

  /// Draws go here from now on, over the whole picture.
  void bind() const;

  /// The colour texture, one level, filtered linearly; row 0 is the picture's bottom, as OpenGL
  /// draws.
  const Texture& color() const { return color_; }

  int width() const { return color_.width(); }
  int height() const { return color_.height(); }

  /// The picture as floats: 4 channels, row 0 at the TOP, sRGB decoded.
  Image readFloat() const;

  /// The picture of an 8-bit format as its bytes: 4 channels, row 0 at the TOP.
  Image8 readBytes() const;

 private:
  static void destroyFramebuffer(unsigned name);
  static void destroyRenderbuffer(unsigned name);
  explicit Framebuffer(Texture color) : color_(std::move(color)) {}

  Texture color_;
  Handle<destroyFramebuffer> handle_;
  Handle<destroyRenderbuffer> depth_;
};

}  // namespace mirrorball::gl
