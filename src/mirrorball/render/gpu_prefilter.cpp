#include "mirrorball/render/gpu_prefilter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

#include "formula/formula.h"
#include "mirrorball/bake/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/render/lobe_taps.h"

namespace mirrorball {
namespace {

constexpr int kCell = 8;  // texels and cells a side, as in the shaders

int partsOf(int side) { return (side + kCell - 1) / kCell; }

enum Unit { kCube, kCells, kBlocks, kThresholds, kLights, kTaps };

/// Width of a texel in the middle of a face.
float texelWidth(int size) { return 2.0f / static_cast<float>(size); }

/// How the taps of a level stand.
struct Rings {
  int count;
  int points;  ///< on each
};

/// From level 2 on there are so few texels that each may take more taps than one of level 1.
Rings ringsFor(int level) {
  if (getenv("RINGS")) {int a[8],b[8];const char*s=getenv("RINGS");sscanf(s,"%dx%d,%dx%d,%dx%d,%dx%d,%dx%d,%dx%d",a+1,b+1,a+2,b+2,a+3,b+3,a+4,b+4,a+5,b+5,a+6,b+6);return{a[level],b[level]};}
  if (level <= 2) return {8, 8};
  return level == 3 ? Rings{11, 11} : Rings{16, 16};
}

PrefilterOptions chainOptions(int size) {
  PrefilterOptions options;
  options.size = size;
  return options;
}

}  // namespace

Result<GpuPrefilter> GpuPrefilter::make(gl::Api api, int size, gl::Format format) {
  assert(size >= 1 && size <= kMostSize && (format == gl::Format::rgba16f || format == gl::Format::rgba32f));
  const int last = lastLevel(size);
  MIRRORBALL_TRY(programs, loadPrograms(api));
  MIRRORBALL_TRY(lists, makeLists(size));
  MIRRORBALL_TRY(taps, gl::Texture::make2d(gl::Format::rgba32f, kMostTaps, std::max(last, 1)));
  // The widest taps of roughness 1 reach a little beyond the last level of the chain.
  MIRRORBALL_TRY(rest, gl::Texture::makeCube(gl::Format::rgba16f, size, last + 2));
  MIRRORBALL_TRY(chain, gl::Texture::makeCube(format, size, last + 1));
  GpuPrefilter made(size, std::move(programs), std::move(lists), std::move(taps), std::move(rest), std::move(chain));
  made.target_.bind(made.chain_, 0, 0);
  if (!made.target_.isComplete())
    return fail(ErrorCode::no_gl,
                "the graphics driver cannot draw into the faces of a cube of floats (in OpenGL ES that needs its extension "
                "EXT_color_buffer_float)");
  return made;
}

GpuPrefilter::GpuPrefilter(int size, Programs programs, Lists lists, gl::Texture taps, gl::Texture rest,
                           gl::Texture chain)
    : size_(size),
      programs_(std::move(programs)),
      lists_(std::move(lists)),
      taps_(std::move(taps)),
      rest_(std::move(rest)),
      chain_(std::move(chain)) {
  findTaps();
}

Result<GpuPrefilter::Programs> GpuPrefilter::loadPrograms(gl::Api api) {
  const auto load = [&](std::string_view entry, std::span<const std::string_view> defines = {}) {
    return gl::Program::load(api, "screen.vert", entry, defines);
  };
  constexpr std::array<std::string_view, 1> kCounting = {"COUNT_ABOVE"};
  MIRRORBALL_TRY(light_cells, load("prefilter_cells.frag"));
  MIRRORBALL_TRY(count_cells, load("prefilter_cells.frag", kCounting));
  MIRRORBALL_TRY(blocks, load("prefilter_blocks.frag"));
  MIRRORBALL_TRY(threshold, load("prefilter_threshold.frag"));
  MIRRORBALL_TRY(lights, load("prefilter_lights.frag"));
  MIRRORBALL_TRY(rest, load("prefilter_rest.frag"));
  MIRRORBALL_TRY(halve, load("prefilter_halve.frag"));
  MIRRORBALL_TRY(level, load("prefilter_level.frag"));
  return Programs{std::move(light_cells), std::move(count_cells), std::move(blocks), std::move(threshold),
                  std::move(lights),      std::move(rest),        std::move(halve),  std::move(level)};
}

Result<GpuPrefilter::Lists> GpuPrefilter::makeLists(int size) {
  const auto make = [](int width, int height) {
    return gl::Framebuffer::make(gl::Format::rgba32f, width, height, false);
  };
  const int cells_across = partsOf(size);
  MIRRORBALL_TRY(cells, make(6 * cells_across, cells_across));
  MIRRORBALL_TRY(blocks, make(partsOf(6 * cells_across), partsOf(cells_across)));
  MIRRORBALL_TRY(coarse, make(1, 1));
  MIRRORBALL_TRY(fine, make(1, 1));
  MIRRORBALL_TRY(chosen, make(1, 1));
  MIRRORBALL_TRY(lights, make(kMostLights, 2));
  return Lists{std::move(cells), std::move(blocks), std::move(coarse),
               std::move(fine),  std::move(chosen), std::move(lights)};
}

/// The lobe of each level and its taps.
void GpuPrefilter::findTaps() {
  const std::vector<Lobe> lobes = lobesOf(prefilterLevels(chainOptions(size_)));
  Image rows(kMostTaps, static_cast<int>(lobes.size()), 4);
  std::vector<std::vector<LobeTap>> found(lobes.size());
  parallelFor(lobes.size(), 1, [&](std::size_t i, std::size_t) {
    const Rings rings = ringsFor(static_cast<int>(i) + 1);
    found[i] = lobeTaps(lobes[i], texelWidth(size_), rings.count, rings.points);
  });
  for (std::size_t i = 0; i < lobes.size(); ++i) {
    levels_.push_back({lobes[i].ggxAlpha(), lobes[i].scale(), static_cast<int>(found[i].size())});
    float* texel = rows.texel(0, static_cast<int>(i));
    for (const LobeTap& tap : found[i]) {
      const glm::vec4 values(tap.place, std::log2(tap.footprint_rad / texelWidth(size_)), tap.weight);
      texel = std::copy_n(&values.x, 4, texel);
    }
  }
  taps_.upload(0, 0, rows);
}

void GpuPrefilter::run(const gl::Texture& cube) {
  assert(cube.isCube() && cube.width() == size_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  cube.bind(kCube);
  chooseThreshold();
  listLights();
  drawWhole(chain_, false);
  drawWhole(rest_, true);
  halveRest();
  for (int level = 1; level < chain_.levels(); ++level) drawLevel(level);
}

void GpuPrefilter::chooseThreshold() {
  sumCells(programs_.light_cells);
  setThresholdStage(0, lists_.fine, lists_.coarse);
  lists_.coarse.color().bind(kThresholds);
  sumCells(programs_.count_cells);
  setThresholdStage(1, lists_.coarse, lists_.fine);
  lists_.fine.color().bind(kThresholds);
  sumCells(programs_.count_cells);
  setThresholdStage(2, lists_.fine, lists_.chosen);
  lists_.chosen.color().bind(kThresholds);
}

/// Sums over all cells, and over the blocks of those.
void GpuPrefilter::sumCells(gl::Program& program) {
  lists_.cells.bind();
  program.set("cube", kCube);
  program.set("thresholds", kThresholds);
  program.set("size", size_);
  program.set("cells", partsOf(size_));
  no_vertices_.draw(3);
  lists_.blocks.bind();
  lists_.cells.color().bind(kCells);
  programs_.blocks.set("cells", kCells);
  no_vertices_.draw(3);
}

void GpuPrefilter::setThresholdStage(int stage, const gl::Framebuffer& counted, const gl::Framebuffer& target) {
  target.bind();
  lists_.blocks.color().bind(kBlocks);
  counted.color().bind(kThresholds);
  gl::Program& program = programs_.threshold;
  program.set("stage", stage);
  program.set("most", static_cast<float>(kMostLights));
  program.set("blocks", kBlocks);
  program.set("thresholds", kThresholds);
  no_vertices_.draw(3);
}

void GpuPrefilter::listLights() {
  lists_.lights.bind();
  gl::Program& program = programs_.lights;
  program.set("cube", kCube);
  program.set("size", size_);
  program.set("cells_across", partsOf(size_));
  program.set("cells", kCells);
  program.set("blocks", kBlocks);
  program.set("chosen", kThresholds);
  no_vertices_.draw(3);
  lists_.lights.color().bind(kLights);
}

/// The cube as it is, or without the points of light.
void GpuPrefilter::drawWhole(const gl::Texture& target, bool without_points) {
  gl::Program& program = programs_.rest;
  program.set("cube", kCube);
  program.set("chosen", kThresholds);
  program.set("without_points", without_points ? 1 : 0);
  drawFaces(program, target, 0);
}

void GpuPrefilter::halveRest() {
  rest_.bind(kCube);
  gl::Program& program = programs_.halve;
  program.set("cube", kCube);
  for (int level = 1; level < rest_.levels(); ++level) {
    rest_.setLevels(level - 1, level - 1);
    program.set("source_size", levelSide(size_, level - 1));
    drawFaces(program, rest_, level);
  }
  rest_.setLevels(0, rest_.levels() - 1);
}

void GpuPrefilter::drawLevel(int level) {
  const Level& made = levels_[static_cast<std::size_t>(level - 1)];
  gl::Program& program = programs_.level;
  program.set("rest", kCube);
  program.set("lights", kLights);
  program.set("chosen", kThresholds);
  taps_.bind(kTaps);
  program.set("taps", kTaps);
  program.set("tap_row", level - 1);
  program.set("tap_count", made.taps);
  program.set("alpha", made.alpha);
  program.set("lobe_scale", made.lobe_scale);
  drawFaces(program, chain_, level);
}

void GpuPrefilter::drawFaces(gl::Program& program, const gl::Texture& target, int level) {
  program.set("size", levelSide(size_, level));
  for (int face = 0; face < 6; ++face) {
    target_.bind(target, level, face);
    program.set("face", face);
    no_vertices_.draw(3);
  }
}

}  // namespace mirrorball
