#include "mirrorball/bake/prefilter/point_light_batch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Points around a light, near it and far away, the light itself and its opposite among them.
PointBatch pointsAround(glm::vec3 middle) {
  const glm::vec3 beside = glm::normalize(glm::cross(middle, glm::vec3(0.0f, 1.0f, 0.0f)));
  PointBatch points;
  points.count = 101;  // no whole number of vectors
  for (std::size_t i = 0; i < 101; ++i) {
    const float angle = 3.14159265f * static_cast<float>(i * i) / 1e4f;
    const glm::vec3 direction = glm::normalize(std::cos(angle) * middle + std::sin(angle) * beside);
    points.x[i] = direction.x;
    points.y[i] = direction.y;
    points.z[i] = direction.z;
  }
  return points;
}

TEST(PointLightBatch, IsTheLobesFormula) {
  const PointOfLight light{glm::normalize(glm::vec3(0.3f, 0.5f, -0.7f)), {3.0f, 2.0f, 1.0f}};
  const PointBatch points = pointsAround(light.direction);
  for (const Distribution distribution :
       {Distribution::ggx, Distribution::phong, Distribution::blinn, Distribution::charlie})
    for (const float roughness : {0.06f, 0.3f, 0.7f, 1.0f}) {
      const Lobe lobe = Lobe::reflection(distribution, roughness);
      const LightChannels found = lightOfPoints({light, light}, lobe, points);
      float brightest = 0.0f;
      for (std::size_t i = 0; i < 101; ++i) brightest = std::max(brightest, found.channel[2][i]);
      EXPECT_GT(brightest, 0.0f);
      for (std::size_t i = 0; i < 101; ++i) {
        const glm::vec3 difference = light.direction - glm::vec3(points.x[i], points.y[i], points.z[i]);
        const float expected = 2.0f * lobe.at(glm::dot(difference, difference) / 4.0f);
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(found.channel[c][i], light.flux[int(c)] * expected, 1e-5f * brightest)
              << static_cast<int>(distribution) << " " << roughness << " " << i;
      }
    }
}

}  // namespace
}  // namespace mirrorball
