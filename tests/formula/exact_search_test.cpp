#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/relief.h"

namespace mirrorball::formula {
namespace {

/// A map of heights with the maxima of its patches in one picture, made the plain way.
struct CountedHeights {
  HeightMap form;
  int width = 0;  // of the picture
  std::vector<float> picture = {};
  mutable int fetches = 0;

  float& at(ivec2 texel) { return picture[static_cast<std::size_t>(texel.y * width + texel.x)]; }
};

vec4 fetchMap(const CountedHeights& map, ivec2 texel, int) {
  ++map.fetches;
  return {map.picture[static_cast<std::size_t>(texel.y * map.width + texel.x)], 0.0f, 0.0f, 0.0f};
}

/// height   of a texel
template <typename HeightOfTexel>
CountedHeights countedHeights(ivec2 size, int wrap, const HeightOfTexel& height) {
  int last_level = 0;
  while (std::max(size.x, size.y) >> (last_level + 1) > 0) ++last_level;
  CountedHeights map{{vec2(size), wrap, last_level}};
  ivec2 extent(0);
  for (int level = 0; level <= last_level; ++level)
    extent = glm::max(extent, placeOfLevel(map.form, level) + sizeOfLevel(map.form, level));
  map.width = extent.x;
  map.picture.resize(static_cast<std::size_t>(extent.x * extent.y), 0.0f);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) map.at({x, y}) = height(ivec2(x, y));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const vec4 c = patchCorners(map, map.form, vec2(x, y));
      for (int level = 1; level <= last_level; ++level) {
        const ivec2 cell = glm::min(ivec2(x, y) >> level, sizeOfLevel(map.form, level) - 1);
        float& top = map.at(placeOfLevel(map.form, level) + cell);
        top = std::max({top, c.x, c.y, c.z, c.w});
      }
    }
  return map;
}

struct SearchedMap {
  int width, height, wrap;
};

void PrintTo(const SearchedMap& map, std::ostream* out) {
  *out << map.width << " x " << map.height << (map.wrap == kWrapRepeat ? " tiled" : " clamped");
}

class ExactSearchTest : public ::testing::TestWithParam<SearchedMap> {
 protected:
  CountedHeights heights(int seed) const {
    return countedHeights({GetParam().width, GetParam().height}, GetParam().wrap,
                          [=](ivec2 texel) { return gridRandom(ivec3(texel, seed)).x; });
  }
  /// A way from above the map to below it, also along its rows and straight down.
  static void way(int i, vec2 size, vec3& from, vec3& to) {
    const vec3 a = gridRandom(ivec3(i, 1, 7)), b = gridRandom(ivec3(i, 2, 7));
    from = vec3((3.0f * vec2(a) - 1.0f) * size, 1.0f);
    to = vec3((3.0f * vec2(b) - 1.0f) * size, 0.0f);
    if (i % 5 == 0) to.y = from.y;
    if (i % 7 == 0) to.x = from.x;
    if (i % 11 == 0) to.z = a.z;
  }
};

/// No step of a fine march is below the surface before the place that the search finds, and there the surface is.
TEST_P(ExactSearchTest, FindsTheFirstPlaceThatAMarchFinds) {
  constexpr int kWays = 60;
  constexpr int kSteps = 4000;
  int met = 0;
  for (int i = 0; i < kWays; ++i) {
    const CountedHeights map = heights(i);
    const HeightMap form = map.form;
    vec3 from, to;
    way(i, map.form.size, from, to);
    const float found = exactSearch(map, form, from, to, false);
    const auto clearance = [&](float share) {
      const vec3 q = mix(from, to, share);
      return q.z - heightAt(map, form, vec2(q));
    };
    const int last = static_cast<int>(std::floor(std::min(found, 1.0f) * static_cast<float>(kSteps)));
    for (int step = 0; step <= last; ++step) {
      const float share = static_cast<float>(step) / static_cast<float>(kSteps);
      ASSERT_GT(clearance(share), -1e-4f) << "way " << i << " at " << share << ", found " << found;
    }
    if (found > 1.0f) continue;
    ++met;
    EXPECT_NEAR(clearance(found), 0.0f, 1e-4f) << "way " << i;
  }
  EXPECT_GT(met, kWays * 3 / 4);
}

// A way that begins below is met where a march has come out above the surface and goes in again.
TEST_P(ExactSearchTest, FromBelowItPassesTheSurfaceFirst) {
  constexpr int kSteps = 4000;
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const CountedHeights map = heights(i);
    vec3 from, to;
    way(i, map.form.size, from, to);
    from.z = heightAt(map, map.form, vec2(from)) - 0.1f;
    to.z = from.z + 0.1f;
    const float found = exactSearch(map, map.form, from, to, false);
    bool is_above = false;
    float marched = kNoHit;
    for (int step = 0; step <= kSteps && marched > 1.0f; ++step) {
      const vec3 q = mix(from, to, static_cast<float>(step) / static_cast<float>(kSteps));
      const float clearance = q.z - heightAt(map, map.form, vec2(q));
      if (is_above && clearance < 0.0f) marched = static_cast<float>(step) / static_cast<float>(kSteps);
      is_above = clearance > 0.0f;
    }
    // The march may step over what the search meets, but meets nothing before it.
    EXPECT_LE(found, marched + 1e-4f) << "way " << i;
    if (found > 1.0f) continue;
    ++met;
    const vec3 q = mix(from, to, found);
    EXPECT_NEAR(q.z, heightAt(map, map.form, vec2(q)), 1e-4f) << "way " << i;
  }
  const bool is_even = GetParam().width == 1 && GetParam().height == 1;
  EXPECT_TRUE(is_even ? met == 0 : met > 3) << met;
}

TEST_P(ExactSearchTest, MeetsNothingFromBelowButWhereItGoesOn) {
  const CountedHeights map = heights(3);
  const HeightMap form = map.form;
  const vec2 place = 0.3f * map.form.size;
  const float height = heightAt(map, form, place);
  const vec3 below(place, height - 1e-3f);
  EXPECT_EQ(exactSearch(map, form, below, vec3(place, -1.0f), false), kNoHit);
  EXPECT_LT(exactSearch(map, form, below, vec3(place, -1.0f), true), 1e-3f);
  EXPECT_GT(exactSearch(map, form, vec3(place, height + 1e-3f), vec3(place, 2.0f), false), 1.0f);
}

// Many tiles away it is as near.
TEST_P(ExactSearchTest, FarTilesAreAsTheFirst) {
  const CountedHeights map = countedHeights({GetParam().width, GetParam().height}, kWrapRepeat,
                                            [](ivec2 texel) { return gridRandom(ivec3(texel, 5)).x; });
  for (int i = 0; i < 20; ++i) {
    vec3 from, to;
    way(i, map.form.size, from, to);
    const vec3 tiles(std::floor(60000.0f / map.form.size.x) * map.form.size.x, 0.0f, 0.0f);
    const float first = exactSearch(map, map.form, from, to, false);
    EXPECT_NEAR(exactSearch(map, map.form, from + tiles, to + tiles, false), first, 0.02f) << "way " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, ExactSearchTest,
                         ::testing::Values(SearchedMap{1, 1, kWrapRepeat}, SearchedMap{1, 1, kWrapClampToEdge},
                                           SearchedMap{1, 5, kWrapRepeat}, SearchedMap{1, 5, kWrapClampToEdge},
                                           SearchedMap{13, 7, kWrapRepeat}, SearchedMap{13, 7, kWrapClampToEdge},
                                           SearchedMap{64, 64, kWrapRepeat}));

/// What a ray into a built-in surface on the plane (side √2, its own depth and density) costs.
TEST(ExactSearch, FetchesFewTexels) {
  constexpr int kSide = 512;
  constexpr int kRays = 1000;
  struct Surface {
    const char* name;
    int kind;
    float scale, frequency;
  };
  for (const Surface& s : {Surface{"brick", kHeightBrick, 0.03f, 2.0f}, Surface{"cobbles", kHeightCobbles, 0.08f, 3.0f},
                           Surface{"waves", kHeightWaves, 0.04f, 2.0f}}) {
    const CountedHeights map = countedHeights(ivec2(kSide), kWrapRepeat, [&](ivec2 texel) {
      return builtinHeight(s.kind, (vec2(texel) + 0.5f) / float(kSide)).z;
    });
    const float depth = s.scale * s.frequency / std::sqrt(2.0f) * float(kSide);  // texels
    for (const int angle_deg : {45, 75, 85}) {
      map.fetches = 0;
      for (int i = 0; i < kRays; ++i) {
        const vec3 random = gridRandom(ivec3(i, 3, 9));
        const float turn = kTwoPi * random.z;
        const vec2 from = vec2(random) * float(kSide);
        const vec2 run = depth * std::tan(radians(static_cast<float>(angle_deg))) * vec2(cos(turn), sin(turn));
        EXPECT_LE(exactSearch(map, map.form, vec3(from, 1.0f), vec3(from + run, 0.0f), false), 1.0f);
      }
      const int mean = map.fetches / kRays;
      RecordProperty(std::string(s.name) + "_" + std::to_string(angle_deg), mean);
      EXPECT_LT(mean, 250) << s.name << " at " << angle_deg << " degrees";
    }
  }
}

}  // namespace
}  // namespace mirrorball::formula
