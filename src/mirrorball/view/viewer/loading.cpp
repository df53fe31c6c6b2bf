#include "mirrorball/view/viewer/loading.h"

#include <utility>

#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/render/settings/quality.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {

Result<LoadedModel> loadedModel(const std::string& name, bool inside_only, const ProgressFunction& progress) {
  MIRRORBALL_TRY(scene, loadModel(name, {.inside_only = inside_only, .progress = partOf(progress, 0, 100, 200)}));
  MIRRORBALL_TRY(levels, makeMapLevels(scene, partOf(progress, 100, 100, 200)));
  bool hides_itself = false;
  if (!traitsOf(scene).is_huge) {
    MIRRORBALL_TRY(hides, hidesItself(scene));
    hides_itself = hides;
  }
  return LoadedModel{std::move(scene), std::move(levels), hides_itself};
}

Result<LoadedLight> loadedLight(const AskedMap& source, const std::optional<CacheFolder>& cache,
                                const ProgressFunction& progress) {
  MIRRORBALL_TRY(map, loadMap(source, {}, progress));
  LoadedEnvironment& loaded = map.loaded;
  if (EnvironmentMap* images = loaded.environment.map()) raiseNegativeLight(*images);
  MIRRORBALL_TRY(prepared, prepareEnvironment(loaded.environment, cache, progress));
  MIRRORBALL_TRY(strong_sun, strongSun(loaded.environment));
  return LoadedLight{std::move(loaded.environment), std::move(prepared), std::move(loaded.files), std::move(map.remark),
                     strong_sun};
}

}  // namespace mirrorball
