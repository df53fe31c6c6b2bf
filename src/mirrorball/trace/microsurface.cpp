#include "mirrorball/trace/microsurface.h"

#include <algorithm>
#include <cmath>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

/// Smith's Λ for all directions: downwards Λ(w) = −1 − Λ(−w), which is −1 straight down.
float smithLambda(glm::vec2 alpha, glm::vec3 w) {
  const float upwards = formula::ggxLambda(alpha, w);
  return w.z >= 0.0f ? upwards : -1.0f - upwards;
}

/// The share of heights below this one. Never 0: from the deepest pit a ray must find a way on.
float shareBelow(float height) { return std::clamp(0.5f * (height + 1.0f), 1e-6f, 1.0f); }
float heightOfShare(float share) { return std::clamp(2.0f * share - 1.0f, -1.0f, 1.0f); }

}  // namespace

float escapeProbability(glm::vec2 alpha, glm::vec3 w, float height) {
  if (w.z <= 0.0f) return 0.0f;
  return std::pow(shareBelow(height), formula::ggxLambda(alpha, w));
}

float heightOfNextFacet(glm::vec2 alpha, glm::vec3 w, float height, float u) {
  constexpr float kStraight = 0.9999f;
  constexpr float kLevel = 1e-4f;
  if (w.z < -kStraight) return heightOfShare(u * shareBelow(height));
  if (w.z > kStraight || std::abs(w.z) < kLevel) return height;
  // Upwards the probability to get as high as h is (C(height) / C(h))^Λ, downwards with Λ < 0 the same. Of the rays
  // that meet a facet at all, it ends at the probability to escape.
  const float gets_there = 1.0f - u * (1.0f - escapeProbability(alpha, w, height));
  return heightOfShare(shareBelow(height) / std::pow(gets_there, 1.0f / smithLambda(alpha, w)));
}

float densityOfMetFacets(glm::vec2 alpha, glm::vec3 w, glm::vec3 h) {
  // The area of facets that is seen along w: the cosine for what the surface shows, and Λ for what facets hide.
  const float seen = w.z >= 0.0f ? w.z * (1.0f + formula::ggxLambda(alpha, w)) : -w.z * formula::ggxLambda(alpha, w);
  const float cosine = glm::dot(w, h);
  if (seen <= 0.0f || cosine <= 0.0f) return 0.0f;
  return cosine * formula::ggxDistribution(alpha, h) / seen;
}

}  // namespace mirrorball
