#include "mirrorball/bake/bake.h"

#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

bool needsIrradiance(const BakeSettings& settings) {
  return settings.irradiance_size > 0 || settings.harmonics_degree > 0;
}

}  // namespace

std::vector<PrefilterLevel> levelsOf(const BakeSettings& settings) {
  return prefilterLevels({.size = settings.size,
                          .distribution = settings.distribution,
                          .mip_mapping = settings.mip_mapping,
                          .levels = settings.levels});
}

std::uint64_t memoryToBake(const Environment& environment, const BakeSettings& settings) {
  return cubeBytes(settings.skybox_size) +
         prefilterMemory(environment, levelsOf(settings), Lobe::cosine(), settings.irradiance_size);
}

Result<BakedMaps> bake(Environment environment, const BakeSettings& settings, const Observer& observer) {
  MIRRORBALL_TRY_VOID(withName("baking", checkMemory(memoryToBake(environment, settings))));
  BakedMaps maps;
  maps.levels = observer.timed("lobes: bands", [&] { return levelsOf(settings); });
  if (settings.skybox_size > 0) {
    MIRRORBALL_TRY(skybox, observer.timed("skybox: convert", [&] {
      return convert(environment, Projection::cube, settings.skybox_size,
                     {.source_from_target = settings.source_from_target}, observer.progressOf("skybox"));
    }));
    maps.skybox = std::move(skybox);
  }
  std::vector<Lobe> lobes = lobesOf(maps.levels);
  if (needsIrradiance(settings)) lobes.push_back(Lobe::cosine());
  MIRRORBALL_TRY(light, observer.timed("harmonics: analyse", [&] {
    return LightHarmonics::make(environment, lobes, observer.progressOf("analyse light"));
  }));
  MIRRORBALL_TRY(specular, observer.timed("specular: prefilter", [&] {
    return prefilter(std::move(environment), light, maps.levels, settings.source_from_target,
                     observer.progressOf("prefilter"));
  }));
  maps.specular = std::move(specular);
  if (settings.irradiance_size > 0) {
    MIRRORBALL_TRY(irradiance, observer.timed("irradiance: cube", [&] {
      return cubeOf(light, lobes.back(), settings.irradiance_size, settings.source_from_target,
                    observer.progressOf("irradiance"));
    }));
    maps.irradiance = std::move(irradiance);
  }
  if (settings.harmonics_degree > 0)
    maps.radiance = radianceHarmonics(light, settings.harmonics_degree, settings.source_from_target);
  return maps;
}

}  // namespace mirrorball
