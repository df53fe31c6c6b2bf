#pragma once

#include <string>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/framebuffer.h"

namespace mirrorball {

/// What a window would show, as a file: whoever draws a window draws into this one. Of a window that nobody sees OpenGL
/// promises no pixels.
class Screenshot {
 public:
  /// In the current context.
  ///
  /// errors   too_large; no_gl
  static Result<Screenshot> make(glm::ivec2 size_px);

  /// Draws go here from now on, over the whole picture.
  void bind() const { picture_.bind(); }
  /// As Viewer::show takes it.
  unsigned framebuffer() const { return picture_.name(); }

  /// Writes what was drawn, without alpha.
  ///
  /// path     .png or .jpg
  /// errors   usage: another extension; io
  Result<void> save(const std::string& path) const;

 private:
  explicit Screenshot(gl::Framebuffer picture) : picture_(std::move(picture)) {}
  gl::Framebuffer picture_;
};

}  // namespace mirrorball
