#include "mirrorball/render/light/environment_light.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/gl/half.h"
#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/render/light/prefilter_cache.h"

namespace mirrorball {
namespace {

/// Of all faces of the first level.
float brightestSample(const ImageSet& chain) {
  float brightest = 0.0f;
  for (int face = 0; face < 6; ++face) brightest = std::max(brightest, largestSample(chain.at(0, face)));
  return brightest;
}

/// Of the chain's level 0, where the environment has that much detail. The first blurred level has half of it; on 256²
/// its narrow lobe is two texels wide.
constexpr int kMaxPrefilteredSide = 512;
constexpr int kMinPrefilteredSide = 32;
constexpr int kIrradianceSide = 32;

/// A cube of light in units of `unit`.
Result<gl::Texture> cubeTexture(gl::Format format, const ImageSet& images, float unit) {
  ImageSet in_units;
  if (unit != 1.0f) {
    in_units = images;
    forEachImage(in_units, [&](Image& image) {
      for (float& sample : image.samples()) sample /= unit;
    });
  }
  MIRRORBALL_TRY(cube, gl::Texture::fromImages(format, unit == 1.0f ? images : in_units));
  cube.setSampling({.filter = gl::Sampling::Filter::trilinear});
  return cube;
}

/// Of the chain's level 0, which prefiltered() leaves out.
int prefilteredSide(const Environment& environment) {
  const auto side = static_cast<unsigned>(cubeSideFor(environment.texelDensity()));
  return std::clamp(static_cast<int>(std::bit_ceil(side)), kMinPrefilteredSide, kMaxPrefilteredSide);
}

PrefilteredShape prefilteredShape(int side) {
  PrefilteredShape shape{{}, {kIrradianceSide}};
  for (int level = 1; level <= lastLevel(side); ++level) shape.chain.push_back(levelSide(side, level));
  return shape;
}

Result<Prefiltered> prefiltered(const Environment& environment, int side, const ProgressFunction& progress) {
  std::vector<PrefilterLevel> levels = prefilterLevels({.size = side});
  levels.erase(levels.begin());
  std::vector<Lobe> lobes = lobesOf(levels);
  lobes.push_back(Lobe::cosine());
  MIRRORBALL_TRY(light, LightHarmonics::make(environment, lobes, partOf(progress, 0, 1, 2)));
  MIRRORBALL_TRY(chain, prefilter(environment, light, levels, glm::mat3(1.0f), partOf(progress, 1, 1, 2)));
  MIRRORBALL_TRY(irradiance, cubeOf(light, lobes.back(), kIrradianceSide));
  return Prefiltered{std::move(chain), std::move(irradiance).takeImages()};
}

/// From the cache, or else made and kept there. Either way it has the values that a texture will hold.
Result<Prefiltered> prefilteredOnce(const Environment& environment, const PreparedEnvironment& prepared,
                                    const CacheFolder& folder, const ProgressFunction& progress) {
  const PrefilterCache cache(folder);
  const int side = prefilteredSide(environment);
  const std::string key = PrefilterCache::keyOf(prepared.chain);
  if (std::optional<Prefiltered> found = cache.find(key, prefilteredShape(side))) return std::move(*found);
  MIRRORBALL_TRY(made, prefiltered(environment, side, progress));
  cache.keep(key, made, prepared.needs_floats ? TexelFormat::float32 : TexelFormat::half);
  return made;
}

}  // namespace

int cubeSideFor(float texels_per_radian) {
  // A face's texels are widest in its middle.
  const float side = texels_per_radian / texelDensity(Projection::cube, 1);
  if (side <= 64.0f) return std::max(static_cast<int>(std::ceil(side)), 1);
  return static_cast<int>(std::ceil(side / 64.0f)) * 64;
}

namespace {

Result<PreparedEnvironment> withCubes(const Environment& environment, const std::optional<CacheFolder>& cache,
                                      const ProgressFunction& progress) {
  PreparedEnvironment prepared;
  if (const EnvironmentMap* map = environment.map(); map && map->projection() == Projection::cube) {
    prepared.chain = mipChain(*map);
  } else {
    MIRRORBALL_TRY(cube, convert(environment, Projection::cube, cubeSideFor(environment.texelDensity())));
    prepared.chain = mipChain(std::move(cube));
  }
  prepared.needs_floats = brightestSample(prepared.chain) > gl::kLargestHalf;
  MIRRORBALL_TRY(blurred, cache ? prefilteredOnce(environment, prepared, *cache, progress)
                                : prefiltered(environment, prefilteredSide(environment), progress));
  prepared.prefiltered = std::move(blurred.chain);
  prepared.irradiance = std::move(blurred.irradiance);
  return prepared;
}

}  // namespace

Result<PreparedEnvironment> prepareEnvironment(const Environment& environment, const std::optional<CacheFolder>& cache,
                                               const ProgressFunction& progress, SunKind sun) {
  if (sun == SunKind::map) return withCubes(environment, cache, progress);
  MIRRORBALL_TRY(split, withoutSuns(environment));
  MIRRORBALL_TRY(prepared, withCubes(split.rest, cache, progress));
  prepared.sun = sun;
  prepared.suns = std::move(split.suns);
  return Result<PreparedEnvironment>(std::move(prepared));
}

Result<EnvironmentLight> EnvironmentLight::make(const PreparedEnvironment& prepared, bool filters_floats) {
  const bool are_floats = prepared.needs_floats && filters_floats;
  const gl::Format format = are_floats ? gl::Format::rgba32f : gl::Format::rgba16f;
  // A power of two: nothing is rounded but what becomes too small for a half.
  const float unit = prepared.needs_floats && !are_floats
                         ? std::exp2(std::ceil(std::log2(brightestSample(prepared.chain) / gl::kLargestHalf)))
                         : 1.0f;
  MIRRORBALL_TRY(cube, cubeTexture(format, prepared.chain, unit));
  MIRRORBALL_TRY(prefiltered, cubeTexture(format, prepared.prefiltered, unit));
  MIRRORBALL_TRY(irradiance, cubeTexture(format, prepared.irradiance, unit));
  return EnvironmentLight(std::move(cube), std::move(prefiltered), std::move(irradiance), unit);
}

}  // namespace mirrorball
