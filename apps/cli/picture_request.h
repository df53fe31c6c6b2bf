#pragma once

#include "cli/command.h"
#include "cli/scene_inputs.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball::cli {

/// What decides how a picture of a model in an environment looks: which light, which programs of which scene.
struct PictureRequest {
  SceneRequest scene{.wish = {Quality::good}};
  FrameSettings frame = {};
  MaterialChanges materials = {};
  GivenOptions stated = {};  ///< of the options
};

/// Adds the options of it, which `render` and what prepares for it take, but for the model.
void addPictureOptions(Command& command, PictureRequest& request);

/// Fills in what follows once all options are read: the showcase without an environment stands where it looks best.
void setTheStage(PictureRequest& request);

/// The frame, if its options agree.
///
/// errors   as checkSettings'
Result<FrameSettings> checkedFrame(const PictureRequest& request);

}  // namespace mirrorball::cli
