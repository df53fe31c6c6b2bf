#pragma once

#include <glm/glm.hpp>

#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

// What a hand does to a camera. All take options that say where it stands, as placedCamera() makes them, and leave the
// name of a model's camera, which stands still. Places in a picture are pixels from its top left corner; distances are
// in model radii, as the options' own.

/// Options with a target and a distance, or a height of the parallel projection: the same picture, told in full.
///
/// aspect   width over height of the picture
CameraOptions placedCamera(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options,
                           float aspect);

/// Goes round the target: the model turns with the hand, half a turn for the picture's shorter side. At the poles the
/// camera stops.
///
/// by_px   how far the hand has moved
CameraOptions orbited(CameraOptions camera, glm::vec2 by_px, glm::ivec2 size);

/// Shifts the target across the picture, so that what lies in its depth stays under the hand.
CameraOptions panned(CameraOptions camera, const BoundingSphere& bounds, glm::vec2 by_px, glm::ivec2 size);

/// Comes nearer to what lies at the target's depth under the pointer, which stays under it.
///
/// factor   of the distance, or of the height of the parallel projection; above 0. The distance stays between 0.001 and
///          1000 radii
CameraOptions zoomed(CameraOptions camera, const BoundingSphere& bounds, float factor, glm::vec2 pointer_px,
                     glm::ivec2 size);

/// Goes where it looks, with its target before it.
///
/// by   to the right, up and ahead, in model radii
CameraOptions flown(CameraOptions camera, const BoundingSphere& bounds, glm::vec3 by);

/// Looks around from where it stands: its target goes round it. A parallel one, which stands nowhere, is orbited.
CameraOptions lookedAround(CameraOptions camera, const BoundingSphere& bounds, glm::vec2 by_px, glm::ivec2 size);

/// Along which axis one looks at the middle of the model.
enum class AxisView { front, back, left, right, top, bottom };

/// Angle of view and kind of projection stay.
CameraOptions alongAxis(CameraOptions camera, AxisView view);

/// Holds all of the model, from the same side; leaves a model's camera.
CameraOptions framingAll(CameraOptions camera);

}  // namespace mirrorball
