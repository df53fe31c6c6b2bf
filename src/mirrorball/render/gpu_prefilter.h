#pragma once

#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/gl/texture_target.h"

namespace mirrorball {

/// The GGX chain of bake/prefilter.h, made on the GPU from a cube that is there already: for light that changes every
/// frame. Fragment passes only and nothing read back, so that it works in OpenGL ES 3.0 and WebGL 2.
///
/// The brightest texels become up to kMostLights points of light, whose lobes are exact; what is left over goes into mip
/// levels, each texel by its solid angle, of which each texel of the chain takes weighted reads (render/lobe_taps.h): 64 in
/// the finest levels, kMostTaps in the coarse ones, which have few texels. How far it is from the exact chain is told in docs/prefiltering.md.
class GpuPrefilter {
 public:
  /// Compiles the passes and finds the taps of each level.
  ///
  /// size     of the cubes that it will be given, 1 to kMostSize
  /// format   of the chain: half or 32-bit floats, which OpenGL ES cannot filter
  /// errors   too_large; no_gl: the driver cannot draw into floats; unsupported (a shader)
  /// cost     some 10 ms for the taps, and the driver's compiler
  static Result<GpuPrefilter> make(gl::Api api, int size, gl::Format format = gl::Format::rgba16f);

  /// Fills the chain. Leaves depth test, blending and culling off, and another framebuffer, viewport and program than
  /// before.
  ///
  /// cube     of floats; finite radiance of at least 0 in level 0, whose side is the size given; filtered or not
  /// cost     per texel of level 1 and coarser kTaps reads, and two per point of light; per texel of level 0 about six
  ///          reads; the same bits each time
  void run(const gl::Texture& cube);

  /// Levels 0 to lastLevel(size) with the roughnesses of MipMapping::filament, filtered between levels where its format
  /// can be. Level 0 is the cube itself; half floats end at 65504.
  const gl::Texture& chain() const { return chain_; }

  static constexpr int kMostSize = 8192;  ///< beyond it level 1 is the mirror's too: Lobe::kLeastAlpha
  static constexpr int kMostLights = 64;
  static constexpr int kMostTaps = 256;

 private:
  struct Programs {
    gl::Program light_cells, count_cells, blocks, threshold, lights, rest, halve, level;
  };
  /// Sums over parts of the cube, and what they lead to.
  struct Lists {
    gl::Framebuffer cells, blocks, coarse, fine, chosen, lights;
  };
  struct Level {
    float alpha;
    float lobe_scale;
    int taps;
  };

  GpuPrefilter(int size, Programs programs, Lists lists, gl::Texture taps, gl::Texture rest, gl::Texture chain);
  static Result<Programs> loadPrograms(gl::Api api);
  static Result<Lists> makeLists(int size);
  void findTaps();

  void chooseThreshold();
  void sumCells(gl::Program& program);
  void setThresholdStage(int stage, const gl::Framebuffer& counted, const gl::Framebuffer& target);
  void listLights();
  void drawWhole(const gl::Texture& target, bool without_points);
  void halveRest();
  void drawLevel(int level);
  void drawFaces(gl::Program& program, const gl::Texture& target, int level);

  int size_;
  Programs programs_;
  Lists lists_;
  gl::Texture taps_;  ///< a row a level, as shaders/prefilter_level.frag takes them
  gl::Texture rest_;  ///< mip levels without the points of light
  gl::Texture chain_;
  std::vector<Level> levels_;  ///< from level 1 on
  gl::TextureTarget target_;
  gl::VertexArray no_vertices_;
};

}  // namespace mirrorball
