#include "mirrorball/trace/microsurface.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Microsurface, ARayFindsAWayOutOfTheDeepestPit) {
  const glm::vec3 up = glm::normalize(glm::vec3(0.7f, 0.0f, 0.7f));
  for (const float u : {0.0f, 0.1f, 0.5f, 0.9f, 0.999999f}) {
    const float height = heightOfNextFacet(0.1f, up, -1.0f, u);
    EXPECT_FALSE(std::isnan(height)) << u;
    EXPECT_GE(height, -1.0f) << u;
  }
  EXPECT_EQ(heightOfNextFacet(0.1f, up, -1.0f, 0.9999999f), kEscaped);
}

// A ray from above meets the surface, or it could not be seen.
TEST(Microsurface, ARayFromAboveMeetsAFacet) {
  for (const float z : {-1.0f, -0.5f, -0.01f})
    for (const float u : {0.0f, 0.5f, 0.999f}) {
      const float height = heightOfNextFacet(0.3f, {std::sqrt(1.0f - z * z), 0.0f, z}, kAboveAllFacets, u);
      EXPECT_GE(height, -1.0f);
      EXPECT_LE(height, 1.0f);
    }
}

// The facets that are met are all of them: their density integrates to 1, also for rays that come from below.
TEST(Microsurface, DensitiesIntegrateToOne) {
  for (const float alpha : {0.2f, 0.8f})
    for (const float z : {0.9f, 0.2f, -0.4f}) {
      const glm::vec3 w(std::sqrt(1.0f - z * z), 0.0f, z);
      double sum = 0.0;
      constexpr int kSteps = 1024;
      for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
          // By tan² of the angle over alpha², u / (1 − u), GGX's facets are spread evenly; the steep ones are met by
          // rays from below, and so get more steps: 1 − u = (1 − s)².
          const double left = 1.0 - (i + 0.5) / kSteps, u = 1.0 - left * left,
                       phi = 6.283185307179586 * (j + 0.5) / kSteps;
          const double tangent2 = double(alpha) * double(alpha) * u / (1.0 - u), cosine2 = 1.0 / (1.0 + tangent2);
          const double sine = std::sqrt(1.0 - cosine2), cosine = std::sqrt(cosine2);
          const glm::vec3 h(sine * std::cos(phi), sine * std::sin(phi), cosine);
          // dω = ½ cos³ d(tan²) dφ, and d(tan²) = alpha² / (1 − u)² du.
          const double area = 0.5 * cosine * cosine2 * double(alpha) * double(alpha) / ((1.0 - u) * (1.0 - u));
          sum += double(densityOfMetFacets(alpha, w, h)) * area * 2.0 * left * 6.283185307179586 / kSteps / kSteps;
        }
      EXPECT_NEAR(sum, 1.0, 2e-3) << alpha << ", " << z;
    }
}

}  // namespace
}  // namespace mirrorball
