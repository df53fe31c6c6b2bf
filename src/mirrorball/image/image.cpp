#include "mirrorball/image/image.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

bool isFinite(const Image& image, int x, int y) {
  const float* texel = image.texel(x, y);
  for (int channel = 0; channel < image.channels(); ++channel)
    if (!std::isfinite(texel[channel])) return false;
  return true;
}

/// The mean of the finite ones among the eight neighbours of (x, y); nothing when there is none.
std::optional<glm::vec4> meanOfNeighbours(const Image& image, int x, int y) {
  glm::vec4 sum(0.0f);
  int count = 0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, image.height() - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, image.width() - 1); ++i) {
      if (!isFinite(image, i, j)) continue;
      for (int channel = 0; channel < image.channels(); ++channel) sum[channel] += image.texel(i, j)[channel];
      ++count;
    }
  if (count == 0) return {};
  return sum / static_cast<float>(count);
}

/// The texels that are not finite among the neighbours of some that are, each once.
std::vector<glm::ivec2> holesBeside(const Image& image, const std::vector<std::pair<glm::ivec2, glm::vec4>>& mended) {
  std::vector<glm::ivec2> holes;
  for (const auto& [texel, mean] : mended)
    for (int y = std::max(texel.y - 1, 0); y <= std::min(texel.y + 1, image.height() - 1); ++y)
      for (int x = std::max(texel.x - 1, 0); x <= std::min(texel.x + 1, image.width() - 1); ++x)
        if (!isFinite(image, x, y)) holes.push_back({x, y});
  const auto byRow = [](glm::ivec2 a, glm::ivec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  std::sort(holes.begin(), holes.end(), byRow);
  holes.erase(std::unique(holes.begin(), holes.end()), holes.end());
  return holes;
}

/// Without a branch for each sample, so that the compiler looks at several at a time.
bool allFinite(std::span<const float> samples) {
  constexpr std::uint32_t kInfinity = 0x7f800000u;
  std::uint32_t bad = 0;
  for (const float sample : samples)
    bad |= static_cast<std::uint32_t>((bitCast<std::uint32_t>(sample) & kInfinity) == kInfinity);
  return bad == 0;
}

}  // namespace

glm::vec4 rgbaAt(const Image& image, int x, int y) {
  const float* texel = image.texel(x, y);
  const bool has_alpha = image.channels() == 2 || image.channels() == 4;
  return glm::vec4(rgbAt(image, x, y), has_alpha ? texel[image.channels() - 1] : 1.0f);
}

Image rgbOf(const Image& image) {
  if (image.channels() == 3) return image;
  Image light = Image::withoutValues(image.width(), image.height(), 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3 rgb = rgbAt(image, x, y);
      std::copy_n(&rgb.x, 3, light.texel(x, y));
    }
  return light;
}

float largestSample(const Image& image) {
  float largest = 0.0f;
  for (const float sample : image.samples()) largest = std::max(largest, sample);
  return largest;
}

NonFinite findNonFinite(const Image& image) {
  // Nearly all images have none, which is quickly seen on all cores.
  constexpr std::size_t kSamplesPerPiece = std::size_t{1} << 18;
  std::atomic<bool> is_finite = true;
  parallelFor(image.samples().size(), kSamplesPerPiece, [&](std::size_t begin, std::size_t end) {
    if (!allFinite(image.samples().subspan(begin, end - begin))) is_finite = false;
  });
  NonFinite found;
  if (is_finite) return found;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (!isFinite(image, x, y) && found.count++ == 0) found.first = {x, y};
  return found;
}

std::string textOf(const NonFinite& bad) {
  return countedAre(bad.count, "texel") + " NaN or infinite, the first at (" + std::to_string(bad.first.x) + ", " +
         std::to_string(bad.first.y) + ")";
}

Result<void> repairNonFinite(Image& image) {
  std::vector<glm::ivec2> holes;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (!isFinite(image, x, y)) holes.push_back({x, y});
  if (!holes.empty() && holes.size() == image.texelCount())
    return fail(ErrorCode::non_finite, "no texel is finite, so none can be repaired");

  // Ring by ring from the edge of each hole: what one pass finds is written only after it, so that the order of
  // the texels within a ring does not matter. Only neighbours of what was mended can be in the next ring.
  while (!holes.empty()) {
    std::vector<std::pair<glm::ivec2, glm::vec4>> ring;
    for (const glm::ivec2 hole : holes)
      if (const auto mean = meanOfNeighbours(image, hole.x, hole.y)) ring.emplace_back(hole, *mean);
    for (const auto& [hole, mean] : ring)
      for (int channel = 0; channel < image.channels(); ++channel) image.texel(hole.x, hole.y)[channel] = mean[channel];
    holes = holesBeside(image, ring);
  }
  return {};
}

Result<void> checkDimensions(long long width, long long height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width <= 0 || height <= 0)
    return fail(ErrorCode::bad_file, "says its size is " + size + "; an image has at least one texel");
  if (width > kLargestTexelCount / height)
    return fail(ErrorCode::too_large,
                "says its size is " + size + "; at most " + std::to_string(kLargestTexelCount) + " texels are read");
  return {};
}

Result<void> checkImageMemory(int width, int height, int channels) {
  return checkMemory(std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(channels) * sizeof(float));
}

}  // namespace mirrorball
