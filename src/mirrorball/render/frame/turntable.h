#pragma once

#include <span>

#include "mirrorball/base/option.h"
#include "mirrorball/render/frame/frame_settings.h"

namespace mirrorball {

enum class Turn { camera, model, environment };  ///< what turns in a turntable

/// Pictures of something that makes one full turn.
struct Turntable {
  int frames = 0;  ///< 0: one picture, and no turntable
  Turn turn = Turn::camera;
};

/// The table of a turntable's options.
std::span<const Option<Turntable>> turntableOptions();

/// The settings of a picture in which something is turned about the upright axis, +Z towards +X: the model and the
/// camera about the axis through the camera's target. What is not turned stays in the picture as it was: with
/// Turn::model the environment and the lights keep their place behind the camera's back.
///
/// settings    with a target and a distance (framed(), scene/camera/framing.h), so that all pictures have the same
FrameSettings turned(FrameSettings settings, Turn what, float angle_deg);

}  // namespace mirrorball
