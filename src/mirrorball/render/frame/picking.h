#pragma once

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/rays/geometry.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/eye_rays.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What is seen at a place of a picture.
struct Picked {
  std::size_t instance = 0;  ///< index into Scene::instances
  int node = -1;             ///< that shows it: Instance::node
  std::size_t material = 0;  ///< index into Scene::materials
  /// Of the instance's mesh; nothing where frames show it cut into smaller ones.
  std::optional<std::uint32_t> triangle = {};
  glm::vec3 position{0.0f};       ///< world; of the relief where heights move the surface
  glm::vec3 smooth_normal{0.0f};  ///< world, unit, outwards: of the vertices
  glm::vec3 normal{0.0f};         ///< the same with heights and normal map
  glm::vec2 uv{0.0f};             ///< the first texture coordinates
  glm::vec3 reflected{0.0f};      ///< world, unit: where it reflects to
  /// Where it refracts to; nothing where no light goes through, or all is reflected.
  std::optional<glm::vec3> refracted = {};
  glm::vec3 radiance{0.0f};  ///< of the last sample of the pixel, with all that shines through
};

/// What is told of the place where a ray has met a scene; `radiance` is left to who draws.
///
/// scene    prepared for that relief
Picked pickedAt(const EyeRay& ray, const Hit& hit, const Scene& scene, ReliefKind relief);

/// The first surface that an eye's ray meets: of one side alone, those that turn it to the eye; with holes of masks,
/// and of what is blended all that is not wholly clear. A camera in a body of glass sees what is in it.
///
/// scene      prepared for the settings' relief
/// geometry   of the scene, with its reliefs where the settings show them as surfaces
/// returns    nothing: the background is seen
std::optional<Picked> pickAlong(const EyeRay& ray, const Scene& scene, const Geometry& geometry,
                                const FrameSettings& settings);

}  // namespace mirrorball
