#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/render/stage/stage.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Draws a scene in an environment: a device, a stage and one view of it, for programs that need no more of each.
class Renderer : public View {
 public:
  /// On an OpenGL context of its own, without a window.
  ///
  /// errors   no_gl
  static Result<Renderer> headless();
  /// On that context, which is current: a window's is Context::adoptCurrent.
  ///
  /// errors   no_gl
  static Result<Renderer> on(gl::Context context);

  // As a stage's.
  Result<void> setScene(Scene scene) { return stage_.setScene(std::move(scene)); }
  Result<void> setEnvironment(Environment environment, const std::optional<CacheFolder>& cache = {}) {
    return stage_.setEnvironment(std::move(environment), cache);
  }
  Result<void> setEnvironment(Environment environment, const PreparedEnvironment& prepared) {
    return stage_.setEnvironment(std::move(environment), prepared);
  }
  Result<void> moveInstances(const std::vector<Instance>& instances) { return stage_.moveInstances(instances); }
  const Scene& scene() const { return stage_.scene(); }
  const BoundingSphere& bounds() const { return stage_.bounds(); }

  /// That it shows: what changes there changes its next sample.
  Stage& stage() { return stage_; }

  // As a device's.
  std::string driver() const { return stage_.device().driver(); }
  Result<void> leave() const { return stage_.device().leave(); }

 private:
  explicit Renderer(Stage stage) : View(stage), stage_(std::move(stage)) {}
  Stage stage_;
};

}  // namespace mirrorball
