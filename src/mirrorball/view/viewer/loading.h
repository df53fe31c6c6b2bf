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
#include "mirrorball/view/viewer/map_loading.h"

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
  std::vector<std::string> files;            ///< that were read
  std::string remark = {};                   ///< LoadedMap's
  std::optional<glm::vec3> strong_sun = {};  ///< strongSun() of it
};

/// errors   as loadMap's; interrupted
Result<LoadedLight> loadedLight(const AskedMap& source, const std::optional<CacheFolder>& cache,
                                const ProgressFunction& progress);

// The name of what is asked for.
inline const std::string& nameOf(const std::string& asked) { return asked; }
inline const std::string& nameOf(const AskedMap& asked) { return asked.name; }

/// Something that is loaded by its name, when another name is asked for.
///
/// Name   or more than a name, all of which says what is loaded
template <typename Value, typename Name = std::string>
class LoadingByName {
 public:
  using Load = std::function<Result<Value>(const Name& name, const ProgressFunction& progress)>;

  /// Begins to load it, unless it was asked for last.
  ///
  /// returns  whether it has begun
  bool askFor(const Name& name, Load load) {
    if (asked_for_ == name) return false;
    asked_for_ = name;
    problem_.clear();
    task_.begin([name, load = std::move(load)](const ProgressFunction& progress) { return load(name, progress); });
    return true;
  }

  /// Loads it again when it is next asked for: its files have changed.
  void forget() { asked_for_ = Name(); }

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
  bool isAskedFor(const Name& name) const { return asked_for_ == name; }
  /// That was asked for last; empty: none.
  const std::string& name() const { return nameOf(asked_for_); }
  const Name& asked() const { return asked_for_; }
  const std::string& problem() const { return problem_; }

 private:
  BackgroundTask<Value> task_;
  Name asked_for_;
  std::string problem_;
};

}  // namespace mirrorball
