#pragma once

#include <compare>
#include <cstdint>
#include <string_view>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What texture coordinates are made of: a formula of formula/surface/texgen.glsl.
enum class Generated : std::uint8_t { reflection, normal, sphere, object, place };

/// The name of the formula.
std::string_view formulaOf(Generated generated);

/// Where base_color_map's coordinates come from.
enum class PictureFrom : std::uint8_t {
  mesh,
  transformed_mesh,  ///< the mesh's times a matrix
  generated,
  projector,  ///< generated, and the picture is shown once, where a projector sends it
};

/// Which coordinates a frame's shaders compute.
struct CoordinateChoice {
  Generated look_up = Generated::reflection;  ///< of the light that is reflected
  bool is_sphere_map = false;                 ///< they are places of a sphere map, and no directions
  PictureFrom picture_from = PictureFrom::mesh;
  Generated picture = Generated::object;  ///< of base_color_map, where they are generated

  auto operator<=>(const CoordinateChoice&) const = default;
};

/// What the settings' `texgen` and `texture_matrix` wrap: base_color_map if a material of the scene has one, else the
/// environment, for which `texgen` takes the place of `mapping`.
CoordinateChoice coordinateChoice(const Scene& scene, const FrameSettings& settings);

/// The matrices by which the formulas' coordinates are multiplied.
struct CoordinateMatrices {
  glm::mat4 look_up{1.0f};  ///< to a direction of the world, or to the (s, t, r, q) of a sphere map
  glm::mat4 picture{1.0f};  ///< to (s, t, r, q)
};

/// Coordinates in the frame that OpenGL has them in, then the settings' texture matrix: the eye's for a picture and for
/// Texgen::eye_linear; for the environment its own, with which it turns.
///
/// bounds    of the scene: a projector's picture just covers it
/// errors    usage: Texgen::light without a light; a texture matrix that leaves no coordinates
Result<CoordinateMatrices> coordinateMatrices(const Scene& scene, const BoundingSphere& bounds, const Camera& camera,
                                              const FrameSettings& settings);

}  // namespace mirrorball
