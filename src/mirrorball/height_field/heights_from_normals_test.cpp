#include "mirrorball/height_field/heights_from_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/relief.h"
#include "mirrorball/height_field/height_field_testing.h"
#include "mirrorball/height_field/map_transform.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

using testing::hills;
using testing::kAllDifferences;
using testing::kAllEdges;
using testing::randomHeights;

/// The greatest difference of two maps, whose means do not count.
double differenceBesideMean(const Image& a, const Image& b) {
  double mean = 0.0;
  for (std::size_t i = 0; i < a.samples().size(); ++i) mean += double(a.samples()[i]) - double(b.samples()[i]);
  mean /= static_cast<double>(a.samples().size());
  double max = 0.0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    max = std::max(max, std::abs(double(a.samples()[i]) - double(b.samples()[i]) - mean));
  return max;
}

TEST(MapTransform, BothWaysTogetherChangeNothing) {
  for (const MapEdges edges : kAllEdges)
    for (const int length : {1, 2, 3, 8, 15, 17, 64, 127}) {
      const Image rows = randomHeights(length, 2);
      Image transformed = rows;
      const MapTransform transform(length, edges);
      MapTransform::Work work = transform.makeWork();
      transform.forward(transformed.row(0).data(), transformed.row(1).data(), work);
      transform.inverse(transformed.row(0).data(), transformed.row(1).data(), work);
      for (std::size_t i = 0; i < rows.samples().size(); ++i)
        ASSERT_NEAR(transformed.samples()[i], rows.samples()[i], 2e-6f) << length;
    }
}

// A cosine about both ends, and waves that go round.
TEST(MapTransform, ItsBasisFunctionsHaveOneNumber) {
  for (const MapEdges edges : kAllEdges) {
    const int length = 12;
    const MapTransform transform(length, edges);
    MapTransform::Work work = transform.makeWork();
    for (int k = 0; k < length; ++k) {
      Image rows(length, 2, 1);
      for (int n = 0; n < length; ++n) {
        const double angle = transform.angle(k) * (edges == MapEdges::clamped ? n + 0.5 : n);
        rows.texel(n, 0)[0] = static_cast<float>(std::cos(angle) + (edges == MapEdges::tiled ? std::sin(angle) : 0.0));
      }
      transform.forward(rows.row(0).data(), rows.row(1).data(), work);
      EXPECT_GT(rows.texel(k, 0)[0], 1.0f);
      rows.texel(k, 0)[0] = 0.0f;
      for (int other = 0; other < length; ++other)
        EXPECT_NEAR(rows.texel(other, 0)[0], 0.0f, 1e-5f) << k << ", " << other;
      EXPECT_NEAR(rows.texel(k, 1)[0], 0.0f, 1e-5f);
    }
  }
}

// Hills have nothing that a difference does not see.
TEST(HeightsFromNormals, GivesHeightsBackForEveryDifferenceAndSize) {
  for (const glm::ivec2 size : {glm::ivec2(64, 64), {96, 40}, {61, 34}, {33, 128}})
    for (const HeightDifference difference : kAllDifferences)
      for (const MapEdges edges : kAllEdges) {
        const HeightFieldSettings settings{difference, edges, 0.2f};
        const Image heights = hills(size.x, size.y, 3);
        const Image back = heightsFromNormals(normalsFromHeights(heights, settings).value(), settings).value();
        // Sobel's differences see next to nothing of waves of nearly two texels, where rounding is then seen instead.
        EXPECT_LE(differenceBesideMean(back, heights), difference == HeightDifference::sobel ? 2e-4 : 2e-5)
            << size.x << "x" << size.y << ", difference " << int(difference) << ", edges " << int(edges);
      }
}

// Of noise too, as long as each texel is compared with the next.
TEST(HeightsFromNormals, GivesNoiseBackWhereEveryWaveIsSeen) {
  for (const MapEdges edges : kAllEdges)
    for (const HeightDifference difference : {HeightDifference::backward, HeightDifference::forward}) {
      const HeightFieldSettings settings{difference, edges, 0.01f};
      const Image heights = randomHeights(45, 50);
      const Image back = heightsFromNormals(normalsFromHeights(heights, settings).value(), settings).value();
      EXPECT_LE(differenceBesideMean(back, heights), 2e-5);
    }
}

/// Σ (D_u h − p)² + (D_v h − q)², in slopes.
double misfit(const Image& heights, const Image& normals, const HeightFieldSettings& settings) {
  const Image slopes = derivativesFromHeights(heights, settings).value();
  double sum = 0.0;
  for (int y = 0; y < heights.height(); ++y)
    for (int x = 0; x < heights.width(); ++x) {
      const glm::vec2 wanted = formula::slopeFromNormal(rgbAt(normals, x, y));
      const glm::vec3 found = rgbAt(slopes, x, y);
      sum += std::pow(double(found.x - wanted.x), 2) + std::pow(double(found.z - wanted.y), 2);
    }
  return sum;
}

// Normals that no surface has: whichever way the heights are changed, they fit less well.
TEST(HeightsFromNormals, NoOtherHeightsFitBetter) {
  for (const HeightDifference difference : kAllDifferences)
    for (const MapEdges edges : kAllEdges) {
      const HeightFieldSettings settings{difference, edges, 0.5f};
      Image normals(12, 9, 3, 1.0f);
      const Image noise = randomHeights(24, 9, 7);
      for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
          normals.texel(x, y)[0] = noise.texel(2 * x, y)[0] - 0.5f;
          normals.texel(x, y)[1] = noise.texel(2 * x + 1, y)[0] - 0.3f;
        }
      const Image heights = heightsFromNormals(normals, settings).value();
      const double best = misfit(heights, normals, settings);
      for (unsigned seed = 0; seed < 20; ++seed) {
        Image other = heights;
        const Image change = randomHeights(12, 9, seed);
        for (std::size_t i = 0; i < other.samples().size(); ++i)
          other.samples()[i] += 0.01f * (change.samples()[i] - 0.5f);
        EXPECT_GT(misfit(other, normals, settings), best) << int(difference) << ", " << int(edges);
      }
    }
}

TEST(HeightsFromNormals, ATiledMapHasNoSeam) {
  const HeightFieldSettings settings{.scale = 0.1f};
  const Image normals = normalsFromHeights(randomHeights(30, 18), settings).value();
  const Image moved = heightsFromNormals(testing::rolled(normals, 11, 5), settings).value();
  EXPECT_LE(differenceBesideMean(moved, testing::rolled(heightsFromNormals(normals, settings).value(), 11, 5)), 1e-5);
}

TEST(HeightsFromNormals, TakesTheSmallestMaps) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 6}, {6, 1}, {2, 2}})
    for (const HeightDifference difference : kAllDifferences)
      for (const MapEdges edges : kAllEdges) {
        Image normals(size.x, size.y, 3);
        for (std::size_t i = 2; i < normals.samples().size(); i += 3) normals.samples()[i] = 1.0f;
        const Image heights = heightsFromNormals(normals, {difference, edges}).value();
        EXPECT_THAT(heights.samples(), ::testing::Each(0.0f));
      }
}

TEST(HeightsFromNormals, RefusesWhatHasNoHeights) {
  Image normals(4, 3, 3, 0.5f);
  EXPECT_EQ(heightsFromNormals(normals, {.scale = 0.0f}).error().code, ErrorCode::bad_shape);
  normals.texel(2, 1)[2] = -0.1f;
  EXPECT_EQ(heightsFromNormals(normals).error().message,
            "the normal at (2, 1) does not point out of the surface; its third component should be above 0");
  normals.texel(3, 2)[0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(heightsFromNormals(normals).error().message, "1 texel is NaN or infinite, the first at (3, 2)");
  const auto stopped = heightsFromNormals(Image(64, 64, 3, 1.0f), {}, [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
