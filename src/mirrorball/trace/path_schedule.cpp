#include "mirrorball/trace/path_schedule.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>

namespace mirrorball {
namespace {

/// The most paths of a pixel that a pass adds, in the mean of all: what an interruption, or a limit of the time, may
/// cost.
constexpr int kLargestPass = 128;

/// Of each half, everywhere.
constexpr int kFirstPaths = kMinPathsForNoise / 2;

/// Deviations are those of so many pixels in each direction together, since those of few paths are not well known.
constexpr int kReach = 2;

/// No pixel's deviation counts as less than this share of the mean: a caustic may have been missed by all first paths.
constexpr float kLeastDeviation = 0.1f;

/// The means of a line of values and of those around each, which lie `step` apart.
void smoothLine(const float* values, std::size_t step, int count, float* smooth) {
  for (int i = 0; i < count; ++i) {
    const int begin = std::max(i - kReach, 0), end = std::min(i + kReach, count - 1);
    float sum = 0.0f;
    for (int j = begin; j <= end; ++j) sum += values[std::size_t(j) * step];
    smooth[std::size_t(i) * step] = sum / float(end - begin + 1);
  }
}

/// The shares of paths for one half, whose mean is 1, by the errors that the other half has.
std::vector<float> sharesFrom(const std::vector<float>& errors, glm::ivec2 size) {
  std::vector<float> squares(errors.size()), rows(errors.size());
  std::transform(errors.begin(), errors.end(), squares.begin(), [](float error) { return error * error; });
  const auto width = std::size_t(size.x);
  for (int y = 0; y < size.y; ++y)
    smoothLine(squares.data() + std::size_t(y) * width, 1, size.x, rows.data() + std::size_t(y) * width);
  for (int x = 0; x < size.x; ++x) smoothLine(rows.data() + x, width, size.y, squares.data() + x);
  const auto meanOf = [](const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  };
  std::vector<float>& shares = squares;
  for (float& square : squares) square = std::sqrt(square);
  const auto least = static_cast<float>(double(kLeastDeviation) * meanOf(shares));
  for (float& share : shares) share = std::pow(std::max(share, least), 2.0f / 3.0f);
  const auto mean = static_cast<float>(meanOf(shares));
  for (float& share : shares) share = mean > 0.0f ? share / mean : 1.0f;
  return shares;
}

/// How many paths there are in both halves together.
std::uint64_t pathsOf(const std::array<PathCounts, 2>& counts) {
  std::uint64_t paths = 0;
  for (const PathCounts& half : counts)
    for (std::size_t pixel = 0; pixel < half.shares.size(); ++pixel) paths += std::uint64_t(half.at(pixel));
  return paths;
}

}  // namespace

bool traceEvenly(const Film& film, const TraceSettings& settings, const DrawPass& draw, const GoesOn& goesOn) {
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t pixels = std::uint64_t(film.size().x) * std::uint64_t(film.size().y);
  const int most = std::max(settings.samples, 1);
  int done = 0;
  int expected = most;
  while (done < most) {
    const int next = done + std::min({std::max(done, 1), kLargestPass, most - done});
    if (!draw(0, {.least = next}, pixels * std::uint64_t(std::max(expected, next)))) return false;
    done = next;
    if (!goesOn()) return true;
    const std::chrono::duration<float> elapsed = std::chrono::steady_clock::now() - start;
    if (settings.time_s > 0.0f)
      expected = static_cast<int>(std::min(double(most), double(done) * double(settings.time_s / elapsed.count())));
  }
  return true;
}

bool traceToNoise(const Film& film, const TraceSettings& settings, const DrawPass& draw, const GoesOn& goesOn) {
  const std::uint64_t pixels = std::uint64_t(film.size().x) * std::uint64_t(film.size().y);
  for (int count = 1; count <= kFirstPaths; count *= 2) {
    for (const int half : {0, 1})
      if (!draw(half, {.least = count}, pixels * kMinPathsForNoise)) return false;  // at least so many
    if (!goesOn()) return true;
  }
  const int most = settings.samples / 2;
  std::array<PathCounts, 2> counts;
  for (const int half : {0, 1})
    counts[std::size_t(half)] = {kFirstPaths, most, sharesFrom(film.errorsOf(1 - half, settings.display), film.size())};
  float scale = float(kFirstPaths);
  while (pathsOf(counts) < 2 * pixels * std::uint64_t(most)) {
    const float noise = film.noise(settings.display);
    if (noise <= settings.noise) return true;
    // Errors fall with the root of the number of paths; of how many, few paths tell only roughly.
    constexpr float kLeastGrowth = 1.1f, kMostGrowth = 4.0f;
    const float wanted = noise / settings.noise * (noise / settings.noise);
    const float before = scale;
    scale = std::min(scale * std::clamp(wanted, kLeastGrowth, kMostGrowth), scale + float(kLargestPass / 2));
    for (PathCounts& half : counts) half.scale = scale;
    const double later = std::max(double(wanted * before / scale), 1.0);  // times as many in the end
    const auto expected =
        static_cast<std::uint64_t>(std::min(double(pathsOf(counts)) * later, 2.0 * double(pixels) * double(most)));
    for (const int half : {0, 1})
      if (!draw(half, counts[std::size_t(half)], expected)) return false;
    if (!goesOn()) return true;
  }
  return true;
}

}  // namespace mirrorball
