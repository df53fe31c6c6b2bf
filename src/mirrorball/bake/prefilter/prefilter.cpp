#include "mirrorball/bake/prefilter/prefilter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "formula/bsdf.h"
#include "formula/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

void sampleRow(const BlurredLight& light, const glm::mat3& source_from_target, int face, int y, Image& image) {
  const int size = image.width();
  PointBatch points;
  std::array<glm::vec4, PointBatch::kCapacity> values;
  for (int begin = 0; begin < size; begin += PointBatch::kCapacity) {
    points.count = std::min(PointBatch::kCapacity, size - begin);
    for (int i = 0; i < points.count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      points.face[at] = face;
      points.u[at] = (static_cast<float>(begin + i) + 0.5f) / static_cast<float>(size);
      points.v[at] = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
    }
    directionsAt(Projection::cube, points);
    if (source_from_target != glm::mat3(1.0f)) turn(source_from_target, points);
    light.sample(points, values.data());
    float* texel = image.texel(begin, y);
    for (int i = 0; i < points.count; ++i, texel += 3)
      for (int c = 0; c < 3; ++c) texel[c] = values[static_cast<std::size_t>(i)][c];
  }
}

/// What a level counts in the progress of all: narrower lobes have finer grids as well as more texels.
std::size_t texelsOfFace(const PrefilterLevel& level) { return std::size_t(level.size) * std::size_t(level.size); }

/// Fills a chain, and calls `release` when the environment is not needed any more.
template <typename Release>
Result<ImageSet> chainOf(const Environment& environment, const LightHarmonics& light,
                         const std::vector<PrefilterLevel>& levels, const glm::mat3& source_from_target,
                         const Release& release, const ProgressFunction& progress) {
  std::size_t total = 0;
  for (const PrefilterLevel& level : levels) total += texelsOfFace(level);
  ImageSet chain(static_cast<int>(levels.size()), 6);
  std::size_t done = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const PrefilterLevel& level = levels[i];
    // Those without a lobe come first.
    if (level.lobe) release();
    const ProgressFunction part = partOf(progress, done, texelsOfFace(level), total);
    MIRRORBALL_TRY(cube, level.lobe ? cubeOf(light, *level.lobe, level.size, source_from_target, part)
                                    : convert(environment, Projection::cube, level.size,
                                              {.source_from_target = source_from_target}, part));
    for (int face = 0; face < 6; ++face) chain.at(static_cast<int>(i), face) = std::move(cube.face(face));
    done += texelsOfFace(level);
  }
  return chain;
}

}  // namespace

float roughnessOfLevel(MipMapping mapping, int level, int last, int size) {
  const float lod = static_cast<float>(level);
  const float max = static_cast<float>(last);
  const float octaves = std::log2(static_cast<float>(size));
  // Babylon.js reads roughness 1 between two levels, so that one of them is wider than it. GGX goes on to α = 2; the
  // levels behind are never read.
  if (mapping == MipMapping::babylon) return std::sqrt(std::exp2(std::min(lod / 0.8f - octaves, 1.0f)));
  if (level == last) return 1.0f;  // whatever rounding does to the formulas
  switch (mapping) {
    case MipMapping::linear:
      return lod / max;
    case MipMapping::unreal:
      return std::exp2((lod - max) / 1.2f);
    case MipMapping::unity:
      return (1.7f - std::sqrt(1.7f * 1.7f - 4.0f * 0.7f * lod / max)) / (2.0f * 0.7f);
    case MipMapping::frostbite:
      return (lod / max) * (lod / max);
    case MipMapping::gltf:
      return std::sqrt(std::exp2(octaves * (lod / max - 1.0f)));
    case MipMapping::filament:
    case MipMapping::babylon:
      break;
  }
  return formula::roughnessOfLod(lod, max);
}

int lastLevel(int size) {
  int level = 0;
  while (levelSide(size, level) / 2 >= 4) ++level;
  return level;
}

int maxLevels(int size) { return levelCount(size); }

Result<EnvironmentMap> cubeOf(const LightHarmonics& light, const Lobe& lobe, int size,
                              const glm::mat3& source_from_target, const ProgressFunction& progress) {
  MIRRORBALL_TRY(images, imagesFor(Projection::cube, size));
  const auto side = static_cast<std::size_t>(size);
  const std::size_t rows = 6 * side;
  MIRRORBALL_TRY(blurred, light.blurred(lobe, partOf(progress, 0, rows, 2 * rows)));
  const ProgressFunction second_half = partOf(progress, rows, rows, 2 * rows);
  ProgressCounter steps(second_half, rows);
  parallelFor(rows, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !steps.stopped(); ++row) {
      const int face = static_cast<int>(row / side);
      sampleRow(blurred, source_from_target, face, static_cast<int>(row % side), images.at(0, face));
    }
    steps.advance(end - begin);
  });
  MIRRORBALL_TRY_VOID(steps.result());
  return EnvironmentMap(Projection::cube, std::move(images));
}

std::vector<PrefilterLevel> prefilterLevels(const PrefilterOptions& options) {
  assert(options.levels >= 0 && options.levels <= maxLevels(options.size));
  const int last = options.levels > 0 ? options.levels - 1 : lastLevel(options.size);
  std::vector<PrefilterLevel> levels(static_cast<std::size_t>(last) + 1);
  parallelFor(levels.size(), 1, [&](std::size_t begin, std::size_t) {
    const int level = static_cast<int>(begin);
    const float roughness = level == 0 ? 0.0f : roughnessOfLevel(options.mip_mapping, level, last, options.size);
    levels[begin] = {levelSide(options.size, level), roughness, {}};
    if (formula::alphaFromPerceptualRoughness(roughness) >= Lobe::kMinAlpha)
      levels[begin].lobe = Lobe::reflection(options.distribution, roughness);
  });
  return levels;
}

std::vector<Lobe> lobesOf(const std::vector<PrefilterLevel>& levels) {
  std::vector<Lobe> lobes;
  for (const PrefilterLevel& level : levels)
    if (level.lobe) lobes.push_back(*level.lobe);
  return lobes;
}

Result<ImageSet> prefilter(const Environment& environment, const LightHarmonics& light,
                           const std::vector<PrefilterLevel>& levels, const glm::mat3& source_from_target,
                           const ProgressFunction& progress) {
  const auto keep = [] {};
  return chainOf(environment, light, levels, source_from_target, keep, progress);
}

Result<ImageSet> prefilter(Environment&& environment, const LightHarmonics& light,
                           const std::vector<PrefilterLevel>& levels, const glm::mat3& source_from_target,
                           const ProgressFunction& progress) {
  std::optional<Environment> owned(std::move(environment));
  const auto release = [&owned] { owned.reset(); };
  return chainOf(*owned, light, levels, source_from_target, release, progress);
}

std::uint64_t cubeBytes(int size) { return std::uint64_t(size) * std::uint64_t(size) * 6 * 3 * sizeof(float); }

std::uint64_t prefilterMemory(const Environment& environment, const std::vector<PrefilterLevel>& levels,
                              const Lobe& lobe, int size) {
  std::vector<Lobe> lobes = lobesOf(levels);
  lobes.push_back(lobe);
  const LightHarmonics::Memory light = LightHarmonics::memoryFor(environment, lobes);
  std::uint64_t max = environment.bytes() + light.peak;
  std::uint64_t cubes = 0;
  const auto addCube = [&](const Lobe& of, int side) {
    cubes += cubeBytes(side);
    max = std::max(max, light.kept + cubes +
                            synthesisBytes(static_cast<int>(of.bands().size()), LightHarmonics::gridDensityFor(of)));
  };
  for (const PrefilterLevel& level : levels) {
    if (level.lobe) {
      addCube(*level.lobe, level.size);
    } else {
      cubes += cubeBytes(level.size);
      max = std::max(max, light.kept + cubes + environment.bytes());
    }
  }
  if (size > 0) addCube(lobe, size);
  return max;
}

}  // namespace mirrorball
