#include "mirrorball/bake/bake.h"

#include <algorithm>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

bool needsIrradiance(const BakeSettings& settings) {
  return settings.irradiance_size > 0 || settings.harmonics_degree > 0;
}

/// The most memory that is needed at a time, that of the environment, the maps and the caller included.
std::uint64_t memoryFor(const Environment& environment, const std::vector<PrefilterLevel>& levels,
                        const BakeSettings& settings) {
  const std::uint64_t others = cubeBytes(settings.skybox_size);
  const bool is_blurred = !levels.empty() || needsIrradiance(settings);
  const std::uint64_t making =
      others + (is_blurred ? prefilterMemory(environment, levels, Lobe::cosine(), settings.irradiance_size)
                           : environment.bytes());
  std::uint64_t made = others + cubeBytes(settings.irradiance_size) + settings.memory_after;
  for (const PrefilterLevel& level : levels) made += cubeBytes(level.size);
  return settings.memory_meanwhile + std::max(making, made);
}

/// Makes the maps that need blurred light, and fills them in.
///
/// environment   whose memory is freed as soon as it is not needed any more
Result<void> addBlurred(Environment environment, const BakeSettings& settings, const Observer& observer,
                        BakedMaps& maps) {
  std::vector<Lobe> lobes = lobesOf(maps.levels);
  if (needsIrradiance(settings)) lobes.push_back(Lobe::cosine());
  MIRRORBALL_TRY(light, observer.timed("harmonics: analyse", [&] {
    return LightHarmonics::make(environment, lobes, observer.progressOf("analyse light"));
  }));
  if (maps.levels.empty()) {
    const Environment not_needed_any_more(std::move(environment));
  } else {
    MIRRORBALL_TRY(specular, observer.timed("specular: prefilter", [&] {
      return prefilter(std::move(environment), light, maps.levels, settings.source_from_target,
                       observer.progressOf("prefilter"));
    }));
    maps.specular = std::move(specular);
  }
  if (settings.irradiance_size > 0) {
    MIRRORBALL_TRY(irradiance, observer.timed("irradiance: cube", [&] {
      return cubeOf(light, lobes.back(), settings.irradiance_size, settings.source_from_target,
                    observer.progressOf("irradiance"));
    }));
    maps.irradiance = std::move(irradiance);
  }
  if (settings.harmonics_degree > 0)
    maps.radiance = radianceHarmonics(light, settings.harmonics_degree, settings.source_from_target);
  return {};
}

}  // namespace

Result<BakedMaps> bake(Environment environment, const BakeSettings& settings, const Observer& observer) {
  BakedMaps maps;
  if (settings.size > 0)
    maps.levels = observer.timed("lobes: bands", [&] {
      return prefilterLevels({.size = settings.size,
                              .distribution = settings.distribution,
                              .mip_mapping = settings.mip_mapping,
                              .levels = settings.levels});
    });
  MIRRORBALL_TRY_VOID(checkMemory(memoryFor(environment, maps.levels, settings)));
  if (EnvironmentMap* map = environment.map()) {
    MIRRORBALL_TRY(values, checkLight(*map, observer));
    maps.values = values;
  }
  if (settings.skybox_size > 0) {
    MIRRORBALL_TRY(skybox, observer.timed("skybox: convert", [&] {
      return convert(environment, Projection::cube, settings.skybox_size,
                     {.source_from_target = settings.source_from_target}, observer.progressOf("skybox"));
    }));
    maps.skybox = std::move(skybox);
  }
  if (!maps.levels.empty() || needsIrradiance(settings))
    MIRRORBALL_TRY_VOID(addBlurred(std::move(environment), settings, observer, maps));
  return maps;
}

}  // namespace mirrorball
