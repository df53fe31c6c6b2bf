#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/surface/map_levels.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/view/viewer/background_task.h"

namespace mirrorball {

// What a viewer loads beside itself.

/// A model as its file has it, and what is known of it that takes a while to find.
struct LoadedModel {
  Scene scene;
  LevelsOfMaps levels;
  bool hides_itself = false;  ///< SceneTraits'
};

/// errors   as loadModel's; interrupted
Result<LoadedModel> loadedModel(const std::string& name, bool inside_only, const ProgressFunction& progress);

/// An environment as it is, and as the GPU takes it.
struct LoadedLight {
  Environment environment;
  PreparedEnvironment prepared;
  std::vector<std::string> files;  ///< that were read
};

/// errors   as loadEnvironment's; interrupted
Result<LoadedLight> loadedLight(const std::string& name, const std::optional<CacheFolder>& cache,
                                const ProgressFunction& progress);

/// Something that is loaded by its name, when another name is asked for.
template <typename Value>
class LoadingByName {
 public:
  using Load = std::function<Result<Value>(const std::string& name, const ProgressFunction& progress)>;

  /// Begins to load it, unless it was asked for last.
  void askFor(const std::string& name, Load load) {
    if (asked_for_ == name) return;
    asked_for_ = name;
    problem_.clear();
    task_.begin([name, load = std::move(load)](const ProgressFunction& progress) { return load(name, progress); });
  }

  /// Loads it again when it is next asked for: its files have changed.
  void forget() { asked_for_.clear(); }

  /// What was loaded, once. What could not be is told by problem().
  std::optional<Value> take() {
    auto ready = task_.take();
    if (!ready) return std::nullopt;
    if (*ready) return std::move(**ready);
    problem_ = ready->error().message;
    return std::nullopt;
  }

  bool isRunning() const { return task_.isRunning(); }
  double share() const { return task_.share(); }
  bool isAskedFor(const std::string& name) const { return asked_for_ == name; }
  /// That was asked for last; empty: none.
  const std::string& name() const { return asked_for_; }
  const std::string& problem() const { return problem_; }

 private:
  BackgroundTask<Value> task_;
  std::string asked_for_;
  std::string problem_;
};

}  // namespace mirrorball
