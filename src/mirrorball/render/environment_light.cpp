#include "mirrorball/render/environment_light.h"

#include <algorithm>
#include <cmath>

#include "formula/formula.h"
#include "mirrorball/bake/mip_chain.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

constexpr float kLargestHalf = 65504.0f;

float greatestSample(const ImageSet& chain) {
  float greatest = 0.0f;
  for (int face = 0; face < 6; ++face)
    for (const float sample : chain.at(0, face).samples()) greatest = std::max(greatest, sample);
  return greatest;
}

/// Harmonics up to l = 2 vary so slowly that a cube of 64² texels a face holds them: the coarse level has the same flux
/// from each part of the sphere, and costs a hundredth of the finest.
IrradianceHarmonics irradianceOfChain(const ImageSet& chain) {
  int level = 0;
  while (level + 1 < chain.levels() && chain.at(level + 1, 0).width() >= 64) ++level;
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = chain.at(level, face);
  return irradianceHarmonics(EnvironmentMap(Projection::cube, std::move(faces)));
}

}  // namespace

int cubeSideFor(float texels_per_radian) {
  // A face's texels are widest in its middle.
  const float side = texels_per_radian / texelDensity(Projection::cube, 1);
  if (side <= 64.0f) return std::max(static_cast<int>(std::ceil(side)), 1);
  return static_cast<int>(std::ceil(side / 64.0f)) * 64;
}

Result<PreparedEnvironment> prepareEnvironment(const Environment& environment) {
  PreparedEnvironment prepared;
  if (const EnvironmentMap* map = environment.map(); map && map->projection() == Projection::cube) {
    prepared.chain = mipChain(*map);
  } else {
    MIRRORBALL_TRY(cube, convert(environment, Projection::cube, cubeSideFor(environment.texelDensity())));
    prepared.chain = mipChain(cube);
  }
  prepared.irradiance = irradianceOfChain(prepared.chain);
  prepared.needs_floats = greatestSample(prepared.chain) > kLargestHalf;
  return prepared;
}

Result<EnvironmentLight> EnvironmentLight::make(const PreparedEnvironment& prepared) {
  const gl::Format format = prepared.needs_floats ? gl::Format::rgba32f : gl::Format::rgba16f;
  MIRRORBALL_TRY(cube, gl::Texture::fromImages(format, prepared.chain));
  cube.setSampling({.filter = gl::Sampling::Filter::trilinear});
  return EnvironmentLight(std::move(cube), prepared.irradiance);
}

float EnvironmentLight::roughestLevel() const {
  const float last = static_cast<float>(cube_.levels() - 1);
  return std::clamp(std::log2(static_cast<float>(cube_.width())) - 2.0f, 0.0f, last);
}

float EnvironmentLight::texelsPerRadian() const { return texelDensity(Projection::cube, cube_.width()); }

}  // namespace mirrorball
