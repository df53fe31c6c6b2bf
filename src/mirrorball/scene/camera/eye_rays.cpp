#include "mirrorball/scene/camera/eye_rays.h"

namespace mirrorball {

EyeRays::EyeRays(const Camera& camera, glm::ivec2 size) : size_(size), camera_(camera) {
  if (camera.orthographic) {
    places_ = glm::inverse(camera.clip_from_view * camera.view_from_world);
    return;
  }
  const glm::mat4 directions = directionsFromClip(camera);
  const auto farPoint = [&](glm::vec2 ndc) {
    const glm::vec4 point = directions * glm::vec4(ndc, 1.0f, 1.0f);
    return glm::vec3(point) / point.w;
  };
  middle_ = farPoint({0.0f, 0.0f});
  right_ = farPoint({1.0f, 0.0f}) - middle_;
  up_ = farPoint({0.0f, 1.0f}) - middle_;
}

EyeRay EyeRays::through(glm::vec2 pixel) const {
  const glm::vec2 ndc(2.0f * pixel.x / size_.x - 1.0f, 1.0f - 2.0f * pixel.y / size_.y);
  if (camera_.orthographic) {
    const glm::vec4 origin = places_ * glm::vec4(ndc, -1.0f, 1.0f);
    return {glm::vec3(origin) / origin.w, camera_.forward};
  }
  const glm::vec3 direction = glm::normalize(middle_ + ndc.x * right_ + ndc.y * up_);
  return {camera_.position, direction, camera_.nearest / glm::dot(direction, camera_.forward)};
}

}  // namespace mirrorball
