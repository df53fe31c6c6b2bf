#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"

namespace mirrorball::testing {

/// A fixed piece of work for the GL driver: arithmetic and look-ups of a cube, as surfaces have them. Never changed, it
/// tells how fast the machine is, so that costs are a multiple of it.
class Yardstick {
 public:
  /// On the current context.
  ///
  /// errors   as those of programs, textures and framebuffers
  static Result<Yardstick> make();

  /// Draws it, and waits until it is drawn.
  void run();

 private:
  Yardstick(gl::Program program, gl::Texture cube, gl::Framebuffer picture)
      : program_(std::move(program)), cube_(std::move(cube)), picture_(std::move(picture)) {}

  gl::Program program_;
  gl::Texture cube_;
  gl::Framebuffer picture_;
  gl::VertexArray vertices_;
};

}  // namespace mirrorball::testing
