#pragma once

#include <optional>
#include <string>

#include "mirrorball/render/stage/stage.h"
#include "mirrorball/view/viewer/file_watch.h"
#include "mirrorball/view/viewer/loading.h"
#include "mirrorball/view/viewer/shown_model.h"

namespace mirrorball {

/// A model in one panorama, which is loaded beside its owner; until another is there, the one before is shown.
class LitStage {
 public:
  explicit LitStage(const Device& device) : stage_(device) {}

  /// Begins to load a panorama, takes what was loaded, and shows the model as it is now.
  ///
  /// errors   no_gl; all else is told by problem()
  Result<void> follow(ShownModel& model, const AskedMap& map, const std::optional<CacheFolder>& cache);

  /// Loads the panorama again if a file of it has changed, when it is next asked for.
  void askDisk() {
    if (watch_.hasChanged()) light_.forget();
  }

  bool isReady() const { return has_light_ && model_version_ > 0; }
  bool isUpToDate(const ShownModel& model, const AskedMap& map) const;
  /// Another after each of its changes, and another than any other stage's.
  int version() const { return version_; }

  Stage& stage() { return stage_; }
  const Stage& stage() const { return stage_; }

  const LoadingByName<LoadedLight, AskedMap>& loading() const { return light_; }
  /// Why it does not show what was asked for; empty: it does.
  const std::string& problem() const;
  /// strongSun() of the light that it shows.
  std::optional<glm::vec3> strongSun() const { return strong_sun_; }
  /// What is doubtful about the light that it shows: LoadedMap's.
  const std::string& remark() const { return remark_; }

 private:
  Stage stage_;
  LoadingByName<LoadedLight, AskedMap> light_;
  FileWatch watch_;
  bool has_light_ = false;
  std::optional<glm::vec3> strong_sun_;
  int model_version_ = 0;
  int version_ = 0;
  std::string problem_of_light_;
  std::string problem_of_model_;
  std::string remark_;
};

}  // namespace mirrorball
