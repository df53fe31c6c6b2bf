#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// How a frame is read that has been drawn.
enum class Shown {
  picture,  ///< View::picture
  light,    ///< View::displayedLight
};

/// Makes all that the first picture of a scene waits for and that drivers keep for later processes: compiles the
/// programs of a frame. What the cache folder keeps was made when the inputs were loaded.
///
/// The frame is drawn small, to the picture, and one sample of it as it is; with new contexts again until the driver's
/// cache does not grow any more, as a second and a third process would.
///
/// inputs    of loadRenderInputs
/// settings  those of the frame, filled in
/// progress  counts the programs of surfaces
/// shown     how the frame is read
/// errors    as Renderer's and View::draw's; interrupted
/// cost      that of compiling the programs, and for each of usually two or three rounds that of preparing the scene
///           and of a sample of the frame; memory for a second copy of the environment
Result<void> warmUp(RenderInputs inputs, const FrameSettings& settings, const ProgressFunction& progress = {},
                    Shown shown = Shown::picture);

}  // namespace mirrorball
