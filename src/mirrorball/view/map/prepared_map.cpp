#include "mirrorball/view/map/prepared_map.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "formula/prefilter.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/render/light/environment_light.h"

namespace mirrorball {
namespace {

constexpr int kLargestSearchedSide = 1024;  // of a face, for lamps
constexpr int kWaveformHeight = 512;

PreparedMap::Light shared(Environment environment) {
  return std::make_shared<const Environment>(std::move(environment));
}

/// The levels of a cube, each as an environment.
std::vector<PreparedMap::Light> levelsOf(ImageSet chain) {
  std::vector<PreparedMap::Light> levels;
  for (int level = 0; level < chain.levels(); ++level) {
    ImageSet faces(1, 6);
    for (int face = 0; face < 6; ++face) faces.at(0, face) = std::move(chain.at(level, face));
    levels.push_back(shared(Environment(EnvironmentMap(Projection::cube, std::move(faces)))));
  }
  return levels;
}

Result<Harmonics> harmonicsOf(const Environment& light, const ProgressFunction& progress) {
  MIRRORBALL_TRY(analysed, LightHarmonics::make(light, {Lobe::cosine()}, progress));
  return radianceHarmonics(analysed, MapViewSettings::kMaxDegree);
}

std::vector<MapLamp> lampsIn(const PreparedMap& map) {
  // The first band is the mean, times the root of the sphere's solid angle.
  const glm::vec3 all = map.harmonics[0] / formula::harmonic(0, glm::vec3(0.0f, 0.0f, 1.0f));
  const auto searched = std::find_if(map.mips.begin(), map.mips.end(), [](const PreparedMap::Light& level) {
    return level->map()->size() <= kLargestSearchedSide;
  });
  return findLamps(*(*searched)->map(), all,
                   {.max = PreparedMap::kMostLamps, .min_share = PreparedMap::kLeastShareOfLamp});
}

/// The coarsest mip level with so many texels a radian, or more detail than any has: the map itself.
PreparedMap::Light withDetail(const PreparedMap& map, float texels_per_radian) {
  for (auto level = map.mips.rbegin(); level != map.mips.rend(); ++level)
    if ((*level)->texelDensity() >= texels_per_radian) return *level;
  return map.mended;
}

/// A sum of harmonics, divided by π where it is irradiance.
Environment sumOf(Harmonics harmonics, float factor) {
  constexpr int kRowsThatShowIt = 64;
  const auto radiance = [harmonics = std::move(harmonics), factor](glm::vec3 direction) {
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < harmonics.size(); ++i)
      sum += harmonics[i] * formula::harmonic(static_cast<int>(i), direction);
    return sum * factor;
  };
  return Environment(radiance, kRowsThatShowIt);
}

Environment harmonicLight(const PreparedMap& map, const MapViewSettings& settings) {
  const auto count = static_cast<std::size_t>((settings.degree + 1) * (settings.degree + 1));
  Harmonics kept(map.harmonics.begin(), map.harmonics.begin() + std::ptrdiff_t(count));
  if (settings.light == MapLight::harmonics) return sumOf(std::move(kept), 1.0f);
  return sumOf(irradianceOf(std::move(kept)), 1.0f / formula::kPi);
}

/// As the renderer reads it: between the two levels of a roughness.
std::vector<LightShare> prefilteredLight(const PreparedMap& map, float perceptual_roughness, float texels_per_radian) {
  const auto last = static_cast<int>(map.prefiltered.size());
  const float lod = formula::lodOfRoughness(perceptual_roughness, static_cast<float>(last));
  const int level = std::min(static_cast<int>(lod), last - 1);
  const float share = lod - static_cast<float>(level);
  const PreparedMap::Light sharper =
      level == 0 ? withDetail(map, texels_per_radian) : map.prefiltered[std::size_t(level) - 1];
  return {{sharper, 1.0f - share}, {map.prefiltered[std::size_t(level)], share}};
}

}  // namespace

Result<PreparedMap> prepareMap(Environment environment, const std::optional<CacheFolder>& cache,
                               const ProgressFunction& progress) {
  constexpr std::size_t kSteps = 10;
  PreparedMap map;
  if (const EnvironmentMap* images = environment.map()) map.faulty = faultyTexels(*images);
  map.given = map.mended = shared(std::move(environment));
  if (map.faulty.count() > 0) {
    Environment mended = *map.given;
    mendFaults(*mended.map());
    map.mended = shared(std::move(mended));
  }
  MIRRORBALL_TRY(prepared, prepareEnvironment(*map.mended, cache, partOf(progress, 0, 7, kSteps)));
  map.mips = levelsOf(std::move(prepared.chain));
  map.prefiltered = levelsOf(std::move(prepared.prefiltered));
  MIRRORBALL_TRY(harmonics, harmonicsOf(*map.mended, partOf(progress, 7, 1, kSteps)));
  map.harmonics = std::move(harmonics);
  map.lamps = lampsIn(map);
  const int height = std::clamp(map.mended->naturalSize(Projection::equirect), 1, kWaveformHeight);
  const PreparedMap::Light detailed = withDetail(map, 2.0f * texelDensity(Projection::equirect, height));
  MIRRORBALL_TRY(panorama, convert(*detailed, Projection::equirect, height, {}, partOf(progress, 9, 1, kSteps)));
  map.waveform = Waveform(panorama);
  return map;
}

std::vector<LightShare> lightOf(const PreparedMap& map, const MapViewSettings& settings, float texels_per_radian) {
  switch (settings.light) {
    case MapLight::map:
      return {{withDetail(map, texels_per_radian)}};
    case MapLight::mip: {
      const auto level = std::min(std::size_t(settings.level), map.mips.size() - 1);
      return {{map.mips[level]}};
    }
    case MapLight::prefiltered:
      return prefilteredLight(map, settings.perceptual_roughness, texels_per_radian);
    case MapLight::irradiance:
    case MapLight::harmonics:
      break;
  }
  return {{shared(harmonicLight(map, settings))}};
}

glm::vec3 shownRadiance(const PreparedMap& map, const MapViewSettings& settings, glm::vec3 direction) {
  glm::vec3 sum(0.0f);
  for (const LightShare& part : lightOf(map, settings, std::numeric_limits<float>::infinity()))
    sum += part.share * part.light->radiance(direction);
  return sum;
}

}  // namespace mirrorball
