#include "mirrorball/trace/film.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// What a display shows of radiance, encoded.
glm::vec3 displayed(glm::vec3 radiance, const Display& display) {
  const glm::vec4 light(glm::max(radiance, glm::vec3(0.0f)), 1.0f);
  return glm::vec3(formula::displayed(light, display.exposure(), static_cast<int>(display.tone_map)));
}

/// Of the mean of a pixel's paths, as if they were independent.
glm::dvec3 varianceOfMean(const PixelSums& sums, int samples) {
  const glm::dvec3 mean = glm::dvec3(sums.light) / double(samples);
  const glm::dvec3 variance = glm::max(sums.squares / double(samples) - mean * mean, glm::dvec3(0.0));
  return variance / double(std::max(samples - 1, 1));
}

/// The standard error of a pixel as it is displayed, the mean of its channels: that of the radiance, on the slope of
/// the tone curve.
float displayedError(const PixelSums& sums, int samples, const Display& display) {
  const glm::vec3 mean(glm::dvec3(sums.light) / double(samples));
  const glm::vec3 error(glm::sqrt(varianceOfMean(sums, samples)));
  const glm::vec3 change = displayed(mean + error, display) - displayed(mean - error, display);
  return (std::abs(change.x) + std::abs(change.y) + std::abs(change.z)) / 6.0f;
}

}  // namespace

void Film::addPass(const Film& pass, int count) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i].light += pass.sums_[i].light;
    sums_[i].squares += pass.sums_[i].squares;
    sums_[i].albedo += pass.sums_[i].albedo;
    sums_[i].normal += pass.sums_[i].normal;
    sums_[i].paths += pass.sums_[i].paths;
    sums_[i].lost += pass.sums_[i].lost;
  }
  samples_ += count;
}

float Film::noise(const Display& display) const {
  std::vector<double> rows(static_cast<std::size_t>(size_.y));
  parallelFor(rows.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t x = 0; x < std::size_t(size_.x); ++x)
        rows[y] += double(displayedError(sums_[y * std::size_t(size_.x) + x], samples_, display));
  });
  const auto shown = std::count_if(sums_.begin(), sums_.end(), [](const PixelSums& sums) { return sums.paths > 0; });
  return static_cast<float>(std::accumulate(rows.begin(), rows.end(), 0.0) /
                            double(std::max<std::ptrdiff_t>(shown, 1)));
}

std::uint64_t Film::lost() const {
  std::uint64_t lost = 0;
  for (const PixelSums& sums : sums_) lost += static_cast<std::uint64_t>(sums.lost);
  return lost;
}

Image Film::radiance() const {
  return imageOf<4>([&](const PixelSums& sums) { return glm::vec4(sums.light / double(samples_)); });
}

Image Film::albedo() const {
  return imageOf<3>([&](const PixelSums& sums) { return sums.albedo / float(samples_); });
}

Image Film::normal() const {
  return imageOf<3>([&](const PixelSums& sums) { return sums.normal / float(samples_); });
}

Image Film::variance() const {
  return imageOf<3>([&](const PixelSums& sums) { return glm::vec3(varianceOfMean(sums, samples_)); });
}

template <int Channels, typename Value>
Image Film::imageOf(const Value& value) const {
  Image image(size_.x, size_.y, Channels);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const glm::vec<Channels, float> texel = value(sums_[i]);
    std::copy_n(&texel.x, Channels, image.samples().data() + Channels * i);
  }
  return image;
}

}  // namespace mirrorball
