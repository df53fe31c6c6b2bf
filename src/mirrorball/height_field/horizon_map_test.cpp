#include "mirrorball/height_field/horizon_map.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "formula/relief.h"
#include "mirrorball/height_field/height_field_testing.h"
#include "mirrorball/height_field/occlusion.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

float slopeAt(const HorizonMap& map, glm::ivec2 texel, int azimuth) {
  return map.slopes.at(0, 0, azimuth / 4).texel(texel.x, texel.y)[azimuth % 4];
}

// A single post: from each of its eight sides it stands where it should, and only there.
TEST(HorizonMap, APostIsSeenFromAllSides) {
  Image heights(16, 16, 1);
  heights.texel(8, 8)[0] = 1.0f;
  const HorizonMap map = *horizonMap(heights, MapEdges::clamped);
  const glm::ivec2 steps[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  for (int azimuth = 0; azimuth < 8; ++azimuth) {
    const glm::ivec2 from = glm::ivec2(8) - 3 * steps[azimuth];
    const float distance = 3.0f * glm::length(glm::vec2(steps[azimuth])) / 16.0f;
    for (int other = 0; other < 8; ++other)
      EXPECT_NEAR(slopeAt(map, from, other), other == azimuth ? 1.0f / distance : 0.0f, 1e-5f)
          << azimuth << ", " << other;
  }
}

// What a renderer reads of it on a plane is what the map of occlusion says there, at another scale than the map's own.
TEST(HorizonMap, TheSkyOverItIsThatOfTheOcclusion) {
  const float scale = 0.2f;
  const Image heights = testing::hills(64, 64, 3);
  const HorizonMap map = *horizonMap(heights);
  const Occlusion occlusion = *occlusionOf(heights, {.scale = scale}, 8);
  const Image normals = *normalsFromHeights(heights, {.scale = scale});
  const formula::ReliefGround ground{{1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, scale};
  float least = 1.0f;
  for (int y = 0; y < 64; y += 5)
    for (int x = 0; x < 64; x += 5) {
      const auto four = [&](int layer) { return rgbaAt(map.slopes.at(0, 0, layer), x, y); };
      glm::vec3 mean(0.0f);
      float share = 0.0f;
      for (int azimuth = 0; azimuth < 8; ++azimuth) {
        const formula::SkySlice slice =
            formula::slicesOfSky(ground, {four(0), four(1)}, rgbAt(normals, x, y), azimuth).visible;
        share += slice.share;
        mean += slice.share * slice.direction;
      }
      EXPECT_NEAR(share, occlusion.visible.texel(x, y)[0], 1e-4f) << x << ", " << y;
      EXPECT_GT(glm::dot(glm::normalize(mean), rgbAt(occlusion.bent_normals, x, y)), 0.99f) << x << ", " << y;
      least = std::min(least, share);
    }
  EXPECT_LT(least, 0.9f) << "the hills hide something";
}

// A wall in the way of growing u: light that is reflected there is hidden below its top, and not above nor elsewhere.
TEST(HorizonMap, AWallHidesWhatIsReflectedTowardsIt) {
  const formula::ReliefGround ground{{2.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 0.5f};
  const formula::Horizons wall{{4.0f, 0.0f, 0.0f, 0.0f}, glm::vec4(0.0f)};  // 4 · 0.5 over a width of 2: a slope of 1
  const auto seen = [&](glm::vec3 direction) {
    return formula::lobeOverHorizons(ground, wall, ground.up, glm::normalize(direction), 0.0f);
  };
  EXPECT_EQ(seen({1.0f, 0.0f, 0.9f}), 0.0f);
  EXPECT_EQ(seen({1.0f, 0.0f, 1.1f}), 1.0f);
  EXPECT_EQ(seen({-1.0f, 0.0f, 0.1f}), 1.0f);
  EXPECT_EQ(seen({0.0f, 0.0f, 1.0f}), 1.0f);
  // Of a wide lobe that points at the top of the wall half is above it, and more than half of what is above the ground.
  const float wide =
      formula::lobeOverHorizons(ground, wall, ground.up, glm::normalize(glm::vec3(1.0f, 0.0f, 1.0f)), 0.5f);
  EXPECT_GT(wide, 0.5f);
  EXPECT_LT(wide, 0.6f);
}

TEST(HorizonMap, HasMipLevelsOfAnySize) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 9}, {9, 1}, {1030, 3}}) {
    const HorizonMap map = *horizonMap(testing::randomHeights(size.x, size.y));
    const int side = std::max(size.x, size.y);
    EXPECT_EQ(map.slopes.at(0, 0).width(), side > 512 ? 257 : size.x);
    EXPECT_EQ(map.slopes.levels(), levelCount(std::max(map.slopes.at(0, 0).width(), map.slopes.at(0, 0).height())));
    EXPECT_EQ(map.slopes.at(map.slopes.levels() - 1, 0, 1).texelCount(), 1u);
  }
  Image heights(4, 4, 1);
  heights.texel(1, 2)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(horizonMap(heights).error().message, "1 texel is NaN or infinite, the first at (1, 2)");
}

}  // namespace
}  // namespace mirrorball
