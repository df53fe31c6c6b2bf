#include "mirrorball/bake/bright_texels.h"

#include <algorithm>
#include <cstddef>

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

/// Calls `visit(row number over all faces, brightness of each texel)` on all cores.
template <typename Visit>
void forEachRow(const EnvironmentMap& map, const Visit& visit) {
  const auto height = static_cast<std::size_t>(map.extent().y);
  parallelFor(height * static_cast<std::size_t>(map.faces()), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      visit(row, map.face(static_cast<int>(row / height)), static_cast<int>(row % height));
  });
}

float meanBrightness(const EnvironmentMap& map) {
  const auto width = map.extent().x;
  std::vector<double> sums(static_cast<std::size_t>(map.extent().y * map.faces()));
  forEachRow(map, [&](std::size_t row, const Image& image, int y) {
    float sum = 0.0f;
    for (int x = 0; x < width; ++x) sum += brightnessOf(rgbAt(image, x, y));
    sums[row] = static_cast<double>(sum);
  });
  double sum = 0.0;
  for (const double of_row : sums) sum += of_row;
  return static_cast<float>(sum / (static_cast<double>(width) * static_cast<double>(sums.size())));
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

}  // namespace

BrightTexels brightTexels(const EnvironmentMap& map, int most) {
  float rest = kBright * meanBrightness(map);
  std::vector<Candidate> candidates = brightCandidates(map, rest);
  const auto count = static_cast<std::size_t>(most);
  if (candidates.size() > count) {
    const auto last = candidates.begin() + most;
    std::nth_element(candidates.begin(), last, candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.brightness != b.brightness ? a.brightness > b.brightness : a.index < b.index;
    });
    rest = last->brightness;
    candidates.resize(count);
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.index < b.index; });
  }

  BrightTexels texels;
  const glm::ivec2 extent = map.extent();
  const auto width = static_cast<std::size_t>(extent.x);
  const auto face_texels = width * static_cast<std::size_t>(extent.y);
  for (const Candidate& candidate : candidates) {
    const float excess = 1.0f - rest / candidate.brightness;
    if (excess <= 0.0f) continue;
    const std::size_t in_face = candidate.index % face_texels;
    const glm::ivec2 texel(in_face % width, in_face / width);
    const int face = static_cast<int>(candidate.index / face_texels);
    const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / glm::vec2(extent);
    texels.push_back({face, texel, directionAt(map.projection(), {face, uv}),
                      rgbAt(map.face(face), texel.x, texel.y) * excess,
                      texelSolidAngle(map.projection(), extent, texel)});
  }
  return texels;
}

void subtract(const BrightTexels& texels, EnvironmentMap& map) {
  for (const BrightTexel& bright : texels) {
    Image& image = map.face(bright.face);
    float* samples = image.texel(bright.texel.x, bright.texel.y);
    for (int c = 0; c < std::min(image.channels(), 3); ++c) samples[c] -= bright.radiance[c];
  }
}

}  // namespace mirrorball
