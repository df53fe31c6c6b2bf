#include "mirrorball/view/viewer/lit_stage.h"

#include <atomic>
#include <utility>

#include "mirrorball/view/viewer/told.h"

namespace mirrorball {
namespace {

/// Of all stages no two have the same, so that what was made of one is not taken for another's.
int nextVersion() {
  static std::atomic<int> last = 0;
  return ++last;
}

}  // namespace

Result<void> LitStage::follow(ShownModel& model, const AskedMap& map, const std::optional<CacheFolder>& cache) {
  const bool has_begun = light_.askFor(map, [cache](const AskedMap& asked, const ProgressFunction& progress) {
    return loadedLight(asked, cache, progress);
  });
  if (has_begun) watch_.watch({map.name});  // until it is known what was read
  if (auto light = light_.take()) {
    watch_.watch(light->files);
    remark_ = std::move(light->remark);
    const auto set = stage_.setEnvironment(std::move(light->environment), light->prepared);
    has_light_ = has_light_ || set;
    if (set) strong_sun_ = light->strong_sun;
    version_ = nextVersion();
    MIRRORBALL_TRY_VOID(tell(set, problem_of_light_));
  }
  if (model.version() == model_version_) return {};
  model_version_ = model.version();
  version_ = nextVersion();
  return tell(stage_.setScene(model.scene(), model.takeLevels()), problem_of_model_);
}

bool LitStage::isUpToDate(const ShownModel& model, const AskedMap& map) const {
  return light_.isAskedFor(map) && !light_.isRunning() && model_version_ == model.version();
}

const std::string& LitStage::problem() const {
  if (!light_.problem().empty()) return light_.problem();
  return problem_of_light_.empty() ? problem_of_model_ : problem_of_light_;
}

}  // namespace mirrorball
