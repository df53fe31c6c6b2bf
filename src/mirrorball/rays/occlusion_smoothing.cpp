#include "mirrorball/rays/occlusion_smoothing.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr float kAlike = 0.8f;  ///< the cosine between the normals of patches that count for each other, at least
/// What spreading may change of the share of the sky that is open.
constexpr float kHarmless = 0.005f;
/// How far what is known may be spread at most, over the distance of what is seen.
constexpr float kFarthest = 0.5f;
/// Of so many rays together the noise is not seen; a round makes some three times as many.
constexpr float kFewestRays = 64.0f;
constexpr float kEnoughRays = 1024.0f;
/// Of what shines, since chosen places tell of it with less noise, and of what is small and near.
constexpr float kEnoughForEmission = 256.0f;
constexpr float kGainOfRound = 3.0f;
constexpr float kMostMeans = 24.0f;

bool areAlike(const VertexPatches& patches, std::size_t a, std::size_t b) {
  return glm::dot(patches.normal(a), patches.normal(b)) >= kAlike;
}

/// How many rounds of means with its neighbours a patch takes until the noise of its rays is not seen.
float roundsUntil(float wanted_rays, std::size_t rays) {
  return std::clamp((wanted_rays / static_cast<float>(rays) - 1.0f) / kGainOfRound, 0.0f, kMostMeans);
}

/// How many rounds change little of what is true: so many spread what is known over their square root times the
/// distance of neighbours. The share s of the sky that something at the distance d hides curves by about s / d².
float harmlessRounds(const VertexPatches& patches, std::size_t patch, std::span<const VertexOcclusion> found,
                     std::span<const float> nearness) {
  float between = 0.0f, near = nearness[patch], hidden = 1.0f - found[patch].open, neighbours = 0.0f;
  for (const std::uint32_t next : patches.beside(patch)) {
    if (!areAlike(patches, patch, next)) continue;
    between += glm::distance(patches.center(patch), patches.center(next));
    near += nearness[next];
    hidden += 1.0f - found[next].open;
    ++neighbours;
  }
  if (neighbours == 0.0f) return 0.0f;
  if (near == 0.0f) return kMostMeans;
  const float distance = hidden / near;
  hidden /= neighbours + 1.0f;
  const float reached = distance * std::min(std::sqrt(2.0f * kHarmless / hidden), kFarthest);
  return std::min(std::pow(reached * neighbours / std::max(between, 1e-30f), 2.0f), kMostMeans);
}

VertexOcclusion meanWithNeighbours(const VertexPatches& patches, std::span<const VertexOcclusion> found,
                                   std::size_t patch) {
  VertexOcclusion sum = found[patch];
  float count = 1.0f;
  for (const std::uint32_t beside : patches.beside(patch)) {
    if (!areAlike(patches, patch, beside)) continue;
    addTo(sum, found[beside], 1.0f);
    ++count;
  }
  VertexOcclusion mean{.open = 0.0f};
  addTo(mean, sum, 1.0f / count);
  return mean;
}

VertexOcclusion between(const VertexOcclusion& first, const VertexOcclusion& second, float share) {
  VertexOcclusion sum{.open = 0.0f};
  addTo(sum, first, 1.0f - share);
  addTo(sum, second, share);
  return sum;
}

}  // namespace

void addTo(VertexOcclusion& sum, const VertexOcclusion& each, float times) {
  sum.occluded += times * each.occluded;
  sum.open += times * each.open;
  sum.interreflected += times * each.interreflected;
  sum.lit_from += times * each.lit_from;
  sum.emitted += times * each.emitted;
}

void smoothOcclusion(const VertexPatches& patches, std::span<const std::size_t> rays, std::span<const float> nearness,
                     std::vector<VertexOcclusion>& found) {
  constexpr std::size_t kGrain = 1024;
  std::vector<float> rounds(found.size());
  parallelFor(found.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      rounds[i] = std::clamp(harmlessRounds(patches, i, found, nearness), roundsUntil(kFewestRays, rays[i]),
                             roundsUntil(kEnoughRays, rays[i]));
  });
  const float most = found.empty() ? 0.0f : *std::max_element(rounds.begin(), rounds.end());
  std::vector<VertexOcclusion> next(found.size());
  for (int round = 0; static_cast<float>(round) < most; ++round) {
    parallelFor(found.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto mixShare = [&](float until) { return std::clamp(until - static_cast<float>(round), 0.0f, 1.0f); };
        const float share = mixShare(rounds[i]);
        next[i] = found[i];
        if (share == 0.0f) continue;
        const VertexOcclusion mean = meanWithNeighbours(patches, found, i);
        next[i] = between(found[i], mean, share);
        const float of_emission = std::min(share, mixShare(roundsUntil(kEnoughForEmission, rays[i])));
        next[i].emitted = glm::mix(found[i].emitted, mean.emitted, of_emission);
      }
    });
    found.swap(next);
  }
}

}  // namespace mirrorball
