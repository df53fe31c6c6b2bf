#include "mirrorball/render/light/gpu_prefilter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/vec4.hpp>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/render/light/lobe_taps.h"

namespace mirrorball {
namespace {

enum PrefilterUnit { kRest, kLights, kChosen, kCoarseLights, kCoarseChosen, kTaps };

/// The coarse split is that of the mip level so many before the last: of 64² texels where the last has 4².
constexpr int kCoarseBeforeLast = 4;

/// It is for lobes that are at least so many of its texels wide: its points of light stand for what a texel saw.
constexpr float kWideLobe = 2.5f;

/// Mip levels of a rest: the widest taps of roughness 1 reach a little beyond the last level of the chain.
int restLevels(int size) { return lastLevel(size) + 2; }

/// Width of a texel in the middle of a face.
float texelWidth(int size) { return 2.0f / static_cast<float>(size); }

PrefilterOptions optionsFor(int size) {
  PrefilterOptions options;
  options.size = size;
  return options;
}

/// How the taps of a level stand.
struct Rings {
  int count;
  int points;  ///< on each
};

/// Level 1, which has three quarters of the texels, gets more rings and fewer points than level 2: a narrow lobe's
/// light goes through more octaves.
Rings ringsFor(int level) {
  switch (level) {
    case 1:
      return {10, 6};
    case 2:
      return {8, 8};
    case 3:
      return {11, 11};
    default:
      return {16, 16};
  }
}

}  // namespace

Result<GpuPrefilter> GpuPrefilter::make(gl::Api api, int size, gl::Format format) {
  assert(size >= 1 && size <= kMaxSize && (format == gl::Format::rgba16f || format == gl::Format::rgba32f));
  const int last = lastLevel(size);
  MIRRORBALL_TRY(programs, loadPrograms(api));
  MIRRORBALL_TRY(split, LightSplit::make(size, restLevels(size), format));
  std::optional<LightSplit> coarse_split;
  if (last > kCoarseBeforeLast) {
    const int coarse_size = levelSide(size, last - kCoarseBeforeLast);
    MIRRORBALL_TRY(made, LightSplit::make(coarse_size, restLevels(coarse_size), format));
    coarse_split = std::move(made);
  }
  MIRRORBALL_TRY(taps, gl::Texture::make2d(gl::Format::rgba32f, kMaxTaps, std::max(last, 1)));
  MIRRORBALL_TRY(chain, makeChain(size, format));
  GpuPrefilter made(std::move(programs), std::move(split), std::move(coarse_split), std::move(taps), std::move(chain));
  made.drawing_.target().bind(made.chain_, 0, 0);
  if (!made.drawing_.target().isComplete())
    return fail(ErrorCode::no_gl,
                "the graphics driver cannot draw into the faces of a cube of floats (in OpenGL ES that needs its "
                "extension EXT_color_buffer_float)");
  return made;
}

Result<gl::Texture> GpuPrefilter::makeChain(int size, gl::Format format) {
  MIRRORBALL_TRY(chain, gl::Texture::makeCube(format, size, lastLevel(size) + 1));
  chain.setSampling({.filter = gl::Sampling::Filter::trilinear});
  return Result<gl::Texture>(std::move(chain));
}

GpuPrefilter::GpuPrefilter(Programs programs, LightSplit split, std::optional<LightSplit> coarse_split,
                           gl::Texture taps, gl::Texture chain)
    : programs_(std::move(programs)),
      split_(std::move(split)),
      coarse_split_(std::move(coarse_split)),
      taps_(std::move(taps)),
      chain_(std::move(chain)) {
  findTaps();
}

Result<GpuPrefilter::Programs> GpuPrefilter::loadPrograms(gl::Api api) {
  MIRRORBALL_TRY(split, LightSplitPrograms::load(api));
  MIRRORBALL_TRY(copy, gl::Program::load(api, "screen.vert", "copy_face.frag"));
  MIRRORBALL_TRY(level, gl::Program::load(api, "screen.vert", "prefilter_level.frag"));
  return Programs{std::move(split), std::move(copy), std::move(level)};
}

/// The lobe of each level and its taps, whose footprints are told in texels of the rest that they read.
void GpuPrefilter::findTaps() {
  const std::vector<Lobe> lobes = lobesOf(prefilterLevels(optionsFor(chain_.width())));
  const float fine_texel = texelWidth(chain_.width());
  const float coarse_texel = coarse_split_ ? texelWidth(coarse_split_->rest().width()) : INFINITY;
  Image rows(kMaxTaps, taps_.height(), 4);
  levels_.resize(lobes.size());
  parallelFor(lobes.size(), 1, [&](std::size_t i, std::size_t) {
    const bool is_coarse = lobes[i].width() >= kWideLobe * coarse_texel;
    const float texel_width = is_coarse ? coarse_texel : fine_texel;
    const Rings rings = ringsFor(static_cast<int>(i) + 1);
    const std::vector<LobeTap> taps = lobeTaps(lobes[i], texel_width, rings.count, rings.points);
    float* texel = rows.texel(0, static_cast<int>(i));
    for (const LobeTap& tap : taps) {
      const glm::vec4 values(tap.place, std::log2(tap.footprint_rad / texel_width), tap.weight);
      texel = std::copy_n(&values.x, 4, texel);
    }
    levels_[i] = {lobes[i].shape().parameter, lobes[i].scale(), static_cast<int>(taps.size()), is_coarse};
  });
  taps_.upload(0, 0, rows);
}

void GpuPrefilter::run(const gl::Texture& cube, gl::Texture& chain) {
  assert(cube.isCube() && cube.width() == chain_.width() && chain.width() == chain_.width());
  gl::drawOverAll();
  cube.bind(kRest);
  programs_.copy.set("cube", kRest);
  drawing_.drawFaces(programs_.copy, chain, 0);
  split_.run(programs_.split, drawing_, cube);
  if (coarse_split_) {
    const int level = lastLevel(chain_.width()) - kCoarseBeforeLast;
    split_.rest().setLevels(level, level);
    coarse_split_->run(programs_.split, drawing_, split_.rest());
    split_.rest().setLevels(0, split_.rest().levels() - 1);
  }
  for (int level = 1; level < chain.levels(); ++level) drawLevel(chain, level);
}

void GpuPrefilter::drawLevel(gl::Texture& chain, int level) {
  const Level& made = levels_[static_cast<std::size_t>(level - 1)];
  LightSplit& coarse = made.is_coarse ? *coarse_split_ : split_;
  coarse.rest().bind(kRest);
  split_.lights().bind(kLights);
  split_.chosen().bind(kChosen);
  coarse.lights().bind(kCoarseLights);
  coarse.chosen().bind(kCoarseChosen);
  taps_.bind(kTaps);
  gl::Program& program = programs_.level;
  program.set("rest", kRest);
  program.set("lights", kLights);
  program.set("chosen", kChosen);
  program.set("coarse_lights", kCoarseLights);
  program.set("coarse_chosen", kCoarseChosen);
  program.set("coarse", made.is_coarse ? 1 : 0);
  program.set("taps", kTaps);
  program.set("tap_row", level - 1);
  program.set("tap_count", made.taps);
  program.set("alpha", made.alpha);
  program.set("lobe_scale", made.lobe_scale);
  drawing_.drawFaces(program, chain, level);
}

}  // namespace mirrorball
