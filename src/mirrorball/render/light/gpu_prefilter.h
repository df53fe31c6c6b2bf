#pragma once

#include <optional>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/light/face_drawing.h"
#include "mirrorball/render/light/light_split.h"

namespace mirrorball {

/// The GGX chain of bake/prefilter/prefilter.h, made on the GPU from a cube that is there already: for light that
/// changes every frame. Fragment passes only and nothing read back, so that it works in OpenGL ES 3.0 and WebGL 2.
///
/// The brightest texels become points of light, whose lobes are exact (render/light/light_split.h); of the mip levels
/// of the rest each texel of the chain takes weighted reads (render/light/lobe_taps.h): about 64 in the two finest
/// levels, up to kMaxTaps in the others, which have few texels. For wide lobes the light is split a second time, in a
/// coarse mip level, where a point stands for many texels.
/// docs/prefiltering_gpu.md tells how far all that is from the exact chain.
class GpuPrefilter {
 public:
  /// Compiles the passes and finds the taps of each level.
  ///
  /// size     of the cubes that it will be given, 1 to kMaxSize
  /// format   of the chain and of what it is made from: half floats,
  ///          or 32-bit floats where gl::Context::filtersFloats()
  /// errors   too_large; no_gl: the driver cannot draw into floats; unsupported (a shader)
  /// cost     some 10 ms for the taps, and the driver's compiler
  static Result<GpuPrefilter> make(gl::Api api, int size, gl::Format format = gl::Format::rgba16f);

  /// Fills the chain. Leaves depth test, blending and culling off, and another framebuffer, viewport, program and other
  /// textures than before.
  ///
  /// cube     of floats, its side the size given; level 0 is read, filtered or not: finite, at least 0
  /// cost     six reads a texel of level 0; of the others a read a tap and two a point of light.
  ///          The same bits each time
  void run(const gl::Texture& cube) { run(cube, chain_); }

  /// The same into another chain.
  ///
  /// chain    as `makeChain` makes it
  void run(const gl::Texture& cube, gl::Texture& chain);
  /// errors   too_large
  static Result<gl::Texture> makeChain(int size, gl::Format format);

  /// Levels 0 to lastLevel(size) with the roughnesses of MipMapping::filament, filtered within and between them. Level
  /// 0 is the cube itself; half floats end at 65504.
  const gl::Texture& chain() const { return chain_; }

  static constexpr int kMaxSize = 8192;  ///< beyond, level 1 is narrower than Lobe::kMinAlpha
  static constexpr int kMaxTaps = 256;

 private:
  struct Programs {
    LightSplitPrograms split;
    gl::Program copy, level;
  };
  struct Level {
    float alpha;
    float lobe_scale;
    int taps;
    bool is_coarse;  ///< takes its light from the coarse split
  };

  GpuPrefilter(Programs programs, LightSplit split, std::optional<LightSplit> coarse_split, gl::Texture taps,
               gl::Texture chain);
  static Result<Programs> loadPrograms(gl::Api api);
  void findTaps();
  void drawLevel(gl::Texture& chain, int level);

  Programs programs_;
  LightSplit split_;
  std::optional<LightSplit> coarse_split_;  ///< where the chain is long enough for one
  gl::Texture taps_;                        ///< a row a level, as shaders/prefilter_level.frag takes them
  gl::Texture chain_;
  std::vector<Level> levels_;  ///< from level 1 on
  FaceDrawing drawing_;
};

}  // namespace mirrorball
