#include "mirrorball/scene/shapes/interreflection.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/revolution.h"

namespace mirrorball {
namespace {

constexpr int kBowlSegments = 192;  ///< about the bowl's axis
constexpr int kRings = 96;          ///< of each of its two walls

/// The light that enters through a cap of a sphere's area's share: cos of its half angle is 1 − 2 share.
constexpr double kHeightOfOpening = 1.0 - 2.0 * double(kBowlOpenShare);  // in radii of the inner sphere
constexpr double kInnerRadius = 0.9;                                     // of the outer one

/// How far above its equator a sphere of that radius is cut off.
double elevationOfRim(double radius) { return glm::degrees(std::asin(kHeightOfOpening * kInnerRadius / radius)); }

constexpr std::size_t kInsidePoints = kRings + 1;  ///< of the profile, its first ones

/// From the middle of the inside up to the rim, over its flat ring, and down to the middle of the outside.
std::vector<ProfilePoint> bowlProfile() {
  std::vector<ProfilePoint> profile;
  // The inside's normal points to the middle: at the bottom upwards, at the rim down by as much as the rim is up.
  addArc(profile, glm::dvec2(0.0), -kInnerRadius, 90.0, 180.0 + elevationOfRim(kInnerRadius), kRings);
  std::vector<ProfilePoint> outside;
  addArc(outside, glm::dvec2(0.0), 1.0, elevationOfRim(1.0), -90.0, kRings);
  profile.push_back({profile.back().place, {0.0, 1.0}});
  profile.push_back({outside.front().place, {0.0, 1.0}});
  profile.insert(profile.end(), outside.begin(), outside.end());
  return profile;
}

/// The bowl as one closed surface. In the second set of texture coordinates all of the inside is the middle of an
/// upper texel, and all else that of a lower one.
Mesh bowlMesh() {
  Mesh mesh = revolvedMesh(bowlProfile(), kBowlSegments);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].uv[1] = {0.5f, i < kInsidePoints * (kBowlSegments + 1) ? 0.25f : 0.75f};
  return mesh;
}

}  // namespace

Scene spheresScene(float gap) {
  assert(gap >= 0.0f);
  Scene scene = meshScene(sphereMesh(), *materialNamed("mirror"));
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
  clay.name = "clay";
  clay.occlusion_map = {.texture = 0, .uv_set = 1};
  Scene scene = meshScene(bowlMesh(), clay);
  scene.textures.push_back({.image = Image8(1, 2, 4, 255), .nearest = true});
  scene.textures[0].image.edit().texel(0, 0)[0] = static_cast<std::uint8_t>(std::lround(255.0f * kBowlOpenShare));
  fitToUnitSphere(scene);
  return scene;
}

}  // namespace mirrorball
