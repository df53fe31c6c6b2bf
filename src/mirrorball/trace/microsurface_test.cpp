#include "mirrorball/trace/microsurface.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/surface.h"

namespace mirrorball {
namespace {

TEST(Microsurface, ARayFindsAWayOutOfTheDeepestPit) {
  const glm::vec3 up = glm::normalize(glm::vec3(0.7f, 0.0f, 0.7f));
  for (const float u : {0.0f, 0.1f, 0.5f, 0.9f, 0.999999f}) {
    const float height = heightOfNextFacet(glm::vec2(0.1f), up, -1.0f, u);
    EXPECT_FALSE(std::isnan(height)) << u;
    EXPECT_GE(height, -1.0f) << u;
  }
  EXPECT_GT(escapeProbability(glm::vec2(0.1f), up, -1.0f), 0.0f);
}

// Of the rays from a height, as many get above another one as there are fewer that escape from below it.
TEST(Microsurface, HeightsAreMetAsOftenAsRaysDoNotGetHigher) {
  const glm::vec3 w = glm::normalize(glm::vec3(0.9f, 0.0f, 0.2f));
  constexpr float kAlpha = 0.7f, kBegin = -0.6f, kLimit = 0.1f;
  const float escapes = escapeProbability(glm::vec2(kAlpha), w, kBegin);
  int lower = 0;
  constexpr int kRays = 10000;
  for (int i = 0; i < kRays; ++i)
    lower += heightOfNextFacet(glm::vec2(kAlpha), w, kBegin, (float(i) + 0.5f) / kRays) < kLimit ? 1 : 0;
  const float gets_past_limit = escapes / escapeProbability(glm::vec2(kAlpha), w, kLimit);
  EXPECT_NEAR(float(lower) / kRays, (1.0f - gets_past_limit) / (1.0f - escapes), 1e-3f);
}

// A ray from above meets the surface, or it could not be seen.
TEST(Microsurface, ARayFromAboveMeetsAFacet) {
  for (const float z : {-1.0f, -0.5f, -0.01f}) {
    const glm::vec3 w(std::sqrt(1.0f - z * z), 0.0f, z);
    EXPECT_EQ(escapeProbability(glm::vec2(0.3f), w, kAboveAllFacets), 0.0f);
    for (const float u : {0.0f, 0.5f, 0.999f}) {
      const float height = heightOfNextFacet(glm::vec2(0.3f), w, kAboveAllFacets, u);
      EXPECT_GE(height, -1.0f);
      EXPECT_LE(height, 1.0f);
    }
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
          sum += double(densityOfMetFacets(glm::vec2(alpha), w, h)) * area * 2.0 * left * 6.283185307179586 / kSteps /
                 kSteps;
        }
      EXPECT_NEAR(sum, 1.0, 2e-3) << alpha << ", " << z;
    }
}

constexpr std::size_t kMostBounces = 23;

/// Calls visit(the cosines at which a ray meets facets before it escapes) for rays from above at that cosine.
template <typename Visit>
void forEachWalk(float alpha, float cosine, int rays, const Visit& visit) {
  std::vector<float> cosines;
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(random() >> 8u) * 0x1p-24f; };
  for (int i = 0; i < rays; ++i) {
    glm::vec3 w(-std::sqrt(1.0f - cosine * cosine), 0.0f, -cosine);
    float height = kAboveAllFacets;
    cosines.clear();
    while (cosines.size() < kMostBounces &&
           (cosines.empty() || uniform() >= escapeProbability(glm::vec2(alpha), w, height))) {
      height = heightOfNextFacet(glm::vec2(alpha), w, height, uniform());
      const glm::vec2 u(uniform(), uniform());
      const glm::vec3 facet = formula::sampleVisibleNormal(glm::vec2(alpha), -w, u);
      cosines.push_back(-glm::dot(w, facet));
      w = glm::reflect(w, facet);
    }
    visit(cosines);
  }
}

/// The share of the rays that meet one facet, two …
std::array<float, kMostBounces + 1> sharesOfBounces(float alpha, float cosine, int rays) {
  std::array<float, kMostBounces + 1> shares{};
  forEachWalk(alpha, cosine, rays,
              [&](const std::vector<float>& met) { shares[met.size()] += 1.0f / static_cast<float>(rays); });
  return shares;
}

// The renderer's formula, for facets that reflect the same share at every angle.
TEST(MultipleScattering, IsWhatRaysBetweenTheFacetsBring) {
  for (const float roughness : {0.45f, 0.7f, 0.85f, 1.0f})
    for (const float cosine : {1.0f, 0.6f, 0.25f, 0.1f}) {
      const auto shares = sharesOfBounces(roughness * roughness, cosine, 50'000);
      for (const float reflectance : {0.1f, 0.5f, 0.9f}) {
        float several = 0.0f;
        for (std::size_t bounces = 2; bounces < shares.size(); ++bounces)
          several += shares[bounces] * std::pow(reflectance, static_cast<float>(bounces));
        const glm::vec3 found =
            formula::multipleScattering(glm::vec3(reflectance), glm::vec3(reflectance), 1.0f - shares[1]);
        EXPECT_NEAR(found.x, several, 0.01f) << roughness << " at " << cosine << ", " << reflectance;
      }
    }
}

// And for such as reflect more or less at grazing angles.
TEST(MultipleScattering, MeetsTiltedFacetsFirst) {
  const std::vector<std::function<float(float)>> forms = {
      [](float c) { return formula::fresnelDielectric(c, 1.5f); },
      [](float c) { return formula::fresnelF82(c, glm::vec3(0.9f), glm::vec3(0.5f)).x; },
      [](float c) { return formula::fresnelEmpirical(c, 0.1f, 0.9f, 2.0f); }};
  constexpr int kRays = 50'000;
  for (std::size_t form = 0; form < forms.size(); ++form)
    for (const float roughness : {0.6f, 1.0f})
      for (const float cosine : {1.0f, 0.5f, 0.2f}) {
        double once = 0.0;
        double several = 0.0;
        double missing = 0.0;
        forEachWalk(roughness * roughness, cosine, kRays, [&](const std::vector<float>& met) {
          double share = 1.0 / kRays;
          if (met.size() > 1) missing += share;
          for (const float at : met) share *= double(forms[form](at));
          (met.size() > 1 ? several : once) += share;
        });
        const glm::vec3 at = formula::kMeanFresnelCosines;
        formula::FacetShares facets;
        facets.seen = glm::vec3(float(once / (1.0 - missing)));
        facets.normal = glm::vec3(forms[form](1.0f));
        facets.mean = glm::vec3(
            glm::dot(formula::kMeanFresnelWeights, glm::vec3(forms[form](at.x), forms[form](at.y), forms[form](at.z))));
        EXPECT_NEAR(
            formula::multipleScattering(formula::firstOfSeveral(facets), facets.mean, static_cast<float>(missing)).x,
            several, 0.035)
            << "form " << form << ", " << roughness << " at " << cosine;
      }
}

}  // namespace
}  // namespace mirrorball
