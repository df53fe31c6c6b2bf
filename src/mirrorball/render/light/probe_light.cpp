#include "mirrorball/render/light/probe_light.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/half.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {
namespace {

constexpr int kUnit = 0;
constexpr int kProbeIrradianceSide = 16;
/// Of the level that irradiance is the sum of: the lobe is wide, and in white light the sum is exact.
constexpr int kSummedSide = 8;

Result<gl::Texture> cubeOf(gl::Format format, int size, int levels, gl::Sampling::Filter filter) {
  MIRRORBALL_TRY(cube, gl::Texture::makeCube(format, size, levels));
  cube.setSampling({.filter = filter});
  return Result<gl::Texture>(std::move(cube));
}

}  // namespace

Result<ProbeFilter> ProbeFilter::make(gl::Api api, int size, gl::Format format, float unit) {
  MIRRORBALL_TRY(prefilter, GpuPrefilter::make(api, size, format));
  MIRRORBALL_TRY(face, gl::Program::load(api, "screen.vert", "limited_picture.frag"));
  MIRRORBALL_TRY(halve, gl::Program::load(api, "screen.vert", "prefilter_halve.frag"));
  MIRRORBALL_TRY(irradiance, gl::Program::load(api, "screen.vert", "probe_irradiance.frag"));
  MIRRORBALL_TRY(share, gl::Program::load(api, "screen.vert", "probe_share.frag"));
  return ProbeFilter(size, format, unit, {std::move(face), std::move(halve), std::move(irradiance), std::move(share)},
                     std::move(prefilter));
}

ProbeFilter::ProbeFilter(int size, gl::Format format, float unit, Programs programs, GpuPrefilter prefilter)
    : size_(size), format_(format), unit_(unit), programs_(std::move(programs)), prefilter_(std::move(prefilter)) {}

Result<ProbeLight> ProbeFilter::makeLight() const {
  using Filter = gl::Sampling::Filter;
  MIRRORBALL_TRY(cube, cubeOf(format_, size_, levelCount(size_), Filter::trilinear));
  MIRRORBALL_TRY(chain, GpuPrefilter::makeChain(size_, format_));
  MIRRORBALL_TRY(irradiance, cubeOf(format_, kProbeIrradianceSide, 1, Filter::linear));
  MIRRORBALL_TRY(nearness, cubeOf(gl::Format::rgba16f, size_, 1, Filter::linear));
  return ProbeLight{std::move(cube), std::move(chain), std::move(irradiance), std::move(nearness)};
}

void ProbeFilter::setFace(ProbeLight& light, int face, const gl::Texture& picture) {
  const float most = format_ == gl::Format::rgba16f ? gl::kLargestHalf : std::numeric_limits<float>::max();
  drawFace(light.cube, face, picture, 1.0f / unit_, most);
}

void ProbeFilter::setNearness(ProbeLight& light, int face, const gl::Texture& picture) {
  drawFace(light.nearness, face, picture, 1.0f, gl::kLargestHalf);
}

void ProbeFilter::drawFace(const gl::Texture& cube, int face, const gl::Texture& picture, float factor, float most) {
  gl::drawOverAll();
  picture.bind(kUnit);
  programs_.face.set("picture", kUnit);
  programs_.face.set("factor", factor);
  programs_.face.set("most", most);
  drawing_.target().bind(cube, 0, face);
  no_vertices_.draw(3);
}

void ProbeFilter::finish(ProbeLight& light) {
  gl::drawOverAll();
  drawing_.drawHalves(programs_.halve, light.cube, kUnit);
  light.cube.bind(kUnit);
  const int level = std::max(levelCount(size_) - levelCount(kSummedSide), 0);
  programs_.irradiance.set("cube", kUnit);
  programs_.irradiance.set("level", static_cast<float>(level));
  programs_.irradiance.set("source_size", levelSide(size_, level));
  drawing_.drawFaces(programs_.irradiance, light.irradiance, 0);
  prefilter_.run(light.cube, light.chain);
}

void ProbeFilter::clear(ProbeLight& light) {
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  for (const gl::Texture* cube : {&light.cube, &light.chain, &light.irradiance})
    for (int level = 0; level < cube->levels(); ++level)
      for (int face = 0; face < 6; ++face) {
        drawing_.target().bind(*cube, level, face);
        glClear(GL_COLOR_BUFFER_BIT);
      }
}

void ProbeFilter::add(ProbeLight& light, const ProbeLight& other, float share) {
  gl::drawOverAll();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  programs_.share.set("cube", kUnit);
  programs_.share.set("share", share);
  for (const auto& [to, from] :
       {std::pair{&light.cube, &other.cube}, {&light.chain, &other.chain}, {&light.irradiance, &other.irradiance}}) {
    from->bind(kUnit);
    for (int level = 0; level < to->levels(); ++level) {
      programs_.share.set("level", static_cast<float>(level));
      drawing_.drawFaces(programs_.share, *to, level);
    }
  }
  glDisable(GL_BLEND);
}

}  // namespace mirrorball
