#include "mirrorball/environment/statistics.h"

#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

TEST(RadianceStatistics, AreTheSameInEveryProjection) {
  // The mean of y² over the sphere is 1/3, of a constant itself, of x nothing; over its half z ≥ 0 too.
  const Environment light([](glm::vec3 d) { return glm::vec3(d.y * d.y, 2.0f, 1.0f + d.x); }, 128);
  for (const Projection projection : testing::kEveryProjection) {
    if (projection == Projection::ballFrom(1.5f)) continue;  // it hides a cone of 42° around −Z
    const RadianceStatistics statistics = radianceStatistics(*convert(light, projection, 128));
    EXPECT_NEAR(statistics.mean.x, 1.0f / 3.0f, 2e-3f) << nameOf(projection);
    EXPECT_NEAR(statistics.mean.y, 2.0f, 1e-5f) << nameOf(projection);
    EXPECT_NEAR(statistics.mean.z, 1.0f, 2e-3f) << nameOf(projection);
  }
}

TEST(RadianceStatistics, FindTheBrightestTexelAndSkipBadOnes) {
  Image image(8, 4, 3, 1.0f);
  image.texel(6, 1)[1] = 5.0f;
  image.texel(0, 0)[0] = std::numeric_limits<float>::infinity();
  image.texel(1, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  const EnvironmentMap map(Projection::equirect, ImageSet(std::move(image)));
  const RadianceStatistics statistics = radianceStatistics(map);
  EXPECT_EQ(statistics.max, glm::vec3(1, 5, 1));
  EXPECT_EQ(statistics.min, glm::vec3(1));
  EXPECT_EQ(statistics.brightest, glm::vec3(1, 5, 1));
  EXPECT_EQ(statistics.brightest_direction, directionAt(Projection::equirect, {0, {6.5f / 8.0f, 1.5f / 4.0f}}));
}

}  // namespace
}  // namespace mirrorball
