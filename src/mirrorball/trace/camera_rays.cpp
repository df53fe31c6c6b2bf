#include "mirrorball/trace/camera_rays.h"

#include <algorithm>

#include "mirrorball/scene/camera/eye_rays.h"

namespace mirrorball {

CameraRays raysOf(const Camera& camera, glm::ivec2 size, const formula::Media& media) {
  return [rays = EyeRays(camera, size), media](glm::vec2 pixel) -> std::optional<Ray> {
    const EyeRay eye = rays.through(pixel);
    return Ray{.origin = eye.origin, .direction = eye.direction, .nearest = eye.nearest, .media = media};
  };
}

CameraRays raysOfMap(Projection projection, glm::ivec2 size, glm::vec3 position, float nearest,
                     const formula::Media& media) {
  return [=](glm::vec2 pixel) -> std::optional<Ray> {
    const int face = std::min(static_cast<int>(pixel.y) / size.y, faceCount(projection) - 1);
    const glm::vec2 place(pixel.x, pixel.y - float(face * size.y));
    const glm::vec2 center = (glm::floor(place) + 0.5f) / glm::vec2(size);
    if (!covers(projection, center)) return std::nullopt;
    // On the rim of a disc, a part of a texel may lie outside.
    const glm::vec2 uv = covers(projection, place / glm::vec2(size)) ? place / glm::vec2(size) : center;
    return Ray{
        .origin = position, .direction = directionAt(projection, {face, uv}), .nearest = nearest, .media = media};
  };
}

}  // namespace mirrorball
