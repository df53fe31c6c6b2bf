#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/scene_inputs.h"
#include "cli/stage_clock.h"
#include "mirrorball/codec/color/output_primaries.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/scene/camera/framing.h"

namespace mirrorball::cli {

/// How pictures go into their files.
struct PictureForm {
  bool gain_map = false;                                ///< beside each: savePictureWithGainMap
  OutputPrimaries primaries = OutputPrimaries::rec709;  ///< of each
};

/// Adds the options of it.
void addPictureForm(Command& command, PictureForm& form);

/// The settings of a frame that a picture with a gain map is made of: its radiance, without the colour of the display.
FrameSettings settingsForGainMap(FrameSettings settings);

/// errors   usage: something is to turn in a single picture
Result<void> checkTurn(const Turntable& turntable);

/// Where pictures go.
struct PictureFiles {
  std::vector<std::string> paths;
  PictureForm form = {};
};

/// Writes the picture that a display shows of radiance.
///
/// radiance  4 channels, alpha premultiplied, without the colour of the display that lies behind it
/// errors    as writeImage's
Result<void> writeShown(const std::string& output, Image radiance, const FrameSettings& frame, const PictureForm& form);

/// Draws one picture and writes it.
///
/// form     with a gain map the settings resolve radiance
/// errors   as Renderer::draw's and writeImage's
Result<void> renderFrame(Renderer& renderer, const FrameSettings& settings, const std::string& output,
                         const PictureForm& form, StageClock& clock, const ProgressFunction& progress);

/// What a camera is to hold in a turntable. With a turning environment the model stands still before it.
FramingOf framingOf(Turn turn);

/// Draws the pictures of a full turn.
///
/// settings   with a framed camera
/// errors     as renderFrame's; interrupted
Result<void> renderTurntable(Renderer& renderer, const FrameSettings& settings, const Turntable& turntable,
                             const PictureFiles& files, StageClock& clock);

/// What is asked for of an animation over its length.
struct AnimationRequest {
  const SceneRequest& scene;  ///< with the choice of an animation
  const MaterialChanges& materials;
  const Turntable& turntable;
  bool turns;  ///< makes a full turn too; else the camera stands still
};

/// Draws pictures that are spread evenly over the length of an animation, of which the last is one step before the end.
/// The camera and a ground stay where they hold the model at some 32 of those times.
///
/// errors   usage; as loadModel's, posed's and renderFrame's; interrupted
Result<void> renderAnimation(Renderer& renderer, const FrameSettings& settings, const AnimationRequest& request,
                             const PictureFiles& files, StageClock& clock);

}  // namespace mirrorball::cli
