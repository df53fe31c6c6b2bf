#pragma once

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture_target.h"

namespace mirrorball {

/// Runs a fragment shader over the faces of a cube, or over a picture; its vertex shader is shaders/screen.vert.
class FaceDrawing {
 public:
  /// The program gets `size`, the side of the level, and `face`.
  void drawFaces(gl::Program& program, const gl::Texture& cube, int level) const {
    program.set("size", levelSide(cube.width(), level));
    for (int face = 0; face < 6; ++face) {
      target_.bind(cube, level, face);
      program.set("face", face);
      no_vertices_.draw(3);
    }
  }

  void draw(const gl::Program& program, const gl::Framebuffer& picture) const {
    picture.bind();
    program.use();
    no_vertices_.draw(3);
  }

  const gl::TextureTarget& target() const { return target_; }

 private:
  gl::TextureTarget target_;
  gl::VertexArray no_vertices_;
};

}  // namespace mirrorball
