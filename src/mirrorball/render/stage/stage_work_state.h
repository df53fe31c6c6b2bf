#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/render/light/environment_light.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/render/stage/stage_work.h"
#include "mirrorball/render/stage/staged_scene.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What work is made from, and what was made.
struct StageWork::State {
  /// A copy of the stage's; in the form that the frames show, once that is there.
  std::shared_ptr<Scene> scene;
  bool has_form = false;
  FrameSettings settings;
  bool picks = false;
  ScenePreparation preparation;
  PreparationMeans means;
  std::uint64_t version;         ///< of the scene
  StagedScene::Rows known = {};  ///< what the stage has of that form
  /// Of whose light a ground's shadow is to be; null: there is none to be made.
  std::shared_ptr<const Environment> environment = {};
  std::uint64_t light_version = 0;
  /// Whose cubes are to be made for the frames' kind of sun; null: they are there.
  std::shared_ptr<const Environment> lacks_cubes = {};

  bool makes_form = false;  ///< `scene` has become one that the stage has not
  StagedScene::Made made = {};
  std::optional<LightSampler> ground_sampler = {};
  std::optional<PreparedEnvironment> cubes = {};
};

}  // namespace mirrorball
