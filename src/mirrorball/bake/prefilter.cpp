#include "mirrorball/bake/prefilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "formula/formula.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert.h"

namespace mirrorball {
namespace {

/// Whether a level is blurred at all, rather than the environment itself.
bool isBlurred(const PrefilterOptions& options, int level, int last) {
  if (level == 0) return false;
  const float roughness = roughnessOfLevel(options.mip_mapping, level, last);
  return formula::alphaFromPerceptualRoughness(roughness) >= Lobe::kLeastAlpha;
}

/// The lobes of the levels from `first` on.
std::vector<Lobe> lobesOf(const PrefilterOptions& options, int first, int last) {
  std::vector<std::optional<Lobe>> made(static_cast<std::size_t>(last - first + 1));
  parallelFor(made.size(), 1, [&](std::size_t i, std::size_t) {
    const int level = first + static_cast<int>(i);
    made[i] = Lobe::reflection(options.distribution, roughnessOfLevel(options.mip_mapping, level, last));
  });
  std::vector<Lobe> lobes;
  for (std::optional<Lobe>& lobe : made) lobes.push_back(std::move(*lobe));
  return lobes;
}

void sampleRow(const BlurredLight& light, int face, int y, Image& image) {
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
    light.sample(points, values.data());
    float* texel = image.texel(begin, y);
    for (int i = 0; i < points.count; ++i, texel += 3)
      for (int c = 0; c < 3; ++c) texel[c] = values[static_cast<std::size_t>(i)][c];
  }
}

}  // namespace

float roughnessOfLevel(MipMapping mapping, int level, int last) {
  const float lod = static_cast<float>(level);
  const float most = static_cast<float>(last);
  switch (mapping) {
    case MipMapping::linear:
      return lod / most;
    case MipMapping::unreal:
      return std::exp2((lod - most) / 1.2f);
    case MipMapping::unity:
      return (1.7f - std::sqrt(1.7f * 1.7f - 4.0f * 0.7f * lod / most)) / (2.0f * 0.7f);
    case MipMapping::frostbite:
      return (lod / most) * (lod / most);
    case MipMapping::filament:
      break;
  }
  return formula::roughnessOfLod(lod, most);
}

int lastLevel(int size) {
  int level = 0;
  while (levelSide(size, level) > 1 && levelSide(size, level) / 2 >= 4) ++level;
  return level;
}

Result<EnvironmentMap> cubeOf(const BlurredLight& light, int size) {
  MIRRORBALL_TRY(images, imagesFor(Projection::cube, size));
  const auto side = static_cast<std::size_t>(size);
  parallelFor(6 * side, 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int face = static_cast<int>(row / side);
      sampleRow(light, face, static_cast<int>(row % side), images.at(0, face));
    }
  });
  return EnvironmentMap(Projection::cube, std::move(images));
}

Result<ImageSet> prefilter(const Environment& environment, const PrefilterOptions& options,
                           const ProgressFunction& progress) {
  const int last = lastLevel(options.size);
  int first_blurred = 0;
  while (first_blurred <= last && !isBlurred(options, first_blurred, last)) ++first_blurred;
  ImageSet chain(last + 1, 6);
  std::vector<Lobe> lobes;
  std::optional<LightHarmonics> harmonics;
  for (int level = 0; level <= last; ++level) {
    if (progress && !progress(static_cast<std::size_t>(level), static_cast<std::size_t>(last + 1)))
      return fail(ErrorCode::interrupted, "interrupted");
    if (level == first_blurred) {
      lobes = lobesOf(options, first_blurred, last);
      MIRRORBALL_TRY(made, LightHarmonics::make(environment, lobes));
      harmonics = std::move(made);
    }
    const int side = levelSide(options.size, level);
    MIRRORBALL_TRY(cube,
                   level < first_blurred
                       ? convert(environment, Projection::cube, side)
                       : cubeOf(harmonics->blurred(lobes[static_cast<std::size_t>(level - first_blurred)]), side));
    for (int face = 0; face < 6; ++face) chain.at(level, face) = std::move(cube.face(face));
  }
  return chain;
}

}  // namespace mirrorball
