#include "formula/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace mirrorball::formula {
namespace {

/// What the comment of a built-in height promises.
struct BuiltinHeight {
  const char* name;
  int kind;
  float greatest_slope;
  float mean;
};

void PrintTo(const BuiltinHeight& height, std::ostream* out) { *out << height.name; }

class BuiltinHeightTest : public ::testing::TestWithParam<BuiltinHeight> {};

/// Place number i of some in [0, 1)², of so few binary digits that whole numbers and steps are added without rounding.
vec2 place(int i, int bits) {
  return floor(vec2(gridRandom(ivec3(i, 5, 9))) * std::exp2(static_cast<float>(bits))) *
         std::exp2(-static_cast<float>(bits));
}

TEST_P(BuiltinHeightTest, RepeatsExactlyAfterOne) {
  for (int i = 0; i < 2000; ++i) {
    const vec2 uv = place(i, 12);
    const vec2 tile = floor(vec2(gridRandom(ivec3(i, 6, 9))) * 7.0f - 3.0f);
    EXPECT_EQ(builtinHeight(GetParam().kind, uv), builtinHeight(GetParam().kind, uv + tile)) << uv.x << ", " << uv.y;
  }
}

TEST_P(BuiltinHeightTest, HasNoSeam) {
  constexpr float kBeside = 0x1p-20f;
  for (int i = 0; i < 2000; ++i) {
    const float t = place(i, 20).x;
    for (const bool swapped : {false, true}) {
      const vec3 begin = builtinHeight(GetParam().kind, swapped ? vec2(t, 0.0f) : vec2(0.0f, t));
      const vec3 end = builtinHeight(GetParam().kind, swapped ? vec2(t, 1.0f - kBeside) : vec2(1.0f - kBeside, t));
      EXPECT_NEAR(begin.z, end.z, GetParam().greatest_slope * kBeside + 2e-5f) << t;
      EXPECT_LT(length(vec2(begin) - vec2(end)), 2e-3f * GetParam().greatest_slope) << t;
    }
  }
}

TEST_P(BuiltinHeightTest, FillsTheRangeAndIsNowhereSteeperThanItSays) {
  constexpr int kSize = 720;
  float lowest = 1.0f;
  float highest = 0.0f;
  float steepest = 0.0f;
  double sum = 0.0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const vec3 height = builtinHeight(GetParam().kind, (vec2(x, y) + 0.3f) / static_cast<float>(kSize));
      lowest = std::min(lowest, height.z);
      highest = std::max(highest, height.z);
      steepest = std::max(steepest, length(vec2(height)));
      sum += height.z;
    }
  EXPECT_GT(lowest, 0.0f);
  EXPECT_LT(lowest, 0.1f);
  EXPECT_GT(highest, 0.9f);
  EXPECT_LT(highest, 1.0f);
  EXPECT_NEAR(sum / (kSize * kSize), GetParam().mean, 0.006);
  EXPECT_LE(steepest, GetParam().greatest_slope);
  EXPECT_GT(steepest, 0.9f * GetParam().greatest_slope);
}

/// The edges of cells, where another stone, strand or brick begins, are among the places.
TEST_P(BuiltinHeightTest, DoesNotJump) {
  constexpr int kSize = 504;  // a multiple of 8, 12, 14, 24 and 72 cells
  constexpr float kStep = 0x1p-18f;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const vec2 uv = vec2(x, y) / static_cast<float>(kSize);
      const vec3 before = builtinHeight(GetParam().kind, uv - kStep);
      const vec3 after = builtinHeight(GetParam().kind, uv + kStep);
      ASSERT_NEAR(before.z, after.z, 2.0f * GetParam().greatest_slope * std::sqrt(2.0f) * kStep + 3e-5f)
          << uv.x << ", " << uv.y;
      // No crease either: the sharpest bend is at the foot of a bevel.
      ASSERT_LT(length(vec2(before) - vec2(after)), 0.02f * GetParam().greatest_slope) << uv.x << ", " << uv.y;
    }
}

TEST_P(BuiltinHeightTest, TheGradientIsTheHeightsOwn) {
  constexpr int kPlaces = 20000;
  constexpr float kStep = 0x1p-14f;
  const auto heightAt = [](vec2 uv) { return builtinHeight(GetParam().kind, uv).z; };
  double sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const vec2 uv = place(i, 14);
    const vec3 here = builtinHeight(GetParam().kind, uv);
    const vec2 u(kStep, 0.0f);
    const vec2 v(0.0f, kStep);
    const vec2 slope = vec2(heightAt(uv + u) - heightAt(uv - u), heightAt(uv + v) - heightAt(uv - v)) / (2.0f * kStep);
    const float off = length(vec2(here) - slope) / GetParam().greatest_slope;
    EXPECT_LT(off, 0.01f) << uv.x << ", " << uv.y;  // bends within the step
    sum += off;
  }
  EXPECT_LT(sum / kPlaces, 3e-4);  // rounding
}

TEST_P(BuiltinHeightTest, IsInRangeFarAwayAndNoNumberDoesNoHarm) {
  for (const float far : {1e9f, -1e30f, -1e-9f, 16777217.0f}) {
    const vec3 height = builtinHeight(GetParam().kind, vec2(far, 0.3f));
    EXPECT_GT(height.z, 0.0f) << far;
    EXPECT_LT(height.z, 1.0f) << far;
  }
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const vec3 height = builtinHeight(GetParam().kind, vec2(0.3f, bad));
    EXPECT_FALSE(std::isfinite(height.z) && (height.z < 0.0f || height.z > 1.0f)) << bad;
  }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinHeightTest,
                         ::testing::Values(BuiltinHeight{"orange", kHeightOrange, 36.0f, 0.67f},
                                           BuiltinHeight{"brick", kHeightBrick, 101.0f, 0.52f},
                                           BuiltinHeight{"cobbles", kHeightCobbles, 82.0f, 0.42f},
                                           BuiltinHeight{"weave", kHeightWeave, 55.0f, 0.77f},
                                           BuiltinHeight{"hammered", kHeightHammered, 14.0f, 0.36f},
                                           BuiltinHeight{"waves", kHeightWaves, 37.0f, 0.43f}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(BuiltinHeight, IsFlatWithoutAKind) {
  for (const int kind : {kHeightFlat, -1, kHeightWaves + 1})
    EXPECT_EQ(builtinHeight(kind, vec2(0.3f, 0.6f)), vec3(0.0f)) << kind;
}

TEST(DualMaximum, IsTheGreaterOneFarFromTheCrease) {
  const vec3 low(1.0f, 2.0f, 0.0f);
  const vec3 high(-3.0f, 0.5f, 1.0f);
  EXPECT_LT(distance(dualMaximum(low, high, 0.01f), high), 2e-3f);
  EXPECT_LT(distance(dualMaximum(high, low, 0.01f), high), 2e-3f);
  const vec3 crease = dualMaximum(low, vec3(-3.0f, 0.5f, 0.0f), 0.01f);
  EXPECT_LT(distance(crease, vec3(-1.0f, 1.25f, 0.005f)), 1e-6f);
}

TEST(DualSmoothstep, FallsWhereItsEndsAreExchanged) {
  const vec3 x(1.0f, 0.0f, 0.25f);
  const vec3 rising = dualSmoothstep(0.0f, 1.0f, x);
  const vec3 falling = dualSmoothstep(1.0f, 0.0f, x);
  EXPECT_FLOAT_EQ(rising.z, 0.15625f);
  EXPECT_FLOAT_EQ(rising.x, 1.125f);
  EXPECT_FLOAT_EQ(falling.z, 1.0f - rising.z);
  EXPECT_FLOAT_EQ(falling.x, -rising.x);
}

/// What the heights rely on: points of other cells than those asked for are so far away.
TEST(ScatteredPoint, OthersThanTheNearestCellsAreOutOfReach) {
  constexpr float kJitter = 0.6f;
  const auto distanceOf = [](vec2 place, int i, int count) {
    return length(vec2(scatteredPoint(place, i, count, kJitter, 8, 3)));
  };
  int beyond_four = 0;
  for (int n = 0; n < 5000; ++n) {
    const vec2 at = place(n, 20) * 8.0f;
    for (int i = 0; i < 9; ++i) {
      const float far = distanceOf(at, i, 3);
      bool is_among_four = false;
      for (int j = 0; j < 4; ++j) is_among_four = is_among_four || std::abs(distanceOf(at, j, 2) - far) < 1e-5f;
      if (is_among_four) continue;
      ++beyond_four;
      EXPECT_GE(far, 1.0f - 0.5f * kJitter) << at.x << ", " << at.y;
    }
  }
  EXPECT_GT(beyond_four, 5000 * 5 - 500);
}

}  // namespace
}  // namespace mirrorball::formula
