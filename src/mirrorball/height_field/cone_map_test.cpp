#include "mirrorball/height_field/cone_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/height_field/height_field_testing.h"

namespace mirrorball {
namespace {

using testing::hills;
using testing::kAllEdges;
using testing::randomHeights;
using testing::surfaceAt;

/// How many texels around a tip there are: of a tiled map a period to each side.
struct Around {
  glm::ivec2 first;
  glm::ivec2 last;

  Around(const Image& heights, glm::ivec2 tip, MapEdges edges)
      : first(edges == MapEdges::tiled ? tip - size(heights) : glm::ivec2(0)),
        last(edges == MapEdges::tiled ? tip + size(heights) : size(heights) - 1) {}
  bool holds(glm::dvec2 place) const {
    return place.x >= first.x && place.y >= first.y && place.x <= last.x && place.y <= last.y;
  }
  static glm::ivec2 size(const Image& heights) { return {heights.width(), heights.height()}; }
};

/// The ratio of the widest cone without surface, from points all over the surface.
double sampledRatio(const Image& heights, glm::ivec2 tip, MapEdges edges) {
  constexpr int kPoints = 4;  // along the side of a patch
  const Around around(heights, tip, edges);
  const double height = surfaceAt(heights, tip.x, tip.y, edges);
  double ratio = 1.0;
  for (int j = around.first.y * kPoints; j <= around.last.y * kPoints; ++j)
    for (int i = around.first.x * kPoints; i <= around.last.x * kPoints; ++i) {
      const double x = double(i) / kPoints;
      const double y = double(j) / kPoints;
      const double rise = surfaceAt(heights, x, y, edges) - height;
      if (rise > 0.0) ratio = std::min(ratio, std::hypot(x - tip.x, y - tip.y) / heights.width() / rise);
    }
  return ratio;
}

/// The ratio of the widest relaxed cone as its authors find it: rays from above the tip to points of the surface (here
/// some between the texels too) are followed until they leave it again, and the cone must not hold that place.
double followedRatio(const Image& heights, glm::ivec2 tip, MapEdges edges) {
  constexpr int kPoints = 8;  // along the side of a patch
  constexpr int kStepsPerTexel = 32;
  const double top = *std::max_element(heights.samples().begin(), heights.samples().end());
  const Around around(heights, tip, edges);
  const double height = surfaceAt(heights, tip.x, tip.y, edges);
  double ratio = 1.0;
  for (int j = around.first.y * kPoints; j <= around.last.y * kPoints; ++j)
    for (int i = around.first.x * kPoints; i <= around.last.x * kPoints; ++i) {
      const glm::dvec2 to(double(i) / kPoints - tip.x, double(j) / kPoints - tip.y);
      const double distance = glm::length(to);
      const double fall = top - surfaceAt(heights, tip.x + to.x, tip.y + to.y, edges);
      if (distance == 0.0 || fall <= 0.0) continue;
      const double share = 1.0 / (distance * kStepsPerTexel);
      for (double way = 1.0 + share; top - way * fall > height; way += share) {
        const glm::dvec2 place = glm::dvec2(tip) + way * to;
        if (edges == MapEdges::clamped && !around.holds(place)) break;
        if (surfaceAt(heights, place.x, place.y, edges) > top - way * fall) continue;
        ratio = std::min(ratio, way * distance / heights.width() / (top - way * fall - height));
        break;
      }
    }
  return ratio;
}

using Ratio = std::function<double(const Image& heights, glm::ivec2 tip, MapEdges edges)>;

/// Expects cones that are nowhere wider than by brute force, and on the mean nearly as wide.
///
/// step   between the texels that are tried
void expectCones(const Image& heights, ConeKind kind, MapEdges edges, const Ratio& brute, int step,
                 double min_share = 0.95) {
  const Image cones = coneMap(heights, kind, edges).value();
  double sum = 0.0;
  double brute_sum = 0.0;
  for (int y = 0; y < heights.height(); y += step)
    for (int x = 0; x < heights.width(); x += step) {
      const double stored = cones.texel(x, y)[0];
      const double ratio = brute(heights, {x, y}, edges);
      EXPECT_LE(stored * stored, ratio * (1.0 + 1e-5)) << x << ", " << y << ", edges " << int(edges);
      sum += stored * stored;
      brute_sum += ratio;
    }
  EXPECT_GE(sum, min_share * brute_sum) << "edges " << int(edges);
}

Image pillars(int width, int height) {
  Image heights(width, height, 1, 0.1f);
  for (int y = 3; y < height; y += 7)
    for (int x = 2; x < width; x += 6) heights.texel(x, y)[0] = 0.4f + 0.1f * float(x % 4);
  return heights;
}

TEST(ConeMap, ConservativeConesAreEmptyAndNearlyAsWideAsCanBe) {
  for (const MapEdges edges : kAllEdges) {
    expectCones(hills(24, 24, 2), ConeKind::conservative, edges, sampledRatio, 3);
    expectCones(hills(19, 26, 3), ConeKind::conservative, edges, sampledRatio, 3);
    expectCones(randomHeights(16, 13), ConeKind::conservative, edges, sampledRatio, 1);
    expectCones(pillars(25, 17), ConeKind::conservative, edges, sampledRatio, 2);
  }
}

// By brute force tips get lost between the points that are tried: with 12 points a side, noise has 0.99 of its widths
// and hills have 0.985.
TEST(ConeMap, RelaxedConesAreLeftOnce) {
  for (const MapEdges edges : kAllEdges) {
    expectCones(hills(15, 15, 2), ConeKind::relaxed, edges, followedRatio, 3, 0.93);
    expectCones(randomHeights(11, 9), ConeKind::relaxed, edges, followedRatio, 2, 0.93);
    expectCones(pillars(12, 13), ConeKind::relaxed, edges, followedRatio, 3, 0.8);
  }
}

TEST(ConeMap, RelaxedConesAreNeverNarrower) {
  for (const Image& heights : {hills(64, 48, 4), randomHeights(40, 40), pillars(33, 50)}) {
    const Image conservative = coneMap(heights, ConeKind::conservative).value();
    const Image relaxed = coneMap(heights, ConeKind::relaxed).value();
    for (std::size_t i = 0; i < conservative.samples().size(); ++i)
      ASSERT_GE(relaxed.samples()[i], conservative.samples()[i] * (1.0f - 1e-6f));
  }
}

TEST(ConeMap, ATiledMapHasNoSeam) {
  const Image heights = randomHeights(30, 18);
  for (const ConeKind kind : {ConeKind::conservative, ConeKind::relaxed}) {
    const Image moved = coneMap(testing::rolled(heights, 11, 5), kind).value();
    const Image cones = testing::rolled(coneMap(heights, kind).value(), 11, 5);
    for (std::size_t i = 0; i < cones.samples().size(); ++i) ASSERT_NEAR(moved.samples()[i], cones.samples()[i], 1e-6f);
  }
}

TEST(ConeMap, TakesTheSmallestMapsAndFlatOnes) {
  for (const ConeKind kind : {ConeKind::conservative, ConeKind::relaxed})
    for (const MapEdges edges : kAllEdges) {
      EXPECT_THAT(coneMap(Image(1, 1, 1, 0.5f), kind, edges).value().samples(), ::testing::Each(1.0f));
      EXPECT_THAT(coneMap(Image(9, 6, 1, -3.0f), kind, edges).value().samples(), ::testing::Each(1.0f));
      for (const glm::ivec2 size : {glm::ivec2(1, 9), {9, 1}, {2, 2}})
        EXPECT_THAT(coneMap(randomHeights(size.x, size.y), kind, edges).value().samples(),
                    ::testing::Each(::testing::AllOf(::testing::Gt(0.0f), ::testing::Le(1.0f))));
    }
}

// A wall of height ½, ten texels of 40 away: 0.25 texture widths over ½.
TEST(ConeMap, AWallIsAsFarAsItIs) {
  Image wall(40, 40, 1);
  for (int y = 0; y < 40; ++y) wall.texel(30, y)[0] = 0.5f;
  const Image cones = coneMap(wall, ConeKind::conservative, MapEdges::clamped).value();
  EXPECT_NEAR(cones.texel(20, 7)[0], std::sqrt(0.25f / 0.5f), 1e-6f);
  EXPECT_EQ(cones.texel(30, 7)[0], 1.0f);
}

TEST(ConeMap, RefusesWhatHasNoCones) {
  Image heights(8, 4, 1);
  heights.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(coneMap(heights, ConeKind::relaxed).error().message, "1 texel is NaN or infinite, the first at (3, 1)");
  heights.texel(3, 1)[0] = 1e30f;
  EXPECT_EQ(coneMap(heights, ConeKind::relaxed).error().code, ErrorCode::out_of_range);
  const auto stopped = coneMap(Image(16, 16, 1), ConeKind::conservative, MapEdges::tiled,
                               [](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
