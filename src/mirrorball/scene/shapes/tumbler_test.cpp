#include "mirrorball/scene/shapes/tumbler.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mirrorball/scene/mesh_testing.h"
#include "mirrorball/scene/shapes/revolution.h"

namespace mirrorball {
namespace {

using testing::expectEdgesPaired;
using testing::expectSound;
using testing::expectTangentsAlongU;
using testing::expectUnitBounds;
using testing::signedVolume;

constexpr double kTaper = 3.0 * std::numbers::pi / 180.0;

/// ∫ r² dy along an arc of a section, with r = x + ρ cos θ and dy = ρ cos θ dθ.
double ofArc(double x, double radius, double first, double last) {
  const auto integral = [&](double t) {
    const double sine = std::sin(t);
    return x * x * radius * sine + 2.0 * x * radius * radius * (t / 2.0 + std::sin(2.0 * t) / 4.0) +
           radius * radius * radius * (sine - sine * sine * sine / 3.0);
  };
  return integral(last) - integral(first);
}

/// The same along a line: a frustum's.
double ofLine(glm::dvec2 a, glm::dvec2 b) { return (b.y - a.y) * (a.x * a.x + a.x * b.x + b.x * b.x) / 3.0; }

glm::dvec2 onArc(glm::dvec2 center, double radius, double angle) {
  return center + radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

// Pappus' way around the section, in mm: 110 high, 80 wide at the rim, walls of 3, a bottom of 10.
TEST(TumblerMesh, IsAClosedGlassWithItsVolume) {
  const Mesh mesh = tumblerMesh();
  expectUnitBounds(meshScene(mesh));
  expectSound(mesh, 0.999f);
  expectEdgesPaired(mesh);

  const double pi = std::numbers::pi;
  const glm::dvec2 rim(38.5, 108.5);
  // The wall's middle line leans by the taper: at a height it is this far from the axis, and `outwards` is at right
  // angles to it.
  const auto beside = [&](double outwards, double height) {
    return rim.x + outwards / std::cos(kTaper) - (rim.y - height) * std::tan(kTaper);
  };
  const glm::dvec2 floor(beside(-1.5 - 6.0, 16.0), 16.0);
  const glm::dvec2 foot(beside(1.5 - 4.0, 4.0), 4.0);
  const double around = ofLine(onArc(floor, 6.0, -kTaper), onArc(rim, 1.5, pi - kTaper)) +
                        ofArc(floor.x, 6.0, -pi / 2, -kTaper) + ofArc(rim.x, 1.5, pi - kTaper, -kTaper) +
                        ofLine(onArc(rim, 1.5, -kTaper), onArc(foot, 4.0, -kTaper)) +
                        ofArc(foot.x, 4.0, -kTaper, -pi / 2);
  const double mm3 = pi * std::abs(around);
  EXPECT_GT(mm3, 90e3);  // about 0.1 litres of glass: it weighs a quarter of a kilogram

  float low = 1.0f, high = -1.0f;
  for (const Vertex& vertex : mesh.vertices) {
    low = std::min(low, vertex.position.y);
    high = std::max(high, vertex.position.y);
  }
  const double scale = double(high - low) / 110.0;
  EXPECT_NEAR(signedVolume(mesh), mm3 * scale * scale * scale, 1e-3 * mm3 * scale * scale * scale);
}

TEST(TumblerWaterScene, IsWaterThatReachesIntoItsGlass) {
  const Scene scene = tumblerWaterScene();
  expectUnitBounds(scene);
  ASSERT_EQ(scene.meshes.size(), 2u);
  for (const Mesh& mesh : scene.meshes) {
    expectSound(mesh, 0.999f);
    expectEdgesPaired(mesh);
    EXPECT_GT(signedVolume(mesh), 0.0);
  }
  EXPECT_GT(materialOf(scene, 0).priority, materialOf(scene, 1).priority) << "the glass fills its wall";
  // At the height of the water's edge, the glass is from 1.5 mm inside of it to 1.5 mm outside.
  const Mesh& water = scene.meshes[1];
  double edge = 0.0;
  for (const Vertex& vertex : water.vertices)
    if (vertex.normal.y == 1.0f)
      edge = std::max(edge, std::hypot(double(vertex.position.x), double(vertex.position.z)));
  EXPECT_NEAR(edge, 38.5 - (108.5 - 66.0) * std::tan(kTaper), 1e-4);
}

TEST(RevolvedMesh, OfAHalfCircleIsABall) {
  std::vector<ProfilePoint> profile;
  addArc(profile, glm::dvec2(0.0), 1.0, 90.0, -90.0, 64);
  const Mesh ball = revolvedMesh(profile, 128);
  expectSound(ball, 0.99f);
  expectTangentsAlongU(ball, 0.99f);
  expectEdgesPaired(ball);
  EXPECT_NEAR(signedVolume(ball), 4.0 / 3.0 * std::numbers::pi, 5e-3);
}

TEST(RevolvedMesh, HasSharpEdgesWhereNormalsChangeAtAPlace) {
  const std::vector<ProfilePoint> cylinder{{{0, 1}, {0, 1}},  {{1, 1}, {0, 1}},   {{1, 1}, {1, 0}},
                                           {{1, -1}, {1, 0}}, {{1, -1}, {0, -1}}, {{0, -1}, {0, -1}}};
  const Mesh mesh = revolvedMesh(cylinder, 3);
  expectEdgesPaired(mesh);
  expectSound(revolvedMesh(cylinder, 64), 0.998f);
  EXPECT_NEAR(signedVolume(mesh), 2.0 * 3.0 * std::numbers::sqrt3 / 4.0, 1e-6) << "of three sides it is a prism";
}

}  // namespace
}  // namespace mirrorball
