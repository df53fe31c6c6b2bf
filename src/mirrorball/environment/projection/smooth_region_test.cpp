#include "mirrorball/environment/projection/smooth_region.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

constexpr int kRegionSide = 128;

/// Every texel's centre of every map that has smooth regions, and its region.
template <typename Check>
void forEachTexel(Check&& check) {
  for (const Projection projection : testing::kEveryProjection) {
    if (!hasSmoothRegions(projection)) continue;
    for (const int side : {kRegionSide, kRegionSide + 1})
      for (int face = 0; face < faceCount(projection); ++face)
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x) {
            const MapPosition place{face, (glm::vec2(x, y) + 0.5f) / static_cast<float>(side)};
            if (covers(projection, place.uv)) check(projection, side, place, SmoothRegion(projection, side, place));
          }
  }
}

TEST(SmoothRegion, HoldsThePlaceItIsOf) {
  forEachTexel([](Projection projection, int side, MapPosition place, const SmoothRegion& region) {
    EXPECT_EQ(region.face(), place.face);
    EXPECT_TRUE(region.holds(place.uv * float(side))) << nameOf(projection) << place.uv.x << ", " << place.uv.y;
  });
}

TEST(SmoothRegion, CubicStencilIsItsOwnAndAroundThePosition) {
  forEachTexel([](Projection projection, int side, MapPosition place, const SmoothRegion& region) {
    const auto texels = region.cubicStencil(place.uv * float(side));
    ASSERT_TRUE(texels);
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i + j <= 3; ++i) {
        const glm::vec2 center = glm::vec2(texels->first + texels->step * glm::ivec2(i, j)) + 0.5f;
        EXPECT_TRUE(region.holds(center)) << nameOf(projection) << center.x << ", " << center.y;
      }
    const glm::vec2 again = glm::vec2(texels->first) + 0.5f + glm::vec2(texels->step) * texels->inside;
    EXPECT_LT(glm::distance(again, place.uv * float(side)), 1e-3f);
    // Not farther from them than the curve of a disc's rim makes them lie.
    const glm::vec2 inside = texels->inside;
    EXPECT_GT(std::min(inside.x, inside.y), -1.01f) << nameOf(projection);
    EXPECT_LT(std::max(inside.x, inside.y), 4.01f) << nameOf(projection);
  });
}

/// Whether a place of the equal-area square is near one of its poles, where it is the tip of a cone.
bool isNearPole(glm::vec2 uv) {
  const glm::vec2 from_middle = glm::abs(uv - 0.5f);
  return std::min(glm::length(from_middle), glm::length(0.5f - from_middle)) < 0.15f;
}

// The way goes on over the border as it went before it: of the steps from texel to texel each is nearly the one before.
// Across a fold the texels themselves turn, by up to 90°.
TEST(SmoothRegion, GoesOnBeyondItsBorderWithoutAKink) {
  forEachTexel([](Projection projection, int side, MapPosition place, const SmoothRegion& region) {
    if (projection == Projection::equal_area && isNearPole(place.uv)) return;
    const glm::vec2 start = place.uv * float(side);
    for (const glm::vec2 step : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
      if (region.holds(start + step)) continue;
      const glm::vec2 last = start + 2.0f * step;
      const bool is_beside = std::min(last.x, last.y) < 0.0f || std::max(last.x, last.y) > float(side);
      if (projection == Projection::hemioctahedral && is_beside) continue;  // there the map ends
      if (!region.holds(start - step)) continue;
      const auto directionOf = [&](glm::vec2 at) {
        return directionAt(projection,
                           region.holds(at) ? MapPosition{place.face, at / float(side)} : region.placeOf(at));
      };
      const glm::vec3 before = directionOf(start) - directionOf(start - step);
      const glm::vec3 across = directionOf(start + step) - directionOf(start);
      const glm::vec3 after = directionOf(start + 2.0f * step) - directionOf(start + step);
      EXPECT_LT(glm::distance(before, across), 0.12f * glm::length(before)) << nameOf(projection);
      EXPECT_LT(glm::distance(across, after), 0.12f * glm::length(across)) << nameOf(projection);
    }
  });
}

}  // namespace
}  // namespace mirrorball
