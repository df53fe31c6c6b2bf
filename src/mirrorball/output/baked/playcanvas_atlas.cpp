#include "mirrorball/output/baked/playcanvas_atlas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/glm.hpp>

#include "formula/projection.h"
#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {
namespace {

constexpr int kAtlasSide = 512;

/// One panorama in the atlas: its corner and its height, its width being twice that [texels]. One texel along each edge
/// is a seam, in which the panorama goes on around it and over its poles, so that it can be interpolated.
struct AtlasPart {
  glm::ivec2 corner;
  int height;
};

/// Where mapShinyUv of envAtlas.js looks for the environment itself, made smaller by 2^level.
AtlasPart shinyPart(int level) {
  const int width = kAtlasSide >> level;
  return {glm::ivec2(kAtlasSide - width), width / 2};
}

/// Where mapRoughnessUv looks for a roughness of level / 5.
AtlasPart roughPart(int level) {
  const int width = kAtlasSide >> level;
  return {{0, kAtlasSide - width}, width / 2};
}

/// Where ambient.js looks for irradiance / π.
constexpr AtlasPart kAmbientPart{{128, 384}, 32};

/// Fills a part with a cube's light.
///
/// samples  that a texel is the mean of, along each side
void fillPart(const EnvironmentMap& cube, const AtlasPart& part, int samples, Interpolation interpolation,
              Image& atlas) {
  const glm::vec2 inside(2 * part.height - 2, part.height - 2);
  parallelFor(static_cast<std::size_t>(part.height), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int x = 0; x < 2 * part.height; ++x) {
        const int y = static_cast<int>(row);
        glm::vec3 sum(0.0f);
        for (int i = 0; i < samples * samples; ++i) {
          const glm::vec2 place((float(i % samples) + 0.5f) / float(samples),
                                (float(i / samples) + 0.5f) / float(samples));
          // PlayCanvas' panoramas are ours (spherical.js). Beyond edges the formula goes around them and over poles.
          const glm::vec2 uv = (glm::vec2(x - 1, y - 1) + place) / inside;
          sum += cube.radiance(formula::equirectDirection(uv), interpolation);
        }
        const glm::vec3 light = sum / float(samples * samples);
        float* texel = atlas.texel(part.corner.x + x, part.corner.y + y);
        for (int c = 0; c < 3; ++c) texel[c] = light[c];
      }
  });
}

/// One level of a chain as a cube of its own.
EnvironmentMap cubeOfLevel(const ImageSet& chain, int level) {
  ImageSet faces(1, 6);
  for (int face = 0; face < 6; ++face) faces.at(0, face) = chain.at(level, face);
  return {Projection::cube, std::move(faces)};
}

/// How many samples along a texel's side see all texels of a cube's face: a face is a quarter of the panorama, and
/// texels at its corners are smaller than in its middle.
int samplesFor(const EnvironmentMap& cube, const AtlasPart& part) {
  return std::max(1, (2 * cube.size() + part.height / 2 - 1) / (part.height / 2));
}

/// The smallest level with four texels of a face along the side of a part's texel: what is finer costs more, and its
/// mean is the same.
int levelFor(const AtlasPart& part, int size) {
  int level = 0;
  while (levelSide(size, level + 1) >= 2 * part.height) ++level;
  return level;
}

/// Fills the parts of the environment itself, each from a chain of its means.
void fillShinyParts(const ImageSet& specular, Image& atlas, ProgressCounter& counter) {
  const ImageSet means = mipChain(cubeOfLevel(specular, 0));
  const int size = means.at(0, 0).width();
  // The shader reads one level beyond the last of each, with a weight of 0.
  for (int level = 0; level <= kAtlasLevels && !counter.stopped(); ++level) {
    const AtlasPart part = shinyPart(level);
    const EnvironmentMap cube = cubeOfLevel(means, levelFor(part, size));
    fillPart(cube, part, samplesFor(cube, part), Interpolation::bilinear, atlas);
    counter.advance();
  }
}

}  // namespace

Result<Image> atlasOf(const BakedMaps& maps, const ProgressFunction& progress) {
  Image atlas(kAtlasSide, kAtlasSide, 3);
  ProgressCounter counter(progress, 2 * kAtlasLevels + 2);
  counter.advance(0);
  if (!counter.stopped()) fillShinyParts(maps.specular, atlas, counter);
  for (int level = 1; level <= kAtlasLevels && !counter.stopped(); ++level) {
    fillPart(cubeOfLevel(maps.specular, std::min(level, kAtlasLevels - 1)), roughPart(level), 1, Interpolation::bicubic,
             atlas);
    counter.advance();
  }
  MIRRORBALL_TRY_VOID(counter.result());
  fillPart(maps.irradiance, kAmbientPart, 1, Interpolation::bicubic, atlas);
  return atlas;
}

Result<PackedLight> playcanvasAtlas(const BakedMaps& maps, const ProgressFunction& progress) {
  MIRRORBALL_TRY(atlas, atlasOf(maps, progress));
  MIRRORBALL_TRY(png, encodedPng(atlas, rgbp()));
  return PackedLight{std::move(png), lostLight(maps.specular, rgbp()), rgbp().brightest};
}

}  // namespace mirrorball
