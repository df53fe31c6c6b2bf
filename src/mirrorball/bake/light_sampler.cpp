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

/// A table of running sums is searched from a place that one of so many equal parts of [0, 1] knows: about four steps
/// remain, in one line of the processor's cache ("guide table": Chen & Asau 1974).
constexpr std::size_t kGuides = 256;

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

/// For the beginning of each part of [0, 1], and for its end, the step of running sums in which it falls.
///
/// guide   kGuides + 1 values
void setGuide(std::span<const float> sums, std::span<std::uint16_t> guide) {
  std::size_t step = 0;
  for (std::size_t part = 0; part <= kGuides; ++part) {
    while (step + 1 < sums.size() && sums[step] <= float(part) / float(kGuides)) ++step;
    guide[part] = static_cast<std::uint16_t>(step);
  }
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
  sampler.sums_.resize((size + 1) * size);
  sampler.guides_.resize((size + 1) * (kGuides + 1));
  const auto fill = [&](std::size_t table, std::span<const double> weights) {
    const std::span<float> sums = std::span(sampler.sums_).subspan(table * size, size);
    const double all = accumulate(weights, sums);
    setGuide(sums, std::span(sampler.guides_).subspan(table * (kGuides + 1), kGuides + 1));
    return all;
  };
  std::vector<double> row_sums(size);
  parallelFor(size, 16, [&](std::size_t begin, std::size_t end) {
    std::vector<double> weights(size);
    for (std::size_t y = begin; y < end; ++y) {
      for (std::size_t x = 0; x < size; ++x)
        weights[x] = uniform_weight +
                     double(withNeighbours(brightness, sampler.size_, static_cast<int>(x), static_cast<int>(y)));
      row_sums[y] = fill(y, weights);
    }
  });
  fill(size, row_sums);
  return sampler;
}

/// The step of a table's sums in which u falls; u becomes the place within it, from 0 to below 1.
int LightSampler::stepOf(std::size_t table, float& u) const {
  const float* const sums = sums_.data() + table * std::size_t(size_);
  const std::size_t part = std::min(std::size_t(u * float(kGuides)), kGuides - 1);  // also where rounding made u 1
  const std::uint16_t* const guide = guides_.data() + table * (kGuides + 1) + part;
  const float* const found = std::upper_bound(sums + guide[0], sums + guide[1], u);
  const float begin = found > sums ? found[-1] : 0.0f;
  u = std::clamp((u - begin) / std::max(*found - begin, 1e-20f), 0.0f, 0x1.fffffep-1f);
  return static_cast<int>(found - sums);
}

LightSample LightSampler::sample(glm::vec2 u) const {
  const int y = stepOf(std::size_t(size_), u.y);
  const int x = stepOf(std::size_t(y), u.x);
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
  const auto tableOf = [this](int table) { return sums_.data() + std::ptrdiff_t(table) * size_; };
  return share(tableOf(size_), y) * share(tableOf(y), x) * texels / (2.0f * formula::kTwoPi);
}

}  // namespace mirrorball
