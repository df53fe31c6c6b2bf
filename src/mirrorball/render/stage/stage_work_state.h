#pragma once

#include <cstdint>

#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/render/stage/stage_work.h"
#include "mirrorball/render/stage/staged_scene.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What work is made from, and what was made.
struct StageWork::State {
  Scene scene;  ///< the stage's; in the form that the frames show, once that is there
  bool has_form = false;
  FrameSettings settings;
  ScenePreparation preparation;
  PreparationMeans means;
  std::uint64_t version;  ///< of the scene

  bool makes_form = false;  ///< `scene` has become one that the stage has not
  StagedScene::Made made = {};
};

}  // namespace mirrorball
