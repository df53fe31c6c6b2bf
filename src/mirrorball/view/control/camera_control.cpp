#include "mirrorball/view/control/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/place_text.h"
#include "mirrorball/view/control/degrees.h"

namespace mirrorball {
namespace {

constexpr float kNearest = 1e-3f;  // of a target [model radii]
constexpr float kFarthest = 1e3f;

/// The camera's axes in the world, as makeCamera has them.
struct Axes {
  glm::vec3 right, up, backward;
};

Axes axesOf(const CameraOptions& camera) {
  const float azimuth = glm::radians(camera.azimuth_deg);
  const float elevation = glm::radians(camera.elevation_deg);
  const glm::vec3 right(std::cos(azimuth), 0.0f, -std::sin(azimuth));
  const glm::vec3 backward(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                           std::cos(elevation) * std::cos(azimuth));
  return {right, glm::cross(backward, right), backward};
}

/// How much of the world a pixel shows at the target's depth [model radii].
float radiiPerPixel(const CameraOptions& camera, glm::ivec2 size) {
  const float height = camera.orthographic_height
                           ? *camera.orthographic_height
                           : 2.0f * camera.distance.value_or(1.0f) * std::tan(glm::radians(camera.fov_deg) / 2.0f);
  return height / static_cast<float>(std::max(size.y, 1));
}

void turn(CameraOptions& camera, glm::vec2 by_deg) {
  camera.azimuth_deg = wrappedAngle(camera.azimuth_deg + by_deg.x);
  camera.elevation_deg = std::clamp(camera.elevation_deg + by_deg.y, -90.0f, 90.0f);
}

/// Shifts the target.
///
/// by   in model radii
void shift(CameraOptions& camera, const BoundingSphere& bounds, glm::vec3 by) {
  const glm::vec3 before = camera.target ? bounds.inScene(*camera.target) : bounds.center;
  camera.target = placeInFile(before + bounds.radius * by, bounds.origin);
}

}  // namespace

CameraOptions placedCamera(const Scene& scene, const BoundingSphere& bounds, const CameraOptions& options,
                           float aspect) {
  if (!options.name.empty()) return options;
  CameraOptions placed = framed(scene, bounds, options, aspect);
  if (!placed.target) placed.target = placeInFile(bounds.center, bounds.origin);
  // Only a framing asks for the ground.
  placed.ground_reach = 0.0f;
  placed.ground_light = glm::vec3(0.0f);
  placed.ground_light_turns = false;
  return placed;
}

CameraOptions orbited(CameraOptions camera, glm::vec2 by_px, glm::ivec2 size) {
  if (camera.name.empty()) turn(camera, degreesOf(glm::vec2(-by_px.x, by_px.y), size));
  return camera;
}

CameraOptions panned(CameraOptions camera, const BoundingSphere& bounds, glm::vec2 by_px, glm::ivec2 size) {
  if (!camera.name.empty()) return camera;
  const Axes axes = axesOf(camera);
  shift(camera, bounds, radiiPerPixel(camera, size) * (by_px.y * axes.up - by_px.x * axes.right));
  return camera;
}

CameraOptions zoomed(CameraOptions camera, const BoundingSphere& bounds, float factor, glm::vec2 pointer_px,
                     glm::ivec2 size) {
  if (!camera.name.empty()) return camera;
  // One that is beyond already goes no farther, and comes back from there.
  const auto limited = [&](float length) {
    return std::clamp(length * factor, std::min(kNearest, length), std::max(kFarthest, length));
  };
  const float before = radiiPerPixel(camera, size);
  if (camera.orthographic_height)
    camera.orthographic_height = limited(*camera.orthographic_height);
  else
    camera.distance = limited(camera.distance.value_or(1.0f));
  const glm::vec2 from_middle = pointer_px - 0.5f * glm::vec2(size);
  const Axes axes = axesOf(camera);
  shift(camera, bounds,
        (before - radiiPerPixel(camera, size)) * (from_middle.x * axes.right - from_middle.y * axes.up));
  return camera;
}

CameraOptions flown(CameraOptions camera, const BoundingSphere& bounds, glm::vec3 by) {
  if (!camera.name.empty()) return camera;
  const Axes axes = axesOf(camera);
  shift(camera, bounds, by.x * axes.right + by.y * axes.up - by.z * axes.backward);
  return camera;
}

CameraOptions lookedAround(CameraOptions camera, const BoundingSphere& bounds, glm::vec2 by_px, glm::ivec2 size) {
  if (!camera.name.empty()) return camera;
  if (camera.orthographic_height) return orbited(std::move(camera), by_px, size);
  const float distance = camera.distance.value_or(1.0f);
  const glm::vec3 before = axesOf(camera).backward;
  turn(camera, degreesOf(glm::vec2(-by_px.x, by_px.y), size));
  shift(camera, bounds, distance * (before - axesOf(camera).backward));
  return camera;
}

CameraOptions alongAxis(CameraOptions camera, AxisView view) {
  // By AxisView. The model's front is on +Z, where the azimuth is 0.
  constexpr std::array<glm::vec2, 6> kAngles_deg{glm::vec2(0, 0),  glm::vec2(-180, 0), glm::vec2(-90, 0),
                                                 glm::vec2(90, 0), glm::vec2(0, 90),   glm::vec2(0, -90)};
  const glm::vec2 angles_deg = kAngles_deg[static_cast<std::size_t>(view)];
  camera.azimuth_deg = angles_deg.x;
  camera.elevation_deg = angles_deg.y;
  return framingAll(camera);
}

CameraOptions framingAll(CameraOptions camera) {
  camera.name.clear();
  camera.distance.reset();
  camera.target.reset();
  if (camera.orthographic_height) camera.orthographic_height = 0.0f;
  return camera;
}

}  // namespace mirrorball
