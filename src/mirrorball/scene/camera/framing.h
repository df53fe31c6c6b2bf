#pragma once

#include <span>
#include <vector>

#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/mesh_file/positions.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What a framing has to hold: the model as it stands; or the model turned by any angle about the upright axis through
/// the target, as a turntable shows it. With CameraOptions::ground_light_turns the light goes round, too.
enum class FramingOf { still, whole_turn };

/// How far from the middle of a model's foot a shadow on the ground is drawn, and a framing holds it, in model radii:
/// there it has faded out, and a low sun does not make the model a dot.
constexpr float kShadowReach = 4.0f;

/// The elevation of a light from which down a framing holds less and less of its shadow, at the horizon none: a sun
/// that sets moves the camera without a jump.
constexpr float kWholeShadow_deg = 5.0f;

/// Puts a camera where the model fills the picture: its projection touches a border 1/32 of the picture's side inside
/// of two opposite edges at least, and lies in the middle; so does the ground around its foot as far as the options
/// say, with the shadow that falls there. Direction and angle of view are the options' own; so is the target, which is
/// in the middle of the picture then.
///
/// A point (x, y, z) in the frame of the camera's axes, z towards the camera, is seen right of nothing but the border's
/// slope t if x − cx ≤ t (cz − z). So a camera at c sees all points if cx + t cz ≥ max(x + t z), and likewise on the
/// other three sides: linear conditions, of which the nearest camera follows without iteration.
///
/// bounds   of the scene
/// aspect   width over height of the picture
/// returns  `options` with a target, and a distance or a height of the parallel projection; as they were where they say
///          how much is to be seen already, and for an empty scene
/// runs     of the scene, which make it some ten times as fast as it stands; the same camera without them
/// cost     some ten passes over all vertices, or with runs over all runs
CameraOptions framed(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options, float aspect,
                     FramingOf what = FramingOf::still, std::span<const std::vector<PositionRun>> runs = {});

/// The camera of a picture of that size: framed, or the scene's own of that name.
///
/// runs     as framed()'s
/// errors   usage: the scene has no camera of the options' name; the camera is too far away from it to see anything
Result<Camera> framedCamera(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options,
                            glm::ivec2 size, std::span<const std::vector<PositionRun>> runs = {});

}  // namespace mirrorball
