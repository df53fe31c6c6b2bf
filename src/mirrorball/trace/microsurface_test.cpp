#include "mirrorball/trace/microsurface.h"

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/bake/prefilter/lobe.h"

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

/// Calls visit(the cosines at which a ray meets facets before it escapes, the direction in which it does) for rays from
/// above at that cosine, towards −X.
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
    visit(cosines, w);
  }
}

/// The share of the rays that meet one facet, two …
std::array<float, kMostBounces + 1> sharesOfBounces(float alpha, float cosine, int rays) {
  std::array<float, kMostBounces + 1> shares{};
  forEachWalk(alpha, cosine, rays,
              [&](const std::vector<float>& met, glm::vec3) { shares[met.size()] += 1.0f / static_cast<float>(rays); });
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
        forEachWalk(roughness * roughness, cosine, kRays, [&](const std::vector<float>& met, glm::vec3) {
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

// How far light goes on that several facets send, beside what one does: the cosine of its turn about the normal.
TEST(MultipleScattering, GoesForwardWhereTheEyeGrazes) {
  for (const float roughness : {0.1f, 0.2f, 0.3f, 0.45f, 0.6f, 0.8f})
    for (const float cosine : {0.03f, 0.06f, 0.12f, 0.2f, 0.35f, 0.6f}) {
      struct Way {
        double rays = 0.0, forward = 0.0;
      };
      Way once, several;
      constexpr int kRays = 30'000;
      forEachWalk(roughness * roughness, cosine, kRays, [&](const std::vector<float>& met, glm::vec3 w) {
        Way& way = met.size() > 1 ? several : once;
        way.rays += 1.0;
        way.forward -= double(w.x / std::sqrt(w.x * w.x + w.y * w.y));
      });
      if (several.rays < 0.03 * kRays) continue;
      const double even = 1.0 - several.forward / several.rays / (once.forward / once.rays);
      EXPECT_NEAR(formula::evenFraction(roughness, cosine), even, 0.12) << roughness << " at " << cosine;
    }
}

formula::Surface whiteMetal(float roughness, float missing, glm::vec3 eye) {
  formula::Surface s;
  s.material = formula::coreMaterial({}, glm::vec3(1.0f), 1.0f, roughness, glm::vec3(0.0f));
  s.normal = glm::vec3(0, 0, 1);
  s.tangent = glm::vec3(1, 0, 0);
  s.occlusion = 1.0f;
  s.environment_brdf = glm::vec3(missing, 0.0f, 0.0f);
  return formula::seenAlong(s, -eye);
}

/// A lamp of radiance 1.
struct Cap {
  glm::vec3 middle;
  float least_cosine;
  bool holds(glm::vec3 w) const { return glm::dot(w, middle) > least_cosine; }
};

/// The integral over a lamp of what a function of a direction says.
template <typename Function>
double overCap(const Cap& cap, const Function& function) {
  constexpr int kDirections = 10'000;
  double sum = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    // Even over the sphere by height and golden angle.
    const float z = 1.0f - 2.0f * (float(i) + 0.5f) / kDirections;
    const float turn = 2.39996323f * float(i);
    const glm::vec3 l(std::sqrt(1.0f - z * z) * std::cos(turn), std::sqrt(1.0f - z * z) * std::sin(turn), z);
    if (cap.holds(l)) sum += double(function(l));
  }
  return sum * 4.0 * 3.14159265 / kDirections;
}

/// What a surface shows of it as of many punctual lights.
double litByLamp(const formula::Surface& s, glm::vec3 eye, const Cap& cap) {
  return overCap(cap, [&](glm::vec3 l) { return formula::shadedByPunctualLight(s, -eye, l, glm::vec3(1.0f)).x; });
}

/// What it shows of it as of an environment, by a row of lobes and the irradiance.
double litByEnvironment(const formula::Surface& s, glm::vec3 eye, const Cap& cap) {
  const glm::vec3 mirrored(-eye.x, 0.0f, eye.z);
  const float roughness = s.material.perceptual_roughness;
  double reflected = 0.0;
  for (const glm::vec4& texel : lobeRowIn(*lobeRowTable(4), 0, 4, roughness, eye.z)) {
    const formula::RoundLobe one = formula::lobeOfRow(texel, roughness, s.normal, mirrored);
    const Lobe round = Lobe::reflection(Distribution::ggx, one.perceptual_roughness);
    reflected += double(one.weight) * overCap(cap, [&](glm::vec3 l) {
                   const glm::vec3 between = l - one.direction;
                   return round.at(glm::dot(between, between) / 4.0f);
                 });
  }
  const double irradiance = overCap(cap, [](glm::vec3 l) { return std::max(l.z, 0.0f) / 3.14159265f; });
  return double(formula::shadedByEnvironment(s, glm::vec3(float(reflected)), glm::vec3(0.0f),
                                             glm::vec3(float(irradiance)), glm::vec3(0.0f))
                    .x);
}

/// Lamps high above white metal that an eye grazes, beside it and behind the eye: nearly all of their light comes from
/// several facets.
constexpr int kCaps = 2;
const std::array<Cap, kCaps> kHighCaps{Cap{glm::vec3(0.0f, 0.6f, 0.8f), 0.9f}, Cap{glm::vec3(0.6f, 0.0f, 0.8f), 0.9f}};

struct Walked {
  float missing = 0.0f;  ///< the share of several facets
  std::array<double, kCaps> light{};
};

Walked walkedToHighCaps(float roughness, glm::vec3 eye) {
  constexpr int kRays = 100'000;
  Walked walked;
  int several = 0;
  forEachWalk(roughness * roughness, eye.z, kRays, [&](const std::vector<float>& met, glm::vec3 w) {
    several += met.size() > 1 ? 1 : 0;
    for (std::size_t i = 0; i < kCaps; ++i) walked.light[i] += kHighCaps[i].holds(w) ? 1.0 / kRays : 0.0;
  });
  walked.missing = static_cast<float>(several) / kRays;
  return walked;
}

// As long as all of that light was spread evenly, lamps were up to 5 times too bright, and both of them as an
// environment 4 times.
TEST(MultipleScattering, LightsGrazedMetalAsRaysBetweenTheFacetsDo) {
  for (const float roughness : {0.2f, 0.3f, 0.45f})
    for (const float cosine : {0.05f, 0.1f}) {
      SCOPED_TRACE(std::to_string(roughness) + " at " + std::to_string(cosine));
      const glm::vec3 eye(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
      const Walked walked = walkedToHighCaps(roughness, eye);
      const formula::Surface s = whiteMetal(roughness, walked.missing, eye);
      double of_environment = 0.0;
      for (std::size_t i = 0; i < kCaps; ++i) {
        EXPECT_NEAR(litByLamp(s, eye, kHighCaps[i]), walked.light[i], 0.3 * walked.light[i]) << "lamp " << i;
        of_environment += litByEnvironment(s, eye, kHighCaps[i]);
      }
      const double of_both = walked.light[0] + walked.light[1];
      EXPECT_GT(of_environment, 0.5 * of_both);
      EXPECT_LT(of_environment, 2.0 * of_both);
    }
}

}  // namespace
}  // namespace mirrorball
