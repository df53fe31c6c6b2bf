#include "mirrorball/environment/projection.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "formula/formula.h"

namespace mirrorball {
namespace {

constexpr std::array kAll{Projection::equirect, Projection::sphere, Projection::angular, Projection::cube};

/// Directions spread evenly over the sphere (Fibonacci lattice).
std::vector<glm::vec3> manyDirections(int count = 2000) {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float angle = 2.39996323f * static_cast<float>(i);
    const float radius = std::sqrt(1.0f - y * y);
    directions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  return directions;
}

void expectPosition(Projection projection, glm::vec3 direction, int face, glm::vec2 uv) {
  const MapPosition place = positionOf(projection, direction);
  EXPECT_EQ(place.face, face) << nameOf(projection);
  EXPECT_NEAR(place.uv.x, uv.x, 1e-6f) << nameOf(projection);
  EXPECT_NEAR(place.uv.y, uv.y, 1e-6f) << nameOf(projection);
}

TEST(Projection, SingleImageMapsHavePlusZAtTheirCentre) {
  for (const Projection projection : {Projection::equirect, Projection::sphere, Projection::angular})
    expectPosition(projection, {0, 0, 1}, 0, {0.5f, 0.5f});
}

TEST(Projection, EquirectHasPlusXLeftOfTheCentreAndPlusYOnTop) {
  expectPosition(Projection::equirect, {1, 0, 0}, 0, {0.25f, 0.5f});
  expectPosition(Projection::equirect, {-1, 0, 0}, 0, {0.75f, 0.5f});
  EXPECT_NEAR(positionOf(Projection::equirect, {0, 1, 0}).uv.y, 0.0f, 1e-6f);
  EXPECT_NEAR(positionOf(Projection::equirect, {0, -1, 0}).uv.y, 1.0f, 1e-6f);
}

TEST(Projection, DiscsHavePlusXOnTheRight) {
  const float half_root = std::sqrt(0.5f);
  expectPosition(Projection::sphere, {1, 0, 0}, 0, {0.5f + half_root / 2.0f, 0.5f});
  expectPosition(Projection::sphere, {0, 1, 0}, 0, {0.5f, 0.5f - half_root / 2.0f});
  expectPosition(Projection::angular, {1, 0, 0}, 0, {0.75f, 0.5f});
  expectPosition(Projection::angular, {0, 1, 0}, 0, {0.5f, 0.25f});
}

TEST(Projection, CubeFollowsOpenGlsTable) {
  // A point near the s = 1, t = 0 corner of each face, from the table's (sc, tc).
  expectPosition(Projection::cube, glm::normalize(glm::vec3(1, 0.5f, -0.5f)), 0, {0.75f, 0.25f});
  expectPosition(Projection::cube, glm::normalize(glm::vec3(-1, 0.5f, 0.5f)), 1, {0.75f, 0.25f});
  expectPosition(Projection::cube, glm::normalize(glm::vec3(0.5f, 1, -0.5f)), 2, {0.75f, 0.25f});
  expectPosition(Projection::cube, glm::normalize(glm::vec3(0.5f, -1, 0.5f)), 3, {0.75f, 0.25f});
  expectPosition(Projection::cube, glm::normalize(glm::vec3(0.5f, 0.5f, 1)), 4, {0.75f, 0.25f});
  expectPosition(Projection::cube, glm::normalize(glm::vec3(-0.5f, 0.5f, -1)), 5, {0.75f, 0.25f});
}

// The third seed finds the left face and { 0.37, 0.21 }, the two other components over the longest, in the order (y, z).
// OpenGL's table orients the face: s from z, t from −y, so that the numbers are s = 1 − 0.21 and t = 0.37.
TEST(Projection, TheSeedsWorkedExample) {
  const glm::vec3 direction = glm::normalize(glm::vec3(-0.84f, 0.23f, 0.49f));
  const MapPosition place = positionOf(Projection::cube, direction);
  EXPECT_EQ(place.face, 1);
  EXPECT_NEAR(place.uv.x, 1.0f - 0.2083f, 1e-4f);
  EXPECT_NEAR(place.uv.y, 0.3631f, 1e-4f);
}

TEST(Projection, EveryDirectionComesBack) {
  for (const Projection projection : kAll)
    for (const glm::vec3 direction : manyDirections()) {
      const MapPosition place = positionOf(projection, direction);
      const glm::vec3 back = directionAt(projection, place);
      // The sphere map's rim packs the directions around −Z so densely that a float there resolves 1e-3.
      const bool is_rim = projection == Projection::sphere && direction.z < -0.99f;
      EXPECT_LT(glm::length(back - direction), is_rim ? 4e-3f : 4e-6f) << nameOf(projection) << " " << direction.z;
      EXPECT_TRUE(covers(projection, place.uv) || is_rim);
    }
}

TEST(Projection, SolidAnglesSumToTheSphere) {
  for (const Projection projection : kAll) {
    const glm::ivec2 size = imageSize(projection, 128);
    double sum = 0.0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) sum += double(texelSolidAngle(projection, size, {x, y}));
    sum *= faceCount(projection);
    // A disc's edge runs through texels, which count wholly or not at all.
    const bool is_disc = projection == Projection::sphere || projection == Projection::angular;
    EXPECT_NEAR(sum / (4.0 * 3.14159265358979), 1.0, is_disc ? 2e-3 : 1e-5) << nameOf(projection);
  }
}

TEST(Projection, EquivalentSizesComeBack) {
  for (const Projection from : kAll)
    for (const Projection to : kAll) EXPECT_EQ(equivalentSize(to, equivalentSize(from, 512, to), from), 512);
}

TEST(Projection, NamesAreParsed) {
  for (const Projection projection : kAll) EXPECT_EQ(*projectionNamed(nameOf(projection)), projection);
  EXPECT_FALSE(projectionNamed("cubic"));
}

}  // namespace
}  // namespace mirrorball
