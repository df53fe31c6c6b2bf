#pragma once

#include <cmath>
#include <utility>

#include <glm/glm.hpp>
#include <glm/trigonometric.hpp>

#include "mirrorball/scene/bumpy_pair_testing.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball::testing {

// A wide plane y = 0, facing +Y, with a tile of bumps on each unit: to be seen from so far away that a pixel averages
// many of them away.

constexpr int kTileSide = 512;  // texels
constexpr float kPlaneHalf = 32.0f;

inline Mesh tiledPlane() {
  Mesh mesh;
  for (const float z : {-kPlaneHalf, kPlaneHalf})
    for (const float x : {-kPlaneHalf, kPlaneHalf}) {
      Vertex vertex;
      vertex.position = glm::vec3(x, 0.0f, z);
      vertex.normal = glm::vec3(0.0f, 1.0f, 0.0f);
      vertex.tangent = glm::vec4(1.0f, 0.0f, 0.0f, 1.0f);  // whose bitangent is −Z, along falling v
      vertex.uv[0] = vertex.uv[1] = glm::vec2(x + 0.37f, z + 0.21f);
      mesh.vertices.push_back(vertex);
    }
  mesh.indices = {0, 2, 3, 0, 3, 1};
  return mesh;
}

/// A built-in surface there, as deep over its tile as it is by itself on a sphere.
///
/// steepness   times that
inline Scene bumpyPlane(HeightKind kind, BumpForm form, Material material, float steepness = 1.0f) {
  const HeightSize size = ownSize(kind);
  const float depth = steepness * size.scale * size.frequency / std::sqrt(2.0f);
  return bumpyScene(tiledPlane(), form, std::move(material), builtinHeights(kind, kTileSide), depth);
}

/// A metal that takes no light away.
inline Material whiteMetal(float perceptual_roughness) {
  Material material;
  material.metallic = 1.0f;
  material.base_color = glm::vec3(1.0f);
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

/// A camera above the middle of the plane, 35° up, whose pixels are that many texels wide there.
inline Camera cameraOverPlane(float texels_a_pixel, glm::ivec2 size_px) {
  constexpr float kTanHalf = 0.25f;
  CameraOptions options{.azimuth_deg = 0.0f, .elevation_deg = 35.0f, .target = glm::vec3(0.0f)};
  options.fov_deg = 2.0f * glm::degrees(std::atan(kTanHalf));
  const BoundingSphere bounds{glm::vec3(0.0f), kPlaneHalf * std::sqrt(2.0f)};
  options.distance = texels_a_pixel / float(kTileSide) * float(size_px.y) / (2.0f * kTanHalf * bounds.radius);
  return makeCamera(options, bounds, float(size_px.x) / float(size_px.y));
}

}  // namespace mirrorball::testing
