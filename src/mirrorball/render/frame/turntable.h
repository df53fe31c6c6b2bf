#pragma once

#include <span>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

enum class Turn { camera, model, environment, object };  ///< what turns in a turntable

/// Pictures of something that makes one full turn.
struct Turntable {
  int frames = 0;  ///< 0: one picture, and no turntable
  Turn turn = Turn::camera;
  int object = 0;  ///< of Turn::object: which of Scene::instances, from 1 on
};

/// The table of a turntable's options.
std::span<const Option<Turntable>> turntableOptions();

/// The settings of a picture in which something is turned about the upright axis, +Z towards +X: the model and the
/// camera about the axis through the camera's target. What is not turned stays in the picture as it was: with
/// Turn::model the environment and the lights keep their place behind the camera's back.
///
/// An object goes round by orbited(), and nothing else moves.
///
/// settings    framed (framed(), scene/camera/framing.h), so that all pictures have the same target and distance
/// bounds      of what the camera stands before: its middle is the target of settings that have none
FrameSettings turned(FrameSettings settings, Turn what, float angle_deg, const BoundingSphere& bounds);

/// Whether the model's shadow turns about its foot (CameraOptions::ground_light_turns): with the environment, or since
/// the model turns, or an object of it, in light that stands still.
bool turnsShadow(Turn what);

/// The settings of a picture of a scene, for another scene in which camera and ground stay where they are: what counts
/// in model radii, or from the model's middle, is given in numbers.
///
/// errors   as placedProxy's
Result<FrameSettings> standingStill(FrameSettings settings, const Scene& scene, const BoundingSphere& bounds,
                                    const BoundingSphere& other_bounds);

/// The instances of a scene of which one has gone round the upright axis, +Z towards +X, with its parts (withParts).
///
/// axis   a place on it; world
std::vector<Instance> orbited(const Scene& scene, int instance, glm::vec3 axis, float angle_deg);

}  // namespace mirrorball
