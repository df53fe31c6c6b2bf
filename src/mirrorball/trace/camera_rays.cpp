#include "mirrorball/trace/camera_rays.h"

#include <algorithm>

namespace mirrorball {

CameraRays raysOf(const Camera& camera, glm::ivec2 size, const formula::Media& media) {
  const auto ndcOf = [=](glm::vec2 pixel) {
    return glm::vec2(2.0f * pixel.x / float(size.x) - 1.0f, 1.0f - 2.0f * pixel.y / float(size.y));
  };
  if (camera.orthographic) {
    const glm::mat4 places = glm::inverse(camera.clip_from_view * camera.view_from_world);
    return [=, forward = camera.forward](glm::vec2 pixel) -> std::optional<Ray> {
      const glm::vec4 origin = places * glm::vec4(ndcOf(pixel), -1.0f, 1.0f);
      return Ray{.origin = glm::vec3(origin) / origin.w, .direction = forward, .media = media};
    };
  }
  const glm::mat4 directions = directionsFromClip(camera);
  const auto farPoint = [&](glm::vec2 ndc) {
    const glm::vec4 point = directions * glm::vec4(ndc, 1.0f, 1.0f);
    return glm::vec3(point) / point.w;
  };
  // Points of the far plane follow each other evenly.
  const glm::vec3 middle = farPoint({0.0f, 0.0f});
  const glm::vec3 right = farPoint({1.0f, 0.0f}) - middle, up = farPoint({0.0f, 1.0f}) - middle;
  return [=, position = camera.position, nearest = camera.nearest,
          forward = camera.forward](glm::vec2 pixel) -> std::optional<Ray> {
    const glm::vec2 ndc = ndcOf(pixel);
    const glm::vec3 direction = glm::normalize(middle + ndc.x * right + ndc.y * up);
    return Ray{
        .origin = position, .direction = direction, .nearest = nearest / glm::dot(direction, forward), .media = media};
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
