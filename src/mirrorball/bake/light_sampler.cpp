#include "mirrorball/bake/light_sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "formula/color.h"
#include "formula/constants.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

/// A part of the choices is uniform, so that no light is left out that the map is too coarse for.
constexpr double kUniformShare = 0.01;

/// The luminance of each texel, from the first row on.
std::vector<float> brightnessOf(const Image& light) {
  std::vector<float> brightness;
  brightness.reserve(std::size_t(light.width()) * std::size_t(light.height()));
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x)
      brightness.push_back(formula::luminance(glm::max(rgbAt(light, x, y), glm::vec3(0.0f))));
  return brightness;
}

/// A texel's luminance, or a quarter of its brightest neighbour's: a lamp whose edge runs through the texel may be
/// missed by its centre, and would then be found by so few paths that they stand out as bright pixels.
float withNeighbours(const std::vector<float>& brightness, int size, int x, int y) {
  float max = 4.0f * brightness[std::size_t(y) * std::size_t(size) + std::size_t(x)];
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size - 1); ++i)
      max = std::max(max, brightness[std::size_t(j) * std::size_t(size) + std::size_t(i)]);
  return max / 4.0f;
}

/// Makes running sums of weights that end at 1; equal ones where all are 0.
///
/// returns  the sum
double accumulate(std::span<const double> weights, std::span<float> sums) {
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  double running = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    running += sum > 0.0 ? weights[i] / sum : 1.0 / double(weights.size());
    sums[i] = static_cast<float>(running);
  }
  sums.back() = 1.0f;
  return sum;
}

/// The step of running sums in which u falls; u becomes the place within it, from 0 to below 1.
int stepOf(std::span<const float> sums, float& u) {
  const auto step =
      std::min<std::size_t>(std::size_t(std::upper_bound(sums.begin(), sums.end(), u) - sums.begin()), sums.size() - 1);
  const float begin = step > 0 ? sums[step - 1] : 0.0f;
  u = std::clamp((u - begin) / std::max(sums[step] - begin, 1e-20f), 0.0f, 0x1.fffffep-1f);
  return static_cast<int>(step);
}

}  // namespace

Result<LightSampler> LightSampler::make(const Environment& environment, const ProgressFunction& progress,
                                        int max_size) {
  LightSampler sampler;
  sampler.size_ = std::clamp(environment.naturalSize(Projection::equal_area), 1, max_size);
  const auto size = static_cast<std::size_t>(sampler.size_);
  MIRRORBALL_TRY(map, convert(environment, Projection::equal_area, sampler.size_, {}, progress));
  const std::vector<float> brightness = brightnessOf(map.face(0));
  const double sum = std::accumulate(brightness.begin(), brightness.end(), 0.0);
  sampler.mean_luminance_ = static_cast<float>(sum / double(size * size));
  const double uniform_weight = kUniformShare * sum / double(size * size);
  sampler.columns_.resize(size * size);
  std::vector<double> row_sums(size);
  parallelFor(size, 16, [&](std::size_t begin, std::size_t end) {
    std::vector<double> weights(size);
    for (std::size_t y = begin; y < end; ++y) {
      for (std::size_t x = 0; x < size; ++x)
        weights[x] = uniform_weight +
                     double(withNeighbours(brightness, sampler.size_, static_cast<int>(x), static_cast<int>(y)));
      row_sums[y] = accumulate(weights, std::span(sampler.columns_).subspan(y * size, size));
    }
  });
  sampler.rows_.resize(size);
  accumulate(row_sums, sampler.rows_);
  return sampler;
}

LightSample LightSampler::sample(glm::vec2 u) const {
  const auto size = static_cast<std::size_t>(size_);
  const int y = stepOf(rows_, u.y);
  const int x = stepOf(std::span(columns_).subspan(static_cast<std::size_t>(y) * size, size), u.x);
  const glm::vec2 place = (glm::vec2(x, y) + u) / float(size_);
  return {directionAt(Projection::equal_area, {0, place}), densityOf(x, y)};
}

float LightSampler::pdf(glm::vec3 direction) const {
  const glm::vec2 place = positionOf(Projection::equal_area, direction).uv * float(size_);
  const glm::ivec2 texel = glm::clamp(glm::ivec2(place), glm::ivec2(0), glm::ivec2(size_ - 1));
  return densityOf(texel.x, texel.y);
}

float LightSampler::densityOf(int x, int y) const {
  const auto share = [](const float* sums, int i) { return sums[i] - (i > 0 ? sums[i - 1] : 0.0f); };
  const float texels = float(size_) * float(size_);
  return share(rows_.data(), y) * share(columns_.data() + std::ptrdiff_t(y) * size_, x) * texels /
         (2.0f * formula::kTwoPi);
}

}  // namespace mirrorball
