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

  /// Fills the levels of a cube from its level 0, by shaders/prefilter_halve.frag.
  void drawHalves(gl::Program& program, gl::Texture& cube, int unit) const {
    cube.bind(unit);
    program.set("cube", unit);
    for (int level = 1; level < cube.levels(); ++level) {
      cube.setLevels(level - 1, level - 1);
      program.set("source_size", levelSide(cube.width(), level - 1));
      drawFaces(program, cube, level);
    }
    cube.setLevels(0, cube.levels() - 1);
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
