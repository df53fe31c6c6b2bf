#pragma once

#include <functional>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/projection.h"
#include "mirrorball/rays/ray.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// The ray through a place of a picture, in pixels from its top left corner; nothing where the picture shows nothing.
using CameraRays = std::function<std::optional<Ray>(glm::vec2 pixel)>;

/// media   that the camera is in
CameraRays raysOf(const Camera& camera, glm::ivec2 size, const formula::Media& media);

/// The rays of a map of all directions around a point, its images one below the other.
///
/// size     of each image
/// nearest  distance from which on surfaces are met
CameraRays raysOfMap(Projection projection, glm::ivec2 size, glm::vec3 position, float nearest,
                     const formula::Media& media);

}  // namespace mirrorball
