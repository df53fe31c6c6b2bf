#include "mirrorball/environment/projection/projection.h"

#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/projection.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;
using testing::kEveryProjection;
using testing::manyDirections;

void expectPosition(Projection projection, glm::vec3 direction, int face, glm::vec2 uv) {
  const MapPosition place = positionOf(projection, glm::normalize(direction));
  EXPECT_EQ(place.face, face) << textOf(projection);
  EXPECT_NEAR(place.uv.x, uv.x, 1e-6f) << textOf(projection);
  EXPECT_NEAR(place.uv.y, uv.y, 1e-6f) << textOf(projection);
}

// What holds for all of them.
class EveryProjection : public ::testing::TestWithParam<Projection> {};

TEST_P(EveryProjection, HasPlusZAtTheCentreAndPlusYAbove) {
  const Projection projection = GetParam();
  const bool is_cube = faceCount(projection) == 6;
  expectPosition(projection, {0, 0, 1}, is_cube ? 4 : 0, {0.5f, 0.5f});
  EXPECT_LT(positionOf(projection, glm::normalize(glm::vec3(0, 0.5f, 1))).uv.y, 0.5f);
  EXPECT_GT(positionOf(projection, glm::normalize(glm::vec3(0, -0.5f, 1))).uv.y, 0.5f);
}

// A panorama is seen from inside; all others are pictures as in a mirror.
TEST_P(EveryProjection, HasPlusXOnTheSideThatIsStated) {
  const float u = positionOf(GetParam(), glm::normalize(glm::vec3(0.5f, 0, 1))).uv.x;
  if (GetParam() == Projection::equirect)
    EXPECT_LT(u, 0.5f);
  else
    EXPECT_GT(u, 0.5f);
}

// A position is rounded to 6e-8, half of which is lost, and a few roundings go before: the direction can come back to
// what 4e-7 of the image shows there. Beside a ball's rim, where the picture shows ever more of the sphere in ever less
// of itself, the last 2e-3 of the disc's radius have no such bound: there √6e-8 = 2.4e-4 of an angle of π is resolved.
TEST_P(EveryProjection, GivesEveryDirectionBack) {
  const Projection projection = GetParam();
  for (const glm::vec3 direction : manyDirections(20000)) {
    if (!covers(projection, direction)) continue;
    const MapPosition place = positionOf(projection, direction);
    const bool is_rim =
        hasDisc(projection) && projection != Projection::paraboloid && glm::length(place.uv - 0.5f) > 0.499f;
    const float bound = is_rim ? 4e-3f : 4e-7f / texelDensityAt(projection, 1, place).lesser + 5e-7f;
    EXPECT_LT(glm::length(directionAt(projection, place) - direction), bound) << direction.z << " at " << place.uv.x;
    EXPECT_TRUE(is_rim || covers(projection, place.uv) || glm::length(place.uv - 0.5f) < 0.5f + 1e-6f);
  }
}

TEST_P(EveryProjection, GivesEveryPositionBack) {
  const Projection projection = GetParam();
  for (int face = 0; face < faceCount(projection); ++face)
    for (int y = 0; y < 61; ++y)
      for (int x = 0; x < 61; ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / 61.0f;
        if (!covers(projection, uv)) continue;
        const glm::vec3 direction = directionAt(projection, {face, uv});
        EXPECT_NEAR(glm::length(direction), 1.0f, 5e-7f);
        EXPECT_TRUE(covers(projection, direction));
        const MapPosition place = positionOf(projection, direction);
        EXPECT_EQ(place.face, face);
        // A direction is rounded to 6e-8 too, which beside a pole or the middle of an angular map's rim is more of it.
        const float bound = 1e-6f + 3e-7f * texelDensityAt(projection, 1, place).greater;
        EXPECT_LT(glm::length(place.uv - uv), bound) << uv.x << ", " << uv.y;
      }
}

TEST_P(EveryProjection, CoversTheSolidAngleThatItSays) {
  int covered = 0;
  for (const glm::vec3 direction : manyDirections(100000)) covered += covers(GetParam(), direction);
  // Of evenly spread directions the edge of a cone takes about √100000 wrongly at the very most.
  EXPECT_NEAR(covered / 100000.0, double(coveredSolidAngle(GetParam())) / (4.0 * 3.14159265358979), 2e-4);
}

TEST_P(EveryProjection, HasANameThatIsRead) {
  EXPECT_EQ(*projectionNamed(textOf(GetParam())), GetParam());
  EXPECT_EQ(*projectionNamed(nameOf(GetParam())), GetParam().kind);
}

TEST_P(EveryProjection, HasSizesThatComeBack) {
  for (const Projection to : kEveryProjection)
    EXPECT_EQ(equivalentSize(to, equivalentSize(GetParam(), 512, to), GetParam()), 512);
}

INSTANTIATE_TEST_SUITE_P(Projection, EveryProjection, ::testing::ValuesIn(kEveryProjection),
                         [](const auto& test) { return testing::testName(test.param); });

TEST(Projection, StandsForItsKind) {
  constexpr Projection near = Projection::ballFrom(2.0f);
  static_assert(near == Projection::ball && near != Projection::sphere);
  static_assert(near != Projection(Projection::ball) && near == Projection::ballFrom(2.0f));
  static_assert(Projection() == Projection::equirect);
  int chosen = 0;
  switch (near) {
    case Projection::ball:
      chosen = 1;
      break;
    default:
      break;
  }
  EXPECT_EQ(chosen, 1);
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
  // A point near the s = 1, t = 0 corner of each face, from the table's (sc, tc). On the equi-angular cube ½ becomes
  // atan(½) · 4/π = 0.5903.
  for (const auto& [projection, s] : {std::pair{Projection::cube, 0.5f}, std::pair{Projection::eac, 0.5903345f}}) {
    const glm::vec2 uv(0.5f + s / 2.0f, 0.5f - s / 2.0f);
    expectPosition(projection, {1, 0.5f, -0.5f}, 0, uv);
    expectPosition(projection, {-1, 0.5f, 0.5f}, 1, uv);
    expectPosition(projection, {0.5f, 1, -0.5f}, 2, uv);
    expectPosition(projection, {0.5f, -1, 0.5f}, 3, uv);
    expectPosition(projection, {0.5f, 0.5f, 1}, 4, uv);
    expectPosition(projection, {-0.5f, 0.5f, -1}, 5, uv);
  }
}

// The third text of the lecture finds the left face and { 0.37, 0.21 }, the two other components over the longest, in
// the order (y, z). OpenGL's table orients the face: s from z, t from −y, so that the numbers are s = 1 − 0.21 and
// t = 0.37.
TEST(Projection, TheLecturesWorkedExample) {
  const glm::vec3 direction = glm::normalize(glm::vec3(-0.84f, 0.23f, 0.49f));
  const MapPosition place = positionOf(Projection::cube, direction);
  EXPECT_EQ(place.face, 1);
  EXPECT_NEAR(place.uv.x, 1.0f - 0.2083f, 1e-4f);
  EXPECT_NEAR(place.uv.y, 0.3631f, 1e-4f);
}

// A ray from the camera through a point of the picture, met with the ball and reflected there, all in double.
glm::dvec3 tracedAtBall(double distance, glm::dvec2 p) {
  const double rim_tangent = 1.0 / std::sqrt(distance * distance - 1.0);
  const glm::dvec3 ray = glm::normalize(glm::dvec3(p * rim_tangent, -1.0));
  const glm::dvec3 camera(0.0, 0.0, distance);
  const double nearest = -glm::dot(camera, ray);
  const double inside = 1.0 - (distance * distance - nearest * nearest);
  const glm::dvec3 normal = camera + ray * (nearest - std::sqrt(std::max(inside, 0.0)));
  return glm::reflect(ray, normal);
}

TEST(Projection, ABallShowsWhatARayTracedFromTheCameraSees) {
  for (const float distance : {1.01f, 1.2f, 2.0f, 7.0f, 20.0f, 1000.0f})
    for (int i = 0; i < 1000; ++i) {
      const double radius = std::sqrt(i / 1010.0);
      const glm::dvec2 p(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i));
      const glm::vec2 uv(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y);
      const glm::vec3 seen = directionAt(Projection::ballFrom(distance), {0, uv});
      // The rounding of uv, 6e-8, where the direction changes by up to 2 / √(1 − ρ²) = 20 for each ρ; twice the hundred
      // times steeper middle where the camera almost touches the ball.
      EXPECT_LT(glm::length(glm::dvec3(seen) - tracedAtBall(double(distance), p)), distance < 1.1f ? 5e-5 : 1e-5)
          << distance << " at " << radius;
    }
}

TEST(Projection, ABallFromFarAwayIsTheSphereMap) {
  for (const float distance : {1e7f, std::numeric_limits<float>::infinity()})
    for (const glm::vec3 direction : manyDirections()) {
      const glm::vec2 ball = positionOf(Projection::ballFrom(distance), direction).uv;
      EXPECT_LT(glm::length(ball - positionOf(Projection::sphere, direction).uv), 5e-7f);
    }
}

TEST(Projection, ABallHidesTheConeBehindIt) {
  constexpr Projection ball = Projection::ballFrom(2.0f);  // the cone's half angle is asin ½ = 30°
  const auto from_behind = [](float degrees) {
    return glm::vec3(std::sin(glm::radians(degrees)), 0.0f, -std::cos(glm::radians(degrees)));
  };
  EXPECT_FALSE(covers(ball, from_behind(0.0f)));
  EXPECT_FALSE(covers(ball, from_behind(29.9f)));
  EXPECT_TRUE(covers(ball, from_behind(30.1f)));
  expectPosition(ball, from_behind(20.0f), 0, {1.0f, 0.5f});
  EXPECT_NEAR(coveredSolidAngle(ball), 2.0f * 3.14159265f * (1.0f + std::cos(glm::radians(30.0f))), 1e-5f);
}

TEST(Projection, TheHalvesOfAParaboloidMapShareTheirRim) {
  for (int i = 0; i < 100; ++i) {
    const float angle = 0.0628f * static_cast<float>(i);
    const glm::vec2 uv(0.5f + 0.5f * std::cos(angle), 0.5f - 0.5f * std::sin(angle));
    const glm::vec3 front = directionAt(Projection::paraboloid, {0, uv});
    EXPECT_LT(glm::length(front - directionAt(Projection::paraboloid, {1, uv})), 1e-6f);
    EXPECT_LT(glm::length(front - glm::vec3(std::cos(angle), std::sin(angle), 0.0f)), 1e-6f);
  }
  expectPosition(Projection::paraboloid, {0, 0, -1}, 1, {0.5f, 0.5f});
  expectPosition(Projection::paraboloid, {0.6f, 0, -0.8f}, 1, {0.5f + 0.5f / 3.0f, 0.5f});
  expectPosition(Projection::paraboloid, {0, 0.6f, -0.8f}, 1, {0.5f, 0.5f - 0.5f / 3.0f});
}

// The edges of an unfolded octahedron are sewn to themselves, turned about their middles.
TEST(Projection, OctahedralEdgesMeet) {
  for (const Projection projection : {Projection::octahedral, Projection::equal_area})
    for (int i = 0; i <= 50; ++i) {
      const float along = static_cast<float>(i) / 50.0f;
      for (const float side : {0.0f, 1.0f}) {
        const auto at = [&](glm::vec2 uv) { return directionAt(projection, {0, uv}); };
        EXPECT_LT(glm::length(at({side, along}) - at({side, 1.0f - along})), 1e-6f);
        EXPECT_LT(glm::length(at({along, side}) - at({1.0f - along, side})), 1e-6f);
      }
    }
}

// The worked values of the papers' formulas.
TEST(Projection, OctahedralValues) {
  expectPosition(Projection::octahedral, {1, 0, 0}, 0, {1.0f, 0.5f});
  expectPosition(Projection::octahedral, {0, 1, 0}, 0, {0.5f, 0.0f});
  expectPosition(Projection::octahedral, {1, 1, 1}, 0, {2.0f / 3.0f, 1.0f / 3.0f});
  expectPosition(Projection::octahedral, {1, 1, -1}, 0, {5.0f / 6.0f, 1.0f / 6.0f});
  expectPosition(Projection::octahedral, {-1, 0.5f, -0.5f}, 0, {0.5f - 0.75f / 2.0f, 0.25f});
  EXPECT_NEAR(directionAt(Projection::octahedral, {0, {1.0f, 1.0f}}).z, -1.0f, 1e-6f);
}

TEST(Projection, HemioctahedralValues) {
  expectPosition(Projection::hemioctahedral, {1, 0, 0}, 0, {1.0f, 1.0f});
  expectPosition(Projection::hemioctahedral, {0, 1, 0}, 0, {1.0f, 0.0f});
  expectPosition(Projection::hemioctahedral, {1, 1, 0}, 0, {1.0f, 0.5f});
  expectPosition(Projection::hemioctahedral, {0, 0.5f, 0.5f}, 0, {0.75f, 0.25f});
  EXPECT_FALSE(covers(Projection::hemioctahedral, glm::vec3(0, 0, -1)));
}

// pbrt's (x, y, z) is our (x, −y, z). On its square +x is the right edge's middle and z = ½ lies at r = √½.
TEST(Projection, EqualAreaValuesArePbrts) {
  expectPosition(Projection::equal_area, {1, 0, 0}, 0, {1.0f, 0.5f});
  expectPosition(Projection::equal_area, {0, -1, 0}, 0, {0.5f, 1.0f});
  expectPosition(Projection::equal_area, {1, 1, 0}, 0, {0.75f, 0.25f});
  const float half_root = std::sqrt(0.5f);
  expectPosition(Projection::equal_area, {std::sqrt(0.75f), 0, 0.5f}, 0, {0.5f + half_root / 2.0f, 0.5f});
  // Longitude 30° is a third of the way along the diamond; folded over for z < 0.
  const glm::vec2 on_square(2.0f / 3.0f * half_root, half_root / 3.0f);
  const float sine = std::sqrt(0.75f);
  const glm::vec3 below(sine * std::sqrt(0.75f), sine * 0.5f, -0.5f);
  expectPosition(Projection::equal_area, below, 0, {1.0f - on_square.y / 2.0f, on_square.x / 2.0f});
}

TEST(Projection, NamesThatAreNone) {
  EXPECT_THAT(projectionNamed("cubic").error().message, HasSubstr("did you mean 'cube'"));
  EXPECT_EQ(projectionNamed("ball:distance=3.5")->ball_distance, 3.5f);
  EXPECT_THAT(projectionNamed("ball:distance=1").error().message, HasSubstr("at least 1.01"));
  EXPECT_THAT(projectionNamed("ball:distance=far").error().message, HasSubstr("'far'"));
  EXPECT_THAT(projectionNamed("cube:distance=3").error().message, HasSubstr("only a ball takes a parameter"));
  EXPECT_THAT(projectionNamed("ball:size=3").error().message, HasSubstr("ball:distance=20"));
}

}  // namespace
}  // namespace mirrorball
