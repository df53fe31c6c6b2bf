#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/light/face_drawing.h"

namespace mirrorball {

/// The shaders of LightSplit.
struct LightSplitPrograms {
  gl::Program light_cells, count_cells, blocks, threshold, lights, rest, halve;

  /// errors   unsupported (a shader)
  static Result<LightSplitPrograms> load(gl::Api api);
};

/// Tells the brightest texels of a cube from the rest, on the GPU: they become points of light, the rest mip levels.
///
/// A texel becomes a point of light by what it exceeds a threshold. That is eight times the mean brightness or as much
/// more as it takes for at most kMaxLights texels to exceed it, in steps of 2. How many do is summed for four
/// thresholds at a time over cells of 8 × 8 texels and over blocks of 8 × 8 cells; a fragment per point of light finds
/// its texel through those sums (a histogram pyramid: Ziegler et al. 2006).
class LightSplit {
 public:
  /// size     of the cubes to be split
  /// levels   mip levels of the rest
  /// format   of the rest: half floats, or 32-bit floats where gl::Context::filtersFloats()
  /// errors   too_large; no_gl: the driver cannot draw into floats
  static Result<LightSplit> make(int size, int levels, gl::Format format);

  /// cube     what shaders see as its level 0 has the size given; radiance of at least 0
  /// cost     five reads a texel
  void run(LightSplitPrograms& programs, const FaceDrawing& drawing, const gl::Texture& cube);

  /// kMaxLights × 2 floats: in column k the direction of point k, and under it its radiance times its solid angle.
  const gl::Texture& lights() const { return lights_.color(); }
  /// One texel: the threshold, a number of no use to others, and how many points of light there are.
  const gl::Texture& chosen() const { return chosen_.color(); }
  /// What is left, filtered within and between levels;
  /// each level the mean of the one before with its texels' solid angles.
  gl::Texture& rest() { return rest_; }

  static constexpr int kMaxLights = 128;

 private:
  LightSplit(gl::Framebuffer cells, gl::Framebuffer blocks, gl::Framebuffer coarse, gl::Framebuffer fine,
             gl::Framebuffer chosen, gl::Framebuffer lights, gl::Texture rest);

  void chooseThreshold(LightSplitPrograms& programs, const FaceDrawing& drawing);
  void sum(gl::Program& cells_program, gl::Program& blocks_program, const FaceDrawing& drawing);
  void listLights(gl::Program& program, const FaceDrawing& drawing);

  gl::Framebuffer cells_, blocks_;  ///< sums
  gl::Framebuffer coarse_, fine_;   ///< thresholds
  gl::Framebuffer chosen_;
  gl::Framebuffer lights_;
  gl::Texture rest_;
};

}  // namespace mirrorball
