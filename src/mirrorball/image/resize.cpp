#include "mirrorball/image/resize.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// What a texel is made of along one side: so much of each texel from the first one on.
struct Shares {
  int first = 0;
  std::vector<float> of_texel = {};
};

/// The mean of from · [i, i + 1] / to.
Shares sharesOfMean(int i, int from, int to) {
  const double scale = double(from) / double(to);
  const double begin = double(i) * scale;
  const double end = double(i + 1) * scale;
  Shares shares{.first = static_cast<int>(begin)};
  for (int texel = shares.first; texel < from && double(texel) < end; ++texel) {
    const double covered = std::min(end, double(texel + 1)) - std::max(begin, double(texel));
    if (covered > 0.0) shares.of_texel.push_back(static_cast<float>(covered / scale));
  }
  return shares;
}

/// Between the two centres of texels around it; beyond the first and the last one, it is that.
Shares sharesBetween(int i, int from, int to) {
  const double place = std::clamp((double(i) + 0.5) * double(from) / double(to) - 0.5, 0.0, double(from - 1));
  const int first = std::min(static_cast<int>(place), std::max(from - 2, 0));
  const auto second = static_cast<float>(place - double(first));
  if (from == 1) return {.first = 0, .of_texel = {1.0f}};
  return {.first = first, .of_texel = {1.0f - second, second}};
}

std::vector<Shares> sharesOf(int from, int to) {
  std::vector<Shares> all;
  for (int i = 0; i < to; ++i) all.push_back(to < from ? sharesOfMean(i, from, to) : sharesBetween(i, from, to));
  return all;
}

Image withWidth(const Image& image, int width) {
  const std::vector<Shares> columns = sharesOf(image.width(), width);
  Image made(width, image.height(), image.channels());
  parallelFor(std::size_t(image.height()), 16, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < width; ++x)
        for (std::size_t i = 0; i < columns[std::size_t(x)].of_texel.size(); ++i) {
          const float* texel = image.texel(columns[std::size_t(x)].first + int(i), y);
          for (int channel = 0; channel < image.channels(); ++channel)
            made.texel(x, y)[channel] += columns[std::size_t(x)].of_texel[i] * texel[channel];
        }
  });
  return made;
}

Image withHeight(const Image& image, int height) {
  const std::vector<Shares> rows = sharesOf(image.height(), height);
  Image made(image.width(), height, image.channels());
  parallelFor(std::size_t(height), 16, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (std::size_t i = 0; i < rows[std::size_t(y)].of_texel.size(); ++i) {
        const auto row = image.row(rows[std::size_t(y)].first + int(i));
        for (std::size_t sample = 0; sample < row.size(); ++sample)
          made.row(y)[sample] += rows[std::size_t(y)].of_texel[i] * row[sample];
      }
  });
  return made;
}

}  // namespace

Image resized(const Image& image, glm::ivec2 size) {
  assert(!image.empty() && size.x >= 1 && size.y >= 1);
  return withHeight(withWidth(image, size.x), size.y);
}

}  // namespace mirrorball
