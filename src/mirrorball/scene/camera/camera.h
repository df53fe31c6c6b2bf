#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Position and view of a camera, in the user's terms.
struct CameraOptions {
  std::string name = {};               ///< of one of Scene::cameras, which all else here is then left to; empty: none
  float azimuth_deg = 30.0f;           ///< 0 stands on +Z and looks along −Z, 90 stands on +X
  float elevation_deg = 15.0f;         ///< 90 stands on +Y
  std::optional<float> distance = {};  ///< from the target, in model radii; without it a ball around the model does
  std::optional<glm::dvec3> target = {};  ///< in the file's coordinates; without it the centre of that ball
  float fov_deg = 35.0f;                  ///< vertical field of view
  /// How far around the model's foot a framing holds the ground too, in model radii. 0: it does not.
  float ground_reach = 0.0f;
  /// Towards the light whose shadow on that ground a framing holds too: world, unit. 0, or not above: there is none.
  glm::vec3 ground_light{0.0f};
  /// That light may come from any side, at its elevation: a framing holds its shadow all around the model's foot, and
  /// does not depend on the light's azimuth.
  bool ground_light_turns = false;
  /// Of the view, in model radii; turns perspective off. 0: as without a distance.
  std::optional<float> orthographic_height = {};

  bool operator==(const CameraOptions&) const = default;
};

/// A camera as the renderer needs it: right-handed view space, looking along −Z, +Y up.
struct Camera {
  glm::mat4 view_from_world{1.0f};
  glm::mat4 clip_from_view{1.0f};
  glm::vec3 position{0.0f};              ///< world
  glm::vec3 forward{0.0f, 0.0f, -1.0f};  ///< world, unit
  bool orthographic = false;
  float nearest = 0.0f;  ///< depth before which it sees nothing on purpose: not where depths merely begin
};

/// From clip space to the world as if the camera stood at the origin: so directions are exact however far away it does.
glm::mat4 directionsFromClip(const Camera& camera);

/// Puts a camera in front of a model. framed() (framing.h) chooses target and distance by the model's own outline.
///
/// bounds   the model's bounding sphere
/// aspect   width over height of the picture
Camera makeCamera(const CameraOptions& options, const BoundingSphere& bounds, float aspect);

/// The camera of a model in a picture: all that it is made for is seen, and above and below, or right and left, as much
/// more as the picture is higher or wider. Where it sees to is the model's end.
///
/// aspect   width over height of the picture
Camera cameraOf(const ModelCamera& camera, const BoundingSphere& bounds, float aspect);

/// The mirror image of a camera in a level ground: from below, it sees the scene as the ground shows it, each place at
/// the same pixel. Its view mirrors, so that triangles that are counter-clockwise become clockwise.
///
/// ground   height of the plane [world units]
/// bounds   of the scene, all of which its depths hold
Camera mirroredBelow(const Camera& camera, float ground, const BoundingSphere& bounds);

/// The range of depths that a camera sees, in world units; both are above 0.
struct DepthRange {
  float nearest;
  float farthest;
};

/// The depths that six cameras around a point need to see a whole scene: as far as its farthest point, and from 1/10000
/// of that on, or from where the scene begins if the point is outside of it. Anything nearer is clipped.
///
/// nearest  > 0, in place of that
DepthRange depthsAround(glm::vec3 position, const BoundingSphere& bounds, std::optional<float> nearest = {});

/// A camera at a point that sees exactly one face of a cube around it. What it draws is the face by OpenGL's table
/// (docs/conventions.md) with t growing **upwards**: row by row as OpenGL keeps both its pictures and the faces of its
/// textures, so that one may be copied into the other. As an image, whose first row is on top, it is upside down.
///
/// face     0 … 5: +X −X +Y −Y +Z −Z
Camera cubeFaceCamera(int face, glm::vec3 position, const DepthRange& depths);

}  // namespace mirrorball
