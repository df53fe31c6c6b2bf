#include "mirrorball/environment/projection/texel_geometry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

using testing::kEveryProjection;

constexpr double kPi = 3.14159265358979;

class TexelGeometry : public ::testing::TestWithParam<Projection> {
 protected:
  /// Whether all of a texel lies in the picture, not only its centre.
  static bool isWhole(glm::ivec2 size, glm::ivec2 texel) {
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
      if (!covers(GetParam(), glm::vec2(texel + corner) / glm::vec2(size))) return false;
    return true;
  }

  /// Calls visit(face, texel) for all texels that lie wholly in a picture.
  template <typename Visit>
  static void forEachWholeTexel(glm::ivec2 size, Visit&& visit) {
    for (int face = 0; face < faceCount(GetParam()); ++face)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
          if (isWhole(size, {x, y})) visit(face, glm::ivec2(x, y));
  }

  static double sumOfSolidAngles(int side) {
    const glm::ivec2 size = imageSize(GetParam(), side);
    double sum = 0.0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) sum += double(texelSolidAngle(GetParam(), size, {x, y}));
    return sum * faceCount(GetParam());
  }
};

TEST_P(TexelGeometry, SolidAnglesSumToWhatIsCovered) {
  // A disc's edge runs through texels, which count wholly or not at all: their number is right to about √side of the
  // side²·π/4. Those of a ball seen from close by have several times the others' solid angle.
  const bool is_near = GetParam() == Projection::ballFrom(1.5f);
  const double tolerance = is_near ? 5e-3 : (hasDisc(GetParam()) ? 1e-3 : 1e-6);
  EXPECT_NEAR(sumOfSolidAngles(256) / double(coveredSolidAngle(GetParam())), 1.0, tolerance);
  if (!hasDisc(GetParam())) {
    EXPECT_NEAR(sumOfSolidAngles(33) / double(coveredSolidAngle(GetParam())), 1.0, 1e-6);
  }
}

/// The area on the sphere of a patch of the image: the flat triangles between directions on a lattice in it.
double patchArea(Projection projection, int face, glm::ivec2 size, glm::ivec2 texel) {
  constexpr int kSteps = 16;
  const auto at = [&](int i, int j) {
    const glm::dvec2 uv = (glm::dvec2(texel) + glm::dvec2(i, j) / double(kSteps)) / glm::dvec2(size);
    return glm::dvec3(directionAt(projection, {face, glm::vec2(uv)}));
  };
  double area = 0.0;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i)
      area += glm::length(glm::cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j))) / 2.0;
  return area;
}

// 16 × 16 quadrangles of about 6e-3 rad each, whose corners are known to 6e-8, hence to 1e-5, and whose flatness costs
// the same. Next to a ball's rim, and around the poles of the equal-area map, the patches are so bent that they cost
// more.
TEST_P(TexelGeometry, SolidAngleIsTheAreaOnTheSphere) {
  const glm::ivec2 size = imageSize(GetParam(), 32);
  forEachWholeTexel(size, [&](int face, glm::ivec2 texel) {
    const glm::vec2 center = (glm::vec2(texel) + 0.5f) / glm::vec2(size);
    const bool is_bent =
        (hasDisc(GetParam()) && glm::length(center - 0.5f) > 0.46f) || GetParam() == Projection::equal_area;
    const double area = patchArea(GetParam(), face, size, texel);
    EXPECT_NEAR(double(texelSolidAngle(GetParam(), size, texel)) / area, 1.0, is_bent ? 3e-3 : 1e-4)
        << "face " << face << " texel " << texel.x << ", " << texel.y;
  });
}

// Also where a fold runs through a texel in any way.
TEST_P(TexelGeometry, SolidAnglesAdd) {
  const glm::ivec2 size = imageSize(GetParam(), 9);
  forEachWholeTexel(size, [&](int, glm::ivec2 texel) {
    double sum = 0.0;
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 5; ++x) sum += double(texelSolidAngle(GetParam(), size * 5, texel * 5 + glm::ivec2(x, y)));
    // Single precision of the terms; three points of Gauss' rule leave 1e-4 of a texel that is a ninth of a disc.
    EXPECT_NEAR(double(texelSolidAngle(GetParam(), size, texel)) / sum, 1.0, hasDisc(GetParam()) ? 5e-4 : 1e-6);
  });
}

TEST_P(TexelGeometry, DensityIsTheReciprocalOfTheSolidAngle) {
  constexpr int kSide = 256;
  const glm::ivec2 size = imageSize(GetParam(), kSide);
  const float margin = 3.0f / 512.0f;  // nearer to an edge the density is that at 1/512 from it
  forEachWholeTexel(size, [&](int face, glm::ivec2 texel) {
    if (texel.x % 5 != 0 || texel.y % 5 != 0) return;
    const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / glm::vec2(size);
    if (std::min({uv.x, uv.y, 1.0f - uv.x, 1.0f - uv.y}) < margin) return;
    if (hasDisc(GetParam()) && glm::length(uv - 0.5f) > 0.48f) return;
    const TexelDensity density = texelDensityAt(GetParam(), kSide, {face, uv});
    EXPECT_GE(density.greater, density.lesser);
    const float solid_angle = texelSolidAngle(GetParam(), size, texel);
    // A fold through a texel is averaged over another neighbourhood than the texel's own.
    EXPECT_NEAR(density.greater * density.lesser * solid_angle, 1.0f, 0.02f) << face << " at " << uv.x << ", " << uv.y;
  });
}

TEST_P(TexelGeometry, DensityInTheMiddleIsTheOneNumber) {
  const TexelDensity middle = texelDensityAt(GetParam(), 64, {faceCount(GetParam()) == 6 ? 4 : 0, {0.5f, 0.5f}});
  const float mean = std::sqrt(middle.greater * middle.lesser);
  // In the middle of an equal-area map four folds meet; its one number is the mean of the sphere, of 4π / 64² a texel.
  const float expected = GetParam() == Projection::equal_area ? 64.0f / std::sqrt(4.0f * float(kPi)) : mean;
  EXPECT_NEAR(texelDensity(GetParam(), 64) / expected, 1.0f, 2e-3f);
}

INSTANTIATE_TEST_SUITE_P(Projection, TexelGeometry, ::testing::ValuesIn(kEveryProjection),
                         [](const auto& test) { return testing::testName(test.param); });

TEST(TexelDensityAt, FollowsTheParallelsOfAPanorama) {
  for (const float v : {0.5f, 0.3f, 0.1f}) {
    const TexelDensity density = texelDensityAt(Projection::equirect, 100, {0, {0.3f, v}});
    EXPECT_NEAR(density.lesser, 100.0f / float(kPi), 1e-2f);
    EXPECT_NEAR(density.greater, 100.0f / float(kPi) / std::sin(v * float(kPi)), 0.1f);
  }
}

// θ = 2πr: 100 / 2π texels a radian along the radius, 100 r / sin θ across.
TEST(TexelDensityAt, FollowsTheRadiusOfALightProbe) {
  for (const float r : {0.1f, 0.25f, 0.4f}) {
    const TexelDensity density = texelDensityAt(Projection::angular, 100, {0, {0.5f + r, 0.5f}});
    EXPECT_NEAR(density.lesser, 100.0f / float(2.0 * kPi), 1e-2f);
    EXPECT_NEAR(density.greater, 100.0f * r / std::sin(r * float(2.0 * kPi)), 1e-1f);
  }
}

TEST(TexelSolidAngle, IsTheSameForEveryTexelOfAnEqualAreaMap) {
  for (const glm::ivec2 texel : {glm::ivec2(0, 0), glm::ivec2(31, 17), glm::ivec2(16, 16), glm::ivec2(5, 60)})
    EXPECT_NEAR(texelSolidAngle(Projection::equal_area, glm::ivec2(64), texel), float(4.0 * kPi / 4096.0), 1e-9f);
}

// The corner of an 8192² face has (1 + 1 + 1)^(−3/2) of the centre's density: a float difference of corners loses it.
TEST(TexelSolidAngle, KeepsItsDigitsInLargeImages) {
  const double centre = 4.0 / (8192.0 * 8192.0);
  EXPECT_NEAR(double(texelSolidAngle(Projection::cube, glm::ivec2(8192), {4096, 4096})) / centre, 1.0, 1e-5);
  EXPECT_NEAR(double(texelSolidAngle(Projection::cube, glm::ivec2(8192), {0, 0})) / centre, std::pow(3.0, -1.5), 2e-4);
}

}  // namespace
}  // namespace mirrorball
