#include "mirrorball/transfer/texel_cover.h"

#include <algorithm>
#include <limits>
#include <map>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr std::uint32_t kNothing = CoverSample::kNothing;

const std::vector<UvTriangle> kSquare{{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};

/// All samples of a map, and how many overlap.
struct Covered {
  std::vector<CoverSample> samples;
  std::size_t overlapping = 0;
};

Covered coveredBy(const std::vector<UvTriangle>& triangles, glm::ivec2 size, int side) {
  const auto cover = TexelCover::make(triangles, size, side);
  EXPECT_TRUE(cover) << cover.error().message;
  Covered covered;
  std::vector<CoverSample> row(std::size_t(size.x) * cover->samplesPerTexel());
  for (int y = 0; y < size.y; ++y) {
    covered.overlapping += cover->coverRow(y, row);
    covered.samples.insert(covered.samples.end(), row.begin(), row.end());
  }
  return covered;
}

std::size_t emptyIn(const Covered& covered) {
  return std::size_t(std::ranges::count(covered.samples, kNothing, &CoverSample::triangle));
}

TEST(TexelCover, OfASquareHasNoGapAndNoOverlap) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(7, 5), glm::ivec2(64, 64), glm::ivec2(1, 100)})
    for (const int side : {1, 2, 3, 8}) {
      const Covered covered = coveredBy(kSquare, size, side);
      EXPECT_EQ(emptyIn(covered), 0u) << size.x << "x" << size.y << ", " << side;
      EXPECT_EQ(covered.overlapping, 0u);
    }
}

TEST(TexelCover, KnowsWhereInATriangleASampleLies) {
  const UvTriangle triangle{{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.95f}}};
  constexpr int kSide = 32;
  const Covered covered = coveredBy({triangle}, {kSide, kSide}, 1);
  std::size_t found = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const CoverSample& sample = covered.samples[std::size_t(y * kSide + x)];
      if (sample.triangle == kNothing) continue;
      ++found;
      const glm::vec2 b = sample.barycentric;
      const glm::vec2 place = (1.0f - b.x - b.y) * triangle[0] + b.x * triangle[1] + b.y * triangle[2];
      EXPECT_LT(glm::distance(place, (glm::vec2(x, y) + 0.5f) / float(kSide)), 1e-5f);
    }
  EXPECT_NEAR(double(found) / (kSide * kSide), 0.275, 0.02);  // half the cross product of its edges
}

TEST(TexelCover, WrapsWhatLiesBeyondTheMap) {
  const auto moved = [](glm::vec2 by) {
    std::vector<UvTriangle> triangles = kSquare;
    for (UvTriangle& triangle : triangles)
      for (glm::vec2& corner : triangle) corner = 0.5f * corner + by;
    return coveredBy(triangles, {16, 16}, 2);
  };
  const Covered inside = moved({0.25f, 0.25f});
  for (const glm::vec2 by : {glm::vec2(7.25f, 0.25f), glm::vec2(0.25f, -3.75f), glm::vec2(-100.75f, 100.25f)}) {
    const Covered beyond = moved(by);
    ASSERT_EQ(beyond.samples.size(), inside.samples.size());
    for (std::size_t i = 0; i < inside.samples.size(); ++i)
      EXPECT_EQ(beyond.samples[i].triangle == kNothing, inside.samples[i].triangle == kNothing) << i;
  }
  EXPECT_EQ(emptyIn(moved({0.75f, 0.75f})), 3u * 16 * 16);  // in all four corners of the map
}

TEST(TexelCover, GivesOverlapsToTheFirstAndCountsThem) {
  const Covered covered = coveredBy({kSquare[0], kSquare[0], kSquare[0]}, {32, 32}, 1);  // each sample once
  EXPECT_NEAR(double(covered.overlapping), 32 * 32 / 2, 40.0);
  for (const CoverSample& sample : covered.samples) EXPECT_NE(sample.triangle, 1u);
}

TEST(TexelCover, TakesMirroredAndLeavesFlatTriangles) {
  EXPECT_EQ(emptyIn(coveredBy({{{{0, 0}, {1, 1}, {1, 0}}}, {{{0, 0}, {0, 1}, {1, 1}}}}, {9, 9}, 2)), 0u);
  EXPECT_EQ(emptyIn(coveredBy({{{{0, 0}, {1, 1}, {0.5f, 0.5f}}}, {{{0, 0}, {0, 0}, {0, 0}}}}, {9, 9}, 2)), 4u * 81);
  EXPECT_EQ(emptyIn(coveredBy({}, {3, 3}, 1)), 9u);
}

TEST(TexelCover, RefusesTrianglesWithoutEnd) {
  for (const float far : {20.0f, 1e5f, 1e30f, std::numeric_limits<float>::max()}) {
    const auto cover = TexelCover::make({{{{0, 0}, {far, 0}, {0, 1}}}}, {4, 4}, 1);
    ASSERT_FALSE(cover) << far;
    EXPECT_EQ(cover.error().code, ErrorCode::out_of_range);
  }
  EXPECT_FALSE(TexelCover::make({{{{1e6f, 0}, {1e6f + 1, 0}, {1e6f, 1}}}}, {4, 4}, 1));
}

}  // namespace
}  // namespace mirrorball
