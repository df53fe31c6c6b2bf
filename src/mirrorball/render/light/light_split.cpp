#include "mirrorball/render/light/light_split.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace mirrorball {
namespace {

constexpr int kCell = 8;  // texels or cells a side, as in the shaders

int partsOf(int side) { return (side + kCell - 1) / kCell; }

enum SplitUnit { kCube, kCells, kBlocks, kThresholds };

/// What prefilter_threshold.frag makes of the sums.
enum Stage { kCoarseThresholds, kFineThresholds, kChosenThreshold };

}  // namespace

Result<LightSplitPrograms> LightSplitPrograms::load(gl::Api api) {
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
  return LightSplitPrograms{std::move(light_cells), std::move(count_cells), std::move(blocks), std::move(threshold),
                            std::move(lights),      std::move(rest),        std::move(halve)};
}

Result<LightSplit> LightSplit::make(int size, int levels, gl::Format format) {
  const auto floats = [](int width, int height) { return gl::Framebuffer::make(gl::Format::rgba32f, width, height); };
  const int cells_across = partsOf(size);
  MIRRORBALL_TRY(cells, floats(6 * cells_across, cells_across));
  MIRRORBALL_TRY(blocks, floats(partsOf(6 * cells_across), partsOf(cells_across)));
  MIRRORBALL_TRY(coarse, floats(1, 1));
  MIRRORBALL_TRY(fine, floats(1, 1));
  MIRRORBALL_TRY(chosen, floats(1, 1));
  MIRRORBALL_TRY(lights, floats(kMaxLights, 2));
  MIRRORBALL_TRY(rest, gl::Texture::makeCube(format, size, levels));
  rest.setSampling({.filter = gl::Sampling::Filter::trilinear});
  return LightSplit(std::move(cells), std::move(blocks), std::move(coarse), std::move(fine), std::move(chosen),
                    std::move(lights), std::move(rest));
}

LightSplit::LightSplit(gl::Framebuffer cells, gl::Framebuffer blocks, gl::Framebuffer coarse, gl::Framebuffer fine,
                       gl::Framebuffer chosen, gl::Framebuffer lights, gl::Texture rest)
    : cells_(std::move(cells)),
      blocks_(std::move(blocks)),
      coarse_(std::move(coarse)),
      fine_(std::move(fine)),
      chosen_(std::move(chosen)),
      lights_(std::move(lights)),
      rest_(std::move(rest)) {}

void LightSplit::run(LightSplitPrograms& programs, const FaceDrawing& drawing, const gl::Texture& cube) {
  cube.bind(kCube);
  chooseThreshold(programs, drawing);
  chosen_.color().bind(kThresholds);
  listLights(programs.lights, drawing);
  programs.rest.set("cube", kCube);
  programs.rest.set("chosen", kThresholds);
  drawing.drawFaces(programs.rest, rest_, 0);
  drawing.drawHalves(programs.halve, rest_, kCube);
}

void LightSplit::chooseThreshold(LightSplitPrograms& programs, const FaceDrawing& drawing) {
  const auto choose = [&](Stage stage, const gl::Framebuffer& target) {
    programs.threshold.set("stage", stage);
    programs.threshold.set("max_count", static_cast<float>(kMaxLights));
    programs.threshold.set("blocks", kBlocks);
    programs.threshold.set("thresholds", kThresholds);
    drawing.draw(programs.threshold, target);
  };
  fine_.color().bind(kThresholds);  // read by no one yet, but a program's texture must not be the one it draws into
  sum(programs.light_cells, programs.blocks, drawing);
  choose(kCoarseThresholds, coarse_);
  coarse_.color().bind(kThresholds);
  sum(programs.count_cells, programs.blocks, drawing);
  choose(kFineThresholds, fine_);
  fine_.color().bind(kThresholds);
  sum(programs.count_cells, programs.blocks, drawing);
  choose(kChosenThreshold, chosen_);
}

/// Over all cells, and over the blocks of those.
void LightSplit::sum(gl::Program& cells_program, gl::Program& blocks_program, const FaceDrawing& drawing) {
  cells_program.set("cube", kCube);
  cells_program.set("thresholds", kThresholds);
  cells_program.set("size", rest_.width());
  cells_program.set("cells", partsOf(rest_.width()));
  drawing.draw(cells_program, cells_);
  cells_.color().bind(kCells);
  blocks_program.set("cells", kCells);
  drawing.draw(blocks_program, blocks_);
  blocks_.color().bind(kBlocks);
}

void LightSplit::listLights(gl::Program& program, const FaceDrawing& drawing) {
  program.set("cube", kCube);
  program.set("size", rest_.width());
  program.set("cells_across", partsOf(rest_.width()));
  program.set("cells", kCells);
  program.set("blocks", kBlocks);
  program.set("chosen", kThresholds);
  drawing.draw(program, lights_);
}

}  // namespace mirrorball
