#include "mirrorball/height_field/slopes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/relief.h"
#include "mirrorball/height_field/height_field_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAreArray;
using testing::heightAt;
using testing::kAllDifferences;
using testing::kAllEdges;
using testing::randomHeights;

glm::vec3 at(const Image& map, int x, int y) { return rgbAt(map, x, y); }

/// The slope by the formula, texel by texel.
glm::vec2 slopeByFormula(const Image& heights, int x, int y, const HeightFieldSettings& settings) {
  const auto row = [&](int offset) {
    return glm::vec3(heightAt(heights, x - 1, y + offset, settings.edges),
                     heightAt(heights, x, y + offset, settings.edges),
                     heightAt(heights, x + 1, y + offset, settings.edges));
  };
  return formula::slopeOfDifference(
      formula::heightDifference(static_cast<int>(settings.difference), row(-1), row(0), row(1)),
      settings.scale * static_cast<float>(heights.width()));
}

TEST(Slopes, VectorsAndFormulaAgreeForEveryDifferenceAndSize) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 5}, {5, 1}, {2, 3}, {17, 4}, {67, 9}})
    for (const HeightDifference difference : kAllDifferences)
      for (const MapEdges edges : kAllEdges) {
        const HeightFieldSettings settings{difference, edges, 0.3f};
        const Image heights = randomHeights(size.x, size.y);
        const Image derivatives = derivativesFromHeights(heights, settings).value();
        const Image normals = normalsFromHeights(heights, settings).value();
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x) {
            const glm::vec2 slope = slopeByFormula(heights, x, y, settings);
            const glm::vec3 normal = formula::normalFromSlope(slope);
            ASSERT_LE(glm::distance(at(derivatives, x, y), glm::vec3(slope.x, 0.0f, slope.y)),
                      1e-5f * (1.0f + glm::length(slope)))
                << x << ", " << y << " of " << size.x << "x" << size.y;
            ASSERT_LE(glm::distance(at(normals, x, y), normal), 1e-6f) << x << ", " << y;
          }
      }
}

// Ground that rises to the right leans to the left; ground that rises down the image leans up it.
TEST(Slopes, NormalsLeanAwayFromWhatRises) {
  Image ramp(4, 4, 1);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) ramp.texel(x, y)[0] = 0.25f * float(x) + 0.125f * float(y);
  const Image normals = normalsFromHeights(ramp, {.edges = MapEdges::clamped}).value();
  const glm::vec3 normal = at(normals, 1, 1);
  EXPECT_NEAR(normal.x, -1.0f / 1.5f, 1e-6f);  // (−1, ½, 1) / 1.5
  EXPECT_NEAR(normal.y, 0.5f / 1.5f, 1e-6f);
  EXPECT_NEAR(normal.z, 1.0f / 1.5f, 1e-6f);
  const Image derivatives = derivativesFromHeights(ramp, {.edges = MapEdges::clamped}).value();
  EXPECT_EQ(at(derivatives, 1, 1), glm::vec3(1.0f, 0.0f, 0.5f));
}

// The lecture's D = [d_ij] → (d_ij − d_(i−1)j, 0, d_ij − d_i(j−1)).
TEST(Slopes, BackwardDifferencesOfTheScaleOneOverWidthAreTheLectures) {
  const Image heights = randomHeights(16, 8);
  const Image map =
      derivativesFromHeights(heights, {.difference = HeightDifference::backward, .scale = 1.0f / 16.0f}).value();
  const auto d = [&](int i, int j) { return heights.texel(i, j)[0]; };
  EXPECT_EQ(at(map, 5, 3), glm::vec3(d(5, 3) - d(4, 3), 0.0f, d(5, 3) - d(5, 2)));
  EXPECT_EQ(at(map, 0, 0), glm::vec3(d(0, 0) - d(15, 0), 0.0f, d(0, 0) - d(0, 7)));
}

TEST(Slopes, AWaveHasItsOwnSlope) {
  const int size = 256;
  const Image heights = testing::hills(size, size, 3);
  const Image map = derivativesFromHeights(heights).value();
  const double step = 1e-4;
  for (int i = 0; i < size; i += 37) {
    const double u = (i + 0.5) / size;
    const double v = 0.5 / size;
    const auto hill = [](double s, double t) {
      constexpr double kTurn = 2.0 * std::numbers::pi;
      return 0.125 * (std::sin(kTurn * (s + 3.0 * t) + 1.0) + std::sin(kTurn * (3.0 * s - 2.0 * t)) +
                      std::cos(kTurn * (3.0 * t - s)) + std::sin(kTurn * 2.0 * s + 0.5));
    };
    EXPECT_NEAR(at(map, i, 0).x, (hill(u + step, v) - hill(u - step, v)) / (2.0 * step), 3e-3);
    EXPECT_NEAR(at(map, i, 0).z, (hill(u, v + step) - hill(u, v - step)) / (2.0 * step), 3e-3);
  }
}

TEST(Slopes, ATiledMapHasNoSeam) {
  const Image heights = randomHeights(33, 20);
  for (const HeightDifference difference : kAllDifferences) {
    const HeightFieldSettings settings{.difference = difference};
    const Image moved = normalsFromHeights(testing::rolled(heights, 13, 7), settings).value();
    EXPECT_THAT(moved.samples(),
                ElementsAreArray(testing::rolled(normalsFromHeights(heights, settings).value(), 13, 7).samples()));
  }
}

TEST(Slopes, FlatGroundPointsUpAndSoDoesAScaleOfZero) {
  for (const Image& heights : {Image(9, 3, 1, 0.7f), Image(1, 1, 1, 5.0f)})
    EXPECT_EQ(at(normalsFromHeights(heights).value(), 0, 0), glm::vec3(0.0f, 0.0f, 1.0f));
  const Image normals = normalsFromHeights(randomHeights(40, 3), {.scale = 0.0f}).value();
  for (int x = 0; x < 40; ++x) EXPECT_EQ(at(normals, x, 1), glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST(Slopes, HugeHeightsStillHaveUnitNormals) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  Image heights(40, 4, 1, -kHuge);
  for (int x = 0; x < 40; x += 3) heights.texel(x, 1)[0] = kHuge;
  for (const HeightDifference difference : kAllDifferences)
    for (const float scale : {0.0f, 1.0f, 1e30f}) {
      const Image normals = normalsFromHeights(heights, {.difference = difference, .scale = scale}).value();
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 40; ++x) ASSERT_NEAR(glm::length(at(normals, x, y)), 1.0f, 1e-5f) << x << ", " << y;
    }
}

TEST(Slopes, NaNIsNamed) {
  Image heights(8, 4, 1);
  heights.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  heights.texel(0, 2)[0] = std::numeric_limits<float>::infinity();
  for (const auto& result : {normalsFromHeights(heights), derivativesFromHeights(heights)}) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::non_finite);
    EXPECT_EQ(result.error().message, "2 texels are NaN or infinite, the first at (3, 1)");
  }
}

// Wherever in a row, which is looked at in vectors.
TEST(Slopes, NaNIsFoundInEveryColumn) {
  for (int x = 0; x < 45; ++x) {
    Image heights(45, 2, 1);
    heights.texel(x, 1)[0] = -std::numeric_limits<float>::infinity();
    const auto result = normalsFromHeights(heights);
    ASSERT_FALSE(result) << x;
    EXPECT_EQ(result.error().message, "1 texel is NaN or infinite, the first at (" + std::to_string(x) + ", 1)");
  }
}

TEST(Slopes, StopsWhenTold) {
  const auto result = normalsFromHeights(Image(64, 64, 1), {}, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::interrupted);
}

TEST(Slopes, ProgressEndsAtItsTotal) {
  std::size_t last = 0;
  const auto progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 1000u);
    last = done;
    return true;
  };
  ASSERT_TRUE(normalsFromHeights(Image(4, 1000, 1), {}, progress));
  EXPECT_EQ(last, 1000u);
}

TEST(SlopeFormulas, ANormalGivesItsSlopeBack) {
  for (const glm::vec2 slope : {glm::vec2(0.0f), {1.0f, -2.0f}, {-30.0f, 0.01f}}) {
    const glm::vec2 back = formula::slopeFromNormal(formula::normalFromSlope(slope));
    EXPECT_LE(glm::distance(back, slope), 1e-5f * (1.0f + glm::length(slope)));
  }
}

}  // namespace
}  // namespace mirrorball
