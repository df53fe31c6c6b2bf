#pragma once

#include <memory>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/view/inspect/inspector.h"

namespace mirrorball::testing {

inline void addPart(Scene& scene, Mesh mesh, const Material& material, const glm::mat4& world_from_object) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), world_from_object});
  scene.meshes.push_back(std::move(mesh));
}

/// A level square at a height, wide enough for many bounces, that faces up or down.
inline void addSheet(Scene& scene, const Material& material, float height, bool faces_down = false) {
  glm::mat4 place = glm::translate(glm::mat4(1.0f), {0.0f, height, 0.0f});
  if (faces_down) place = glm::rotate(place, glm::radians(180.0f), {1.0f, 0.0f, 0.0f});
  addPart(scene, planeMesh(), material, glm::scale(place, glm::vec3(200.0f)));
}

inline Material mirrorOf(float reflectance, float perceptual_roughness = 0.0f) {
  Material material;
  material.name = "mirror";
  material.base_color = glm::vec3(reflectance);
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  material.fresnel = formula::kFresnelSchlick;
  return material;
}

inline Material clearGlass(float ior = 1.5f) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.perceptual_roughness = 0.0f;
  material.transmission = 1.0f;
  material.ior = ior;
  return material;
}

/// Light that is another one from each direction.
inline glm::vec3 lightFrom(glm::vec3 direction) { return glm::vec3(1.0f) + 0.5f * direction; }

inline LightAround lightAround() { return {.environment = std::make_shared<const Environment>(lightFrom, 32)}; }

constexpr glm::ivec2 kInspectedSize{64, 64};

/// A parallel camera that looks at the origin; its picture is 2 high, a unit has 32 pixels.
inline Camera parallelCamera(float azimuth_deg, float elevation_deg) {
  return makeCamera({.azimuth_deg = azimuth_deg,
                     .elevation_deg = elevation_deg,
                     .target = glm::vec3(0.0f),
                     .orthographic_height = 2.0f},
                    {}, 1.0f);
}

inline Inspector inspectorOf(Scene scene, const InspectorOptions& options = {}) {
  auto inspector = Inspector::make(std::make_shared<const Scene>(std::move(scene)), options);
  EXPECT_TRUE(inspector) << inspector.error().message;
  return std::move(*inspector);
}

/// What a parallel camera sees at a place, from the picture's middle to the right [world units].
inline InspectedSurface surfaceAt(Scene scene, const Camera& camera, float to_the_right = 0.0f,
                                  const LightAround& around = lightAround(), const InspectorOptions& options = {}) {
  const glm::vec2 pixel(32.0f + 32.0f * to_the_right, 32.0f);
  const auto inspection = inspectorOf(std::move(scene), options).inspectedAt(camera, kInspectedSize, pixel, around);
  EXPECT_TRUE(inspection && inspection->surface);
  return inspection && inspection->surface ? *inspection->surface : InspectedSurface();
}

/// The unit vector in the plane x = 0 that points upwards by that angle, and away from +Z.
inline glm::vec3 risingBy(float angle_deg) {
  return {0.0f, std::sin(glm::radians(angle_deg)), -std::cos(glm::radians(angle_deg))};
}

}  // namespace mirrorball::testing
