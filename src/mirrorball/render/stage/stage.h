#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/render/stage/stage_work.h"
#include "mirrorball/render/surface/map_levels.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What is shown: a scene in an environment, on a device, whose parts change one by one. What is computed from it is
/// made when a view first needs it, and again once what it depends on has changed. A copy is the same stage.
///
/// Before a view draws it, it needs an environment; without a scene, that alone is shown.
class Stage {
 public:
  explicit Stage(const Device& device);

  const Device& device() const;

  /// Shows another scene. Of one that is a changed copy of the one before (scene()), only what has changed is sent
  /// again, and what is computed from other parts stays: so meshes, the pixels of textures, heights, instances and
  /// variants (chooseVariant) are changed, instances are hidden, and an animation is played (posed).
  ///
  /// levels   makeMapLevels() of the scene, which may have been made in another thread; optional
  /// errors   no_gl; too_large (a texture for this driver): then the scene is as before
  /// cost     of a changed copy proportional to the instances, materials and textures, and to what has changed
  Result<void> setScene(Scene scene, const LevelsOfMaps& levels = {});

  /// Prepares the environment for drawing, and takes it; values below 0 become 0.
  ///
  /// cache    stores slow results for later processes; optional
  /// errors   no_gl; too_large
  /// cost     about a second on two cores, for a panorama of 1024 rows that is not in the cache;
  ///          some 50 ms for one that is
  Result<void> setEnvironment(Environment environment, const std::optional<CacheFolder>& cache = {});
  /// The same for an environment that was prepared elsewhere, for instance in another thread.
  ///
  /// errors   no_gl; too_large (a texture for this driver)
  Result<void> setEnvironment(Environment environment, const PreparedEnvironment& prepared);

  /// Makes a material of the scene another one.
  ///
  /// errors   usage (there is no such material, or a texture of it is not in the scene); no_gl; too_large: then it is
  ///          as before
  /// cost     one uniform block is sent, and what a frame has that depends on colours is made again when it is next
  ///          drawn: probes, a ground's shadow, reflections in the scene itself. Of a body the triangles are sorted
  ///          anew, too; other textures or heights are sent. What vertices know of the scene is
  ///          found again when a frame next asks for it
  Result<void> setMaterial(std::size_t index, Material material);

  /// Puts a node of the scene's tree (Scene::rig) elsewhere in its parent, with the meshes, cameras and lights below
  /// it; skins that hang on it bend (placeNode). The scene then is as its nodes say: instances that were moved, hidden
  /// or added without them are as before. What a node scales to nothing is not shown: so nodes hide.
  ///
  /// errors   as placeNode's and setScene's
  Result<void> setNode(std::size_t node, const NodePlace& place);

  /// Puts an instance elsewhere, whatever its node is. What vertices knew of the scene is found again when a frame next
  /// asks for it, and a camera that is framed by the scene moves with it.
  ///
  /// errors   usage (there is no such instance; it would be mirrored, or is not finite); no_gl; too_large
  Result<void> setTransform(std::size_t instance, const glm::mat4& world_from_object);
  /// Puts all instances elsewhere.
  ///
  /// errors   usage (others than there are, or of other meshes)
  Result<void> moveInstances(const std::vector<Instance>& instances);

  /// The scene's own lights; those of FrameSettings are a view's. As many as before are of the same nodes; more or
  /// fewer are of none.
  ///
  /// errors   usage (more than Scene::kMaxLights)
  Result<void> setLights(std::vector<ModelLight> lights);

  /// Where what is found of the scene (prepare) is kept for later processes.
  void setCache(const std::optional<CacheFolder>& cache);

  /// Makes what frames with those settings need of the scene, unless it is there (StageWork::run). Views do so where it
  /// has not been done, which may take seconds; here it tells how far it is.
  ///
  /// errors   no_gl; interrupted; too_large
  Result<void> prepare(const FrameSettings& settings, const ProgressFunction& progress = {});

  /// The same in two steps, of which work.run() may be in another thread while this stage is drawn and changes.
  ///
  /// picks    whether places are picked in the frames, too (View::pick)
  /// errors   no_gl
  Result<StageWork> workFor(const FrameSettings& settings, bool picks = false) const;
  /// work     that has run
  /// returns  whether it is of use for the scene; not if that has changed since workFor. Where a ground's shadow comes
  ///          from is taken unless the environment has changed
  /// errors   no_gl; too_large (a texture for this driver)
  Result<bool> take(StageWork work);

  /// Shows it on another device from now on: after the old one's context was lost, all that was there is made again.
  /// Views follow.
  ///
  /// errors   no_gl; too_large (a texture for this driver): then it is as before
  /// cost     as setScene's and setEnvironment's, with the cache of setCache
  Result<void> moveTo(const Device& device);

  /// As it was given, with all changes since; valid until the next one.
  const Scene& scene() const;
  /// Of the scene.
  const BoundingSphere& bounds() const;

  struct State;
  State& state() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

}  // namespace mirrorball
