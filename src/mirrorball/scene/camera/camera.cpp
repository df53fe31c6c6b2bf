#include "mirrorball/scene/camera/camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "formula/projection.h"

namespace mirrorball {
namespace {

/// A depth buffer of 24 bits then still tells surfaces apart at the far end that are 1/1700 of their distance apart.
constexpr float kMinNearOverFar = 1e-4f;

/// From the target towards a camera at those angles.
glm::vec3 towardsCamera(float azimuth_rad, float elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad),
          std::cos(elevation_rad) * std::cos(azimuth_rad)};
}

/// Up for that camera: the direction in which elevation grows, which has a value at the poles too.
glm::vec3 upOfCamera(float azimuth_rad, float elevation_rad) {
  return {-std::sin(elevation_rad) * std::sin(azimuth_rad), std::cos(elevation_rad),
          -std::sin(elevation_rad) * std::cos(azimuth_rad)};
}

/// How much more than a ball is seen where it fills the narrower side of the picture.
constexpr float kFramingMargin = 1.06f;

/// The distance in radii from which a ball of radius 1 does.
float framingDistance(float fov_rad, float aspect) {
  const float half_height = std::tan(fov_rad / 2.0f);
  const float narrower = std::atan(half_height * std::min(aspect, 1.0f));
  return kFramingMargin / std::sin(narrower);
}

}  // namespace

glm::mat4 directionsFromClip(const Camera& camera) {
  return glm::inverse(camera.clip_from_view * glm::mat4(glm::mat3(camera.view_from_world)));
}

Camera makeCamera(const CameraOptions& options, const BoundingSphere& bounds, float aspect) {
  const float azimuth = glm::radians(options.azimuth_deg);
  const float elevation = glm::radians(options.elevation_deg);
  const float fov = glm::radians(options.fov_deg);
  const glm::vec3 target = options.target ? bounds.inScene(*options.target) : bounds.center;
  const glm::vec3 backward = towardsCamera(azimuth, elevation);
  const float distance = options.distance.value_or(framingDistance(fov, aspect)) * bounds.radius;

  Camera camera;
  camera.orthographic = options.orthographic_height.has_value();
  camera.forward = -backward;
  camera.position = target + backward * distance;
  camera.view_from_world = glm::lookAt(camera.position, target, upOfCamera(azimuth, elevation));

  // The depths between which the whole model lies. A perspective camera sees nothing behind itself.
  const float center_depth = glm::dot(bounds.center - camera.position, camera.forward);
  const float margin = bounds.radius * 1.01f;
  const float far_depth = std::max(center_depth + margin, bounds.radius * 0.01f);
  if (camera.orthographic) {
    const float height = *options.orthographic_height;
    const float half_height = (height > 0.0f ? height / 2.0f : kFramingMargin / std::min(aspect, 1.0f)) * bounds.radius;
    camera.clip_from_view = glm::ortho(-half_height * aspect, half_height * aspect, -half_height, half_height,
                                       center_depth - margin, center_depth + margin);
  } else {
    const float near_depth = std::max(center_depth - margin, far_depth * kMinNearOverFar);
    camera.clip_from_view = glm::perspective(fov, aspect, near_depth, far_depth);
  }
  return camera;
}

Camera cameraOf(const ModelCamera& of_model, const BoundingSphere& bounds, float aspect) {
  Camera camera;
  camera.orthographic = of_model.orthographic;
  camera.nearest = of_model.nearest;
  camera.position = glm::vec3(of_model.world_from_view[3]);
  camera.forward = -glm::vec3(of_model.world_from_view[2]);
  camera.view_from_world = glm::inverse(of_model.world_from_view);

  const float wider = std::max(of_model.aspect / aspect, 1.0f);
  const float center_depth = glm::dot(bounds.center - camera.position, camera.forward);
  const float margin = bounds.radius * 1.01f;
  const float far_depth = std::max({center_depth + margin, of_model.nearest * 1.01f, bounds.radius * 0.01f});
  const float first_depth = std::max(center_depth - margin, of_model.nearest);
  if (camera.orthographic) {
    const float half_height = of_model.height / 2.0f * wider;
    camera.clip_from_view = glm::ortho(-half_height * aspect, half_height * aspect, -half_height, half_height,
                                       std::max(first_depth, 0.0f), far_depth);
  } else {
    const float fov = 2.0f * std::atan(std::tan(of_model.fov_rad / 2.0f) * wider);
    camera.clip_from_view =
        glm::perspective(fov, aspect, std::max(first_depth, far_depth * kMinNearOverFar), far_depth);
  }
  return camera;
}

Camera mirroredBelow(const Camera& camera, float ground, const BoundingSphere& bounds) {
  const glm::mat4 mirror =
      glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, -1.0f, 1.0f)), glm::vec3(0.0f, -2.0f * ground, 0.0f));
  Camera below = camera;
  below.view_from_world = camera.view_from_world * mirror;
  below.position = glm::vec3(mirror * glm::vec4(camera.position, 1.0f));
  below.forward = glm::vec3(mirror * glm::vec4(camera.forward, 0.0f));
  const float center_depth = glm::dot(bounds.center - below.position, below.forward);
  const float margin = bounds.radius * 1.01f;
  const float far_depth = std::max(center_depth + margin, bounds.radius * 0.01f);
  const float near_depth = center_depth - margin;
  // The depths of glm::ortho and glm::perspective; all else of the projection stays.
  const glm::mat4 depths =
      camera.orthographic ? glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, near_depth, far_depth)
                          : glm::perspective(1.0f, 1.0f, std::max(near_depth, far_depth * kMinNearOverFar), far_depth);
  below.clip_from_view[2][2] = depths[2][2];
  below.clip_from_view[3][2] = depths[3][2];
  return below;
}

DepthRange depthsAround(glm::vec3 position, const BoundingSphere& bounds, std::optional<float> nearest) {
  const float distance = glm::distance(position, bounds.center);
  const float margin = bounds.radius * 1.01f;
  const float farthest = distance + margin;
  // A face's corners are √3 times as far away as its middle.
  const float begin = (distance - margin) / std::sqrt(3.0f);
  const float chosen = nearest.value_or(std::max(begin, farthest * kMinNearOverFar));
  return {chosen, std::max(farthest, chosen * 2.0f)};
}

Camera cubeFaceCamera(int face, glm::vec3 position, const DepthRange& depths) {
  const glm::vec3 middle = formula::cubePoint(face, {0.5f, 0.5f});
  // The table is left-handed, and turns right-handed with t upwards: this is a rotation.
  const glm::vec3 right = formula::cubePoint(face, {1.0f, 0.5f}) - middle;
  const glm::vec3 up = formula::cubePoint(face, {0.5f, 1.0f}) - middle;
  Camera camera;
  camera.position = position;
  camera.forward = middle;
  const glm::mat4 turn(glm::transpose(glm::mat3(right, up, -middle)));
  camera.view_from_world = glm::translate(turn, -position);
  camera.clip_from_view = glm::perspective(glm::radians(90.0f), 1.0f, depths.nearest, depths.farthest);
  return camera;
}

}  // namespace mirrorball
