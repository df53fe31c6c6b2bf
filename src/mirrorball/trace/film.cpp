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

double pathsIn(const PixelSums& sums) { return double(std::max(sums.paths, 1)); }

glm::dvec4 meanOf(const PixelSums& sums) { return sums.light / pathsIn(sums); }

/// Of the mean of a pixel's paths, as if they were independent.
glm::dvec4 varianceOfMean(const PixelSums& sums) {
  const glm::dvec4 mean = meanOf(sums);
  const glm::dvec4 variance = glm::max(sums.squares / pathsIn(sums) - mean * mean, glm::dvec4(0.0));
  return variance / std::max(pathsIn(sums) - 1.0, 1.0);
}

/// Half of what a display shows between two radiances, the mean of their channels. Where it is beyond what the tone
/// curve can tell, that of white beside black.
float displayedHalf(glm::dvec3 less, glm::dvec3 more, const Display& display) {
  const glm::vec3 change = displayed(glm::vec3(more), display) - displayed(glm::vec3(less), display);
  const float shown = (std::abs(change.x) + std::abs(change.y) + std::abs(change.z)) / 6.0f;
  return std::isfinite(shown) ? shown : 1.0f;
}

/// A standard error as it is displayed: that of the radiance, on the slope of the tone curve, or that of what alpha
/// leaves of a white page, as of a shadow that stands alone.
float displayedError(glm::dvec4 mean, glm::dvec4 variance, const Display& display) {
  const glm::dvec4 error = glm::sqrt(variance);
  const glm::dvec3 light(mean);
  const glm::dvec3 of_light(error);
  const float shown = displayedHalf(light - of_light, light + of_light, display);
  if (error.w == 0.0) return shown;
  const double left = 1.0 - mean.w;
  return std::max(shown, displayedHalf(glm::dvec3(left - error.w), glm::dvec3(left + error.w), display));
}

}  // namespace

int PathCounts::at(std::size_t pixel) const {
  if (shares.empty()) return least;
  return static_cast<int>(std::clamp(shares[pixel] * scale, float(least), float(most)));
}

Film::Film(glm::ivec2 size, int halves, const std::optional<glm::vec3>& page)
    : size_(size),
      page_(page),
      halves_(std::size_t(halves), std::vector<PixelSums>(std::size_t(size.x) * std::size_t(size.y))),
      shows_(halves_.front().size()) {}

void Film::addPass(const FilmPass& pass, int half, const PathCounts& counts) {
  std::vector<PixelSums>& sums = halves_[std::size_t(half)];
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const PixelSums& added = pass.sums()[i];
    sums[i].light += added.light;
    sums[i].squares += added.squares;
    sums[i].albedo += added.albedo;
    sums[i].normal += added.normal;
    sums[i].paths = std::max(sums[i].paths, counts.at(i));
    if (added.paths > 0) shows_[i] = true;
    sums[i].lost += added.lost;
  }
}

std::uint64_t Film::paths() const {
  std::uint64_t paths = 0;
  for (const auto& half : halves_)
    for (const PixelSums& sums : half) paths += static_cast<std::uint64_t>(sums.paths);
  return paths;
}

std::uint64_t Film::lost() const {
  std::uint64_t lost = 0;
  for (const auto& half : halves_)
    for (const PixelSums& sums : half) lost += static_cast<std::uint64_t>(sums.lost);
  return lost;
}

/// Of those halves that have paths there.
template <typename Value>
auto Film::meanOfHalves(std::size_t pixel, const Value& value) const {
  auto sum = value(halves_.front()[pixel]);
  if (halves_.size() == 1 || halves_.back()[pixel].paths == 0) return sum;
  sum += value(halves_.back()[pixel]);
  sum /= 2;
  return sum;
}

glm::dvec4 Film::varianceAt(std::size_t pixel) const {
  const bool has_two = halves_.size() == 2 && halves_.back()[pixel].paths > 0;
  return meanOfHalves(pixel, varianceOfMean) / (has_two ? 2.0 : 1.0);
}

float Film::noise(const Display& display) const {
  std::vector<double> rows(static_cast<std::size_t>(size_.y));
  parallelFor(rows.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (std::size_t i = y * std::size_t(size_.x); i < (y + 1) * std::size_t(size_.x); ++i)
        rows[y] += double(displayedError(meanOfHalves(i, meanOf), varianceAt(i), display));
  });
  const auto shown = std::count(shows_.begin(), shows_.end(), true);
  return static_cast<float>(std::accumulate(rows.begin(), rows.end(), 0.0) /
                            double(std::max<std::ptrdiff_t>(shown, 1)));
}

std::vector<float> Film::errorsOf(int half, const Display& display) const {
  const std::vector<PixelSums>& sums = halves_[std::size_t(half)];
  std::vector<float> errors(sums.size());
  parallelFor(errors.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      errors[i] = displayedError(meanOf(sums[i]), varianceOfMean(sums[i]), display);
  });
  return errors;
}

Image Film::radiance() const {
  return imageOf<4>([this](std::size_t i) {
    glm::vec4 mean(meanOfHalves(i, meanOf));
    mean.w = glm::clamp(mean.w, 0.0f, 1.0f);  // a path may find more light in a shadow than without it
    return page_ && shows_[i] ? glm::vec4(glm::vec3(mean) + (1.0f - mean.w) * *page_, 1.0f) : mean;
  });
}

Image Film::albedo() const {
  return imageOf<3>([this](std::size_t i) {
    return meanOfHalves(i, [](const PixelSums& sums) { return glm::vec3(sums.albedo) / float(pathsIn(sums)); });
  });
}

Image Film::normal() const {
  return imageOf<3>([this](std::size_t i) {
    return meanOfHalves(i, [](const PixelSums& sums) { return glm::vec3(sums.normal) / float(pathsIn(sums)); });
  });
}

Image Film::variance() const {
  return imageOf<3>([this](std::size_t i) { return glm::vec3(varianceAt(i)); });
}

template <int Channels, typename Value>
Image Film::imageOf(const Value& value) const {
  Image image(size_.x, size_.y, Channels);
  for (std::size_t i = 0; i < halves_.front().size(); ++i) {
    const glm::vec<Channels, float> texel = value(i);
    std::copy_n(&texel.x, Channels, image.samples().data() + Channels * i);
  }
  return image;
}

}  // namespace mirrorball
