#pragma once

#include "mirrorball/gl/texture.h"

namespace mirrorball::gl {

/// Lets one draw into the images of textures that already exist: a cube's faces, mip levels. No depth buffer.
class TextureTarget {
 public:
  TextureTarget();

  /// Draws go into that image from now on, over the whole of it. Shaders must not read the same image
  /// (Texture::setLevels).
  void bind(const Texture& texture, int level, int face) const;

  /// Whether the image bound last can be drawn into: floats in OpenGL ES need the extension EXT_color_buffer_float.
  bool isComplete() const;

 private:
  static void destroy(unsigned name);
  Handle<destroy> handle_;
};

}  // namespace mirrorball::gl
