#include "mirrorball/bake/bright_lights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr float kBright = 8.0f;  // times the mean

/// Where a texel is, by its number from the first face's first row on.
struct Candidate {
  float brightness;
  std::size_t index;
};

float brightnessOf(glm::vec3 light) { return std::max({light.x, light.y, light.z}); }

/// Calls `visit(row number over all faces, image, y)` on all cores.
template <typename Visit>
void forEachRow(const EnvironmentMap& map, const Visit& visit) {
  const auto height = static_cast<std::size_t>(map.extent().y);
  parallelFor(height * static_cast<std::size_t>(map.faces()), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      visit(row, map.face(static_cast<int>(row / height)), static_cast<int>(row % height));
  });
}

/// What a row's texels weigh beside those of other rows: in a panorama they are narrow near the poles.
float weightOfRow(const EnvironmentMap& map, int row) {
  if (map.projection() != Projection::equirect) return 1.0f;
  return std::sin(std::numbers::pi_v<float> * (static_cast<float>(row) + 0.5f) / static_cast<float>(map.size()));
}

float meanBrightness(const EnvironmentMap& map) {
  const auto width = map.extent().x;
  std::vector<double> sums(static_cast<std::size_t>(map.extent().y * map.faces()));
  forEachRow(map, [&](std::size_t row, const Image& image, int y) {
    float sum = 0.0f;
    for (int x = 0; x < width; ++x) sum += brightnessOf(rgbAt(image, x, y));
    sums[row] = static_cast<double>(sum * weightOfRow(map, y));
  });
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t row = 0; row < sums.size(); ++row) {
    sum += sums[row];
    weights += static_cast<double>(weightOfRow(map, static_cast<int>(row % std::size_t(map.extent().y))));
  }
  return static_cast<float>(sum / (weights * width));
}

/// All texels that are brighter than `least`, in their order.
std::vector<Candidate> brightCandidates(const EnvironmentMap& map, float least) {
  const auto width = static_cast<std::size_t>(map.extent().x);
  std::vector<std::vector<Candidate>> rows(static_cast<std::size_t>(map.extent().y * map.faces()));
  forEachRow(map, [&](std::size_t row, const Image& image, int y) {
    for (std::size_t x = 0; x < width; ++x) {
      const float brightness = brightnessOf(rgbAt(image, static_cast<int>(x), y));
      if (brightness > least) rows[row].push_back({brightness, row * width + x});
    }
  });
  std::vector<Candidate> all;
  for (const std::vector<Candidate>& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// How many texels of a row share a point of light.
int texelsOfPoint(const EnvironmentMap& map, int row) {
  return std::max(static_cast<int>(0.25f / weightOfRow(map, row)), 1);
}

/// Where a candidate lies.
struct Place {
  int face;
  glm::ivec2 texel;

  Place(const EnvironmentMap& map, std::size_t index) {
    const auto width = static_cast<std::size_t>(map.extent().x);
    const std::size_t texels = width * static_cast<std::size_t>(map.extent().y);
    face = static_cast<int>(index / texels);
    texel = glm::ivec2(index % texels % width, index % texels / width);
  }
};

/// Keeps the brightest, as many as make `most` points.
///
/// returns  the brightness of the first that is left out, or `least`
float keepBrightest(const EnvironmentMap& map, int most, float least, std::vector<Candidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.brightness != b.brightness ? a.brightness > b.brightness : a.index < b.index;
  });
  float points = 0.0f;
  std::size_t kept = 0;
  for (; kept < candidates.size(); ++kept) {
    points += 1.0f / static_cast<float>(texelsOfPoint(map, Place(map, candidates[kept].index).texel.y));
    if (points > static_cast<float>(most)) break;
  }
  const float rest = kept < candidates.size() ? candidates[kept].brightness : least;
  candidates.resize(kept);
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.index < b.index; });
  return rest;
}

/// Adds a texel's light to the point of its neighbours, or begins another.
void addToPoints(const EnvironmentMap& map, const Excess& excess, bool is_with_last,
                 std::vector<PointOfLight>& points) {
  const glm::vec2 uv = (glm::vec2(excess.texel) + 0.5f) / glm::vec2(map.extent());
  const glm::vec3 direction = directionAt(map.projection(), {excess.face, uv});
  const glm::vec3 flux = excess.radiance * texelSolidAngle(map.projection(), map.extent(), excess.texel);
  if (!is_with_last) {
    points.push_back({direction, flux});
    return;
  }
  // The middle of the light.
  PointOfLight& point = points.back();
  point.direction = glm::normalize(point.direction * brightnessOf(point.flux) + direction * brightnessOf(flux));
  point.flux += flux;
}

}  // namespace

BrightLights brightLights(const EnvironmentMap& map, int most) {
  const float least = kBright * meanBrightness(map);
  std::vector<Candidate> candidates = brightCandidates(map, least);
  const float rest = keepBrightest(map, most, least, candidates);
  BrightLights lights;
  glm::ivec3 last_group(-1);
  for (const Candidate& candidate : candidates) {
    const float share = 1.0f - rest / candidate.brightness;
    if (share <= 0.0f) continue;
    const Place place(map, candidate.index);
    const Excess excess{place.face, place.texel, rgbAt(map.face(place.face), place.texel.x, place.texel.y) * share};
    const glm::ivec3 group(place.face, place.texel.y, place.texel.x / texelsOfPoint(map, place.texel.y));
    addToPoints(map, excess, group == last_group, lights.points);
    lights.texels.push_back(excess);
    last_group = group;
  }
  return lights;
}

void subtract(const BrightLights& lights, EnvironmentMap& map) {
  for (const Excess& excess : lights.texels) {
    Image& image = map.face(excess.face);
    float* samples = image.texel(excess.texel.x, excess.texel.y);
    for (int c = 0; c < std::min(image.channels(), 3); ++c) samples[c] -= excess.radiance[c];
  }
}

}  // namespace mirrorball
