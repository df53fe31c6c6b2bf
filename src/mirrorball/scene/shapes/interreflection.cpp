#include "mirrorball/scene/shapes/interreflection.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

constexpr int kSegments = 192;  ///< about the bowl's axis
constexpr int kRings = 96;      ///< from its opening to its bottom

/// The light that enters through a cap of a sphere's area's share: cos of its half angle is 1 − 2 share.
constexpr float kHeightOfOpening = 1.0f - 2.0f * kBowlOpenShare;  // in radii of the inner sphere
constexpr float kInnerRadius = 0.9f;                              // of the outer one
constexpr float kHeight = kHeightOfOpening * kInnerRadius;

/// Vertices on a circle about the Y axis, with normals in a plane through it. The first is there twice: its texture
/// coordinates begin and end.
void addRing(Mesh& mesh, float radius, float height, glm::vec2 normal, float v) {
  for (int segment = 0; segment <= kSegments; ++segment) {
    const double u = double(segment) / kSegments;
    const double longitude = 2.0 * std::numbers::pi * (segment == kSegments ? -0.5 : u - 0.5);
    const glm::vec3 outwards(std::sin(longitude), 0.0, std::cos(longitude));
    Vertex vertex;
    vertex.position = radius * outwards + glm::vec3(0.0f, height, 0.0f);
    vertex.normal = normal.x * outwards + glm::vec3(0.0f, normal.y, 0.0f);
    vertex.tangent = glm::vec4(std::cos(longitude), 0.0, -std::sin(longitude), 1.0);
    vertex.uv[0] = vertex.uv[1] = glm::vec2(u, v);
    mesh.vertices.push_back(vertex);
  }
}

/// From the upward axis, as seen from the middle of a sphere of that radius.
double angleOfOpening(float radius) { return std::acos(double(kHeight) / double(radius)); }

/// A sphere about the origin below the opening, as rings from there to the bottom.
Mesh shell(float radius) {
  Mesh mesh;
  const double first = angleOfOpening(radius);
  for (int ring = 0; ring <= kRings; ++ring) {
    const double v = double(ring) / kRings;
    const double angle = std::lerp(first, std::numbers::pi, v);
    const glm::vec2 outwards(ring == kRings ? 0.0 : std::sin(angle), std::cos(angle));
    addRing(mesh, radius * outwards.x, ring == 0 ? kHeight : radius * outwards.y, outwards, static_cast<float>(v));
  }
  addGridTriangles(mesh, 0, kRings, kSegments);
  return mesh;
}

/// The same seen from inside.
Mesh insideOut(Mesh mesh) {
  for (Vertex& vertex : mesh.vertices) {
    vertex.normal = -vertex.normal;
    vertex.tangent = glm::vec4(-glm::vec3(vertex.tangent), vertex.tangent.w);
    for (glm::vec2& uv : vertex.uv) uv.x = 1.0f - uv.x;
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

/// The flat ring between the two spheres.
void addRim(Mesh& mesh) {
  const auto radiusAt = [](float sphere) { return sphere * static_cast<float>(std::sin(angleOfOpening(sphere))); };
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  addRing(mesh, radiusAt(kInnerRadius), kHeight, {0.0f, 1.0f}, 0.0f);
  addRing(mesh, radiusAt(1.0f), kHeight, {0.0f, 1.0f}, 1.0f);
  addGridTriangles(mesh, first, 1, kSegments);
}

/// Moves and scales a scene into the unit sphere.
void fitToUnitSphere(Scene& scene) {
  const BoundingSphere bounds = boundingSphere(scene);
  const glm::mat4 fitted = glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(1.0f / bounds.radius)), -bounds.center);
  for (Instance& instance : scene.instances) instance.world_from_object = fitted * instance.world_from_object;
}

}  // namespace

Scene spheresScene(float gap) {
  assert(gap >= 0.0f);
  Scene scene = sceneOf(sphereMesh(), *materialNamed("mirror"));
  const glm::vec3 from_middle(1.0f + gap / 2.0f, 0.0f, 0.0f);
  scene.instances = {{0, glm::translate(glm::mat4(1.0f), -from_middle)},
                     {0, glm::translate(glm::mat4(1.0f), from_middle)}};
  fitToUnitSphere(scene);
  return scene;
}

Scene bowlScene() {
  Material clay;
  clay.base_color = glm::vec3(0.80f, 0.74f, 0.65f);
  clay.perceptual_roughness = 0.8f;
  clay.name = "outside";
  Mesh outside = shell(1.0f);
  addRim(outside);
  Scene scene = sceneOf(std::move(outside), clay);

  clay.name = "inside";
  clay.occlusion_map.texture = 0;
  scene.textures.push_back({.image = Image8(1, 1, 4, 255)});
  scene.textures[0].image.texel(0, 0)[0] = static_cast<std::uint8_t>(std::lround(255.0f * kBowlOpenShare));
  Mesh inside = insideOut(shell(kInnerRadius));
  inside.material = 1;
  scene.materials.push_back(clay);
  scene.meshes.push_back(std::move(inside));
  scene.instances.push_back({.mesh = 1});
  fitToUnitSphere(scene);
  return scene;
}

}  // namespace mirrorball
