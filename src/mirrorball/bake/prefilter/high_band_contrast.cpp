#include "mirrorball/bake/prefilter/high_band_contrast.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

constexpr int kPartsAcross = 32;
constexpr int kPartsDown = 16;

/// The samples of a panorama without those lights: its own rows, but for copies of the few that have lights.
class RowsWithout {
 public:
  RowsWithout(const Image& image, const BrightLights& without) : image_(image) {
    for (const Excess& bright : without.texels) {
      const auto [place, is_new] = copies_.try_emplace(bright.texel.y);
      const std::span<const float> row = image.row(bright.texel.y);
      if (is_new) place->second.assign(row.begin(), row.end());
      const int channels = image.channels();
      for (int c = 0; c < std::min(channels, 3); ++c)
        place->second[std::size_t(bright.texel.x * channels + c)] -= bright.radiance[c];
    }
  }

  const float* row(int y) const {
    const auto copy = copies_.find(y);
    return copy != copies_.end() ? copy->second.data() : image_.row(y).data();
  }

 private:
  const Image& image_;
  std::map<int, std::vector<float>> copies_;
};

/// So many samples that follow each other are a whole number of texels, of 1, 3 or 4 channels: sample i of a run
/// belongs to channel i % kRun % channels, and a run is a few vectors of any machine.
constexpr std::size_t kRun = 12;
using Run = std::array<float, kRun>;

struct PartSums {
  Run squares{};  // of the differences
  Run light{};
};

/// The sums over the samples [begin, end) of a row of `count`.
PartSums sumsOfPart(const float* above, const float* row, const float* below, std::size_t begin, std::size_t end,
                    std::size_t count, std::size_t channels) {
  PartSums sums;
  const auto add = [&](std::size_t i, std::size_t k, float beside) {
    const float difference = row[i] - 0.25f * (beside + above[i] + below[i]);
    sums.squares[k] += difference * difference;
    sums.light[k] += row[i];
  };
  const auto addOverSeam = [&](std::size_t i) {
    add(i, (i - begin) % kRun, row[(i + count - channels) % count] + row[(i + channels) % count]);
  };
  std::size_t i = begin;
  if (begin == 0)
    while (i < std::min(end, kRun)) addOverSeam(i++);
  for (; i + kRun <= std::min(end, count - channels); i += kRun)
    for (std::size_t k = 0; k < kRun; ++k) add(i + k, k, row[i + k - channels] + row[i + k + channels]);
  while (i < end) addOverSeam(i++);
  return sums;
}

/// Red, green and blue of a run.
glm::vec3 folded(const Run& run, std::size_t channels) {
  std::array<float, 4> sums{};
  for (std::size_t k = 0; k < kRun; ++k) sums[k % channels] += run[k];
  return channels >= 3 ? glm::vec3(sums[0], sums[1], sums[2]) : glm::vec3(sums[0]);
}

struct RowSums {
  glm::dvec3 squares{0.0};
  std::array<glm::vec3, kPartsAcross> parts{};
};

RowSums sumsOfRow(const RowsWithout& rows, int y, const Image& image) {
  RowSums sums;
  const auto channels = static_cast<std::size_t>(image.channels());
  const auto width = static_cast<std::size_t>(image.width());
  const float* above = rows.row(std::max(y - 1, 0));
  const float* row = rows.row(y);
  const float* below = rows.row(std::min(y + 1, image.height() - 1));
  for (std::size_t part = 0; part < kPartsAcross; ++part) {
    const std::size_t begin = part * width / kPartsAcross;
    const std::size_t end = (part + 1) * width / kPartsAcross;
    const PartSums part_sums =
        sumsOfPart(above, row, below, begin * channels, end * channels, width * channels, channels);
    sums.squares += folded(part_sums.squares, channels);
    sums.parts[part] = folded(part_sums.light, channels) / static_cast<float>(end - begin);
  }
  return sums;
}

}  // namespace

float highBandContrast(const EnvironmentMap& panorama, const BrightLights& without) {
  const Image& image = panorama.face(0);
  assert(image.width() >= kPartsAcross && image.height() >= kPartsDown);
  const RowsWithout rows_without(image, without);
  const auto height = static_cast<std::size_t>(image.height());
  std::vector<RowSums> rows(height);
  parallelFor(height, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) rows[y] = sumsOfRow(rows_without, static_cast<int>(y), image);
  });

  glm::dvec3 power(0.0);
  std::array<std::array<glm::vec3, kPartsAcross>, kPartsDown> parts{};
  for (std::size_t y = 0; y < height; ++y) {
    const auto weight =
        static_cast<double>(texelSolidAngle(Projection::equirect, panorama.extent(), {0, static_cast<int>(y)}));
    power += rows[y].squares * (weight * weight * 4.0 / 5.0);
    for (std::size_t x = 0; x < kPartsAcross; ++x) parts[y * kPartsDown / height][x] += rows[y].parts[x];
  }
  float contrast = 0.0f;
  for (int c = 0; c < 3; ++c) {
    float darkest = std::numeric_limits<float>::infinity();
    for (const auto& row : parts)
      for (const glm::vec3& part : row) darkest = std::min(darkest, part[c] * kPartsDown / float(height));
    const auto noise = static_cast<float>(std::sqrt(power[c]));
    if (noise > 0.0f)
      contrast = std::max(contrast, darkest > 0.0f ? noise / darkest : std::numeric_limits<float>::infinity());
  }
  return contrast;
}

}  // namespace mirrorball
