#include "mirrorball/scene/shapes/tumbler.h"

#include <cmath>
#include <utility>
#include <vector>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/revolution.h"

namespace mirrorball {
namespace {

using glm::dvec2;

// A common tumbler, in mm.
constexpr double kHeight = 110.0;
constexpr double kRimRadius = 40.0;  ///< outside
constexpr double kWall = 3.0;
constexpr double kBottom = 10.0;          ///< thickness
constexpr double kTaperDeg = 3.0;         ///< of the wall, which opens upwards
constexpr double kFootRadius = 4.0;       ///< of the rounding between the outer wall and the base
constexpr double kFloorRadius = 6.0;      ///< of that between the inner wall and the floor
constexpr double kLevel = 0.6 * kHeight;  ///< of the water

constexpr int kTumblerSegments = 192;
constexpr int kQuarter = 24;  ///< steps of a rounding by a quarter of a turn

/// The point at that distance outwards from the middle of the wall (prolonged, where there is none) and at that height.
dvec2 besideWall(double outwards, double height) {
  const double taper = glm::radians(kTaperDeg);
  const dvec2 normal(std::cos(taper), -std::sin(taper));
  const dvec2 down(-std::sin(taper), -std::cos(taper));
  const dvec2 from = dvec2(kRimRadius - kWall / 2, kHeight - kWall / 2) + outwards * normal;
  return from + (height - from.y) / down.y * down;
}

/// The middle of the rounding of the floor's edge, both of the glass and of the water.
dvec2 floorEdge() { return besideWall(-kWall / 2 - kFloorRadius, kBottom + kFloorRadius); }

/// From the middle of the floor up the inner wall, over the rim, down the outer wall to the middle of the base.
std::vector<ProfilePoint> glassProfile() {
  std::vector<ProfilePoint> profile{{{0.0, kBottom}, {0.0, 1.0}}};
  addArc(profile, floorEdge(), -kFloorRadius, 90.0, 180.0 - kTaperDeg, kQuarter);
  addArc(profile, besideWall(0.0, kHeight - kWall / 2), kWall / 2, 180.0 - kTaperDeg, -kTaperDeg, 2 * kQuarter);
  addArc(profile, besideWall(kWall / 2 - kFootRadius, kFootRadius), kFootRadius, -kTaperDeg, -90.0, kQuarter);
  profile.push_back({{0.0, 0.0}, {0.0, -1.0}});
  return profile;
}

/// From the middle of the water's surface to its edge within the wall, and down to the middle of its bottom.
std::vector<ProfilePoint> waterProfile() {
  const dvec2 edge = besideWall(0.0, kLevel);
  const double taper = glm::radians(kTaperDeg);
  std::vector<ProfilePoint> profile{
      {{0.0, kLevel}, {0.0, 1.0}}, {edge, {0.0, 1.0}}, {edge, {std::cos(taper), -std::sin(taper)}}};
  addArc(profile, floorEdge(), kFloorRadius + kWall / 2, -kTaperDeg, -90.0, kQuarter);
  profile.push_back({{0.0, kBottom - kWall / 2}, {0.0, -1.0}});
  return profile;
}

}  // namespace

Mesh tumblerMesh() {
  Mesh mesh = revolvedMesh(glassProfile(), kTumblerSegments);
  fitToUnitSphere(mesh);
  return mesh;
}

Scene tumblerWaterScene() {
  Material glass = *materialNamed("glass");
  glass.priority = 1;
  Scene scene = meshScene(revolvedMesh(glassProfile(), kTumblerSegments), glass);
  scene.materials.push_back(*materialNamed("water"));
  scene.meshes.push_back(revolvedMesh(waterProfile(), kTumblerSegments));
  scene.meshes.back().edit().material = 1;
  scene.instances.push_back({.mesh = 1});
  fitToUnitSphere(scene);
  return scene;
}

}  // namespace mirrorball
