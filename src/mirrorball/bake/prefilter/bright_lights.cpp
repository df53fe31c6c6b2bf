#include "mirrorball/bake/prefilter/bright_lights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

constexpr float kBright = 8.0f;  // times the mean

/// Where a texel is, by its number from the first face's first row on.
struct Candidate {
  float brightness;
  std::size_t index;
};

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

/// What is known of each row over all faces before single texels are looked for.
struct RowBrightness {
  float sum = 0.0f;
  float max = 0.0f;
};

std::vector<RowBrightness> brightnessOfRows(const EnvironmentMap& map) {
  std::vector<RowBrightness> rows(static_cast<std::size_t>(map.extent().y * map.faces()));
  forEachRow(map, [&](std::size_t row, const Image& image, int y) {
    RowBrightness of_row;
    for (int x = 0; x < image.width(); ++x) {
      const float brightness = brightnessOf(rgbAt(image, x, y));
      of_row.sum += brightness;
      of_row.max = std::max(of_row.max, brightness);
    }
    rows[row] = of_row;
  });
  return rows;
}

/// All texels that are brighter than `min`, in their order.
std::vector<Candidate> brightCandidates(const EnvironmentMap& map, const std::vector<RowBrightness>& rows, float min) {
  const auto width = static_cast<std::size_t>(map.extent().x);
  std::vector<std::vector<Candidate>> found(rows.size());
  forEachRow(map, [&](std::size_t row, const Image& image, int y) {
    if (rows[row].max <= min) return;
    for (std::size_t x = 0; x < width; ++x) {
      const float brightness = brightnessOf(rgbAt(image, static_cast<int>(x), y));
      if (brightness > min) found[row].push_back({brightness, row * width + x});
    }
  });
  std::vector<Candidate> all;
  for (const std::vector<Candidate>& row : found) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// The mean brightness of a map, of all that is brighter than `max` only so much.
float meanBrightness(const EnvironmentMap& map, const std::vector<RowBrightness>& rows, float max) {
  const auto height = static_cast<std::size_t>(map.extent().y);
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto weight = static_cast<double>(weightOfRow(map, static_cast<int>(row % height)));
    sum += weight * static_cast<double>(rows[row].sum);
    weights += weight;
  }
  for (const Candidate& bright : brightCandidates(map, rows, max))
    sum -= static_cast<double>(weightOfRow(map, Place(map, bright.index).texel.y) * (bright.brightness - max));
  return static_cast<float>(sum / (weights * map.extent().x));
}

/// How many texels of a row share a point of light.
int texelsOfPoint(const EnvironmentMap& map, int row) {
  return std::max(static_cast<int>(0.25f / weightOfRow(map, row)), 1);
}

bool isBrighter(const Candidate& a, const Candidate& b) {
  return a.brightness != b.brightness ? a.brightness > b.brightness : a.index < b.index;
}

/// Keeps the brightest, as many as make `max` points.
///
/// returns  the brightness of the first that is left out, or nothing
std::optional<float> keepBrightest(const EnvironmentMap& map, int max, std::vector<Candidate>& candidates) {
  float points = 0.0f;
  std::size_t kept = 0;
  for (std::size_t sorted = 0; kept < candidates.size(); ++kept) {
    if (kept == sorted) {
      const auto begin = candidates.begin() + static_cast<std::ptrdiff_t>(sorted);
      sorted = std::min(sorted + static_cast<std::size_t>(max) + 1, candidates.size());
      std::partial_sort(begin, candidates.begin() + static_cast<std::ptrdiff_t>(sorted), candidates.end(), isBrighter);
    }
    points += 1.0f / static_cast<float>(texelsOfPoint(map, Place(map, candidates[kept].index).texel.y));
    if (points > static_cast<float>(max)) break;
  }
  std::optional<float> rest;
  if (kept < candidates.size()) rest = candidates[kept].brightness;
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

BrightLights brightLights(const EnvironmentMap& map, int max) {
  const std::vector<RowBrightness> rows = brightnessOfRows(map);
  // The mean of a dark map with a lamp is the lamp's, which is no measure of what stands out.
  const float with_lamps = meanBrightness(map, rows, std::numeric_limits<float>::infinity());
  const float min = kBright * meanBrightness(map, rows, kBright * with_lamps);
  std::vector<Candidate> candidates = brightCandidates(map, rows, min);
  const std::optional<float> left_out = keepBrightest(map, max, candidates);
  const float rest = left_out.value_or(min);
  BrightLights lights;
  lights.is_complete = !left_out;
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
