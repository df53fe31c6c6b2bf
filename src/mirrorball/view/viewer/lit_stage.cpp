#include "mirrorball/view/viewer/lit_stage.h"

#include <utility>

#include "mirrorball/view/viewer/told.h"

namespace mirrorball {

Result<void> LitStage::follow(ShownModel& model, const AskedMap& map, const std::optional<CacheFolder>& cache) {
  light_.askFor(map, [cache](const AskedMap& asked, const ProgressFunction& progress) {
    return loadedLight(asked, cache, progress);
  });
  if (auto light = light_.take()) {
    watch_.watch(light->files);
    remark_ = std::move(light->remark);
    const auto set = stage_.setEnvironment(std::move(light->environment), light->prepared);
    has_light_ = has_light_ || set;
    ++version_;
    MIRRORBALL_TRY_VOID(tell(set, problem_of_light_));
  }
  if (model.version() == model_version_) return {};
  model_version_ = model.version();
  ++version_;
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
