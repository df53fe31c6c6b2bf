// The twin in vector instructions of image/filter.h for points whose texels all lie inside one image; those near an
// edge or a fold are left to EnvironmentMap::radiance. sample_batch_test holds both to the same values.

#include "mirrorball/environment/sample_batch.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/environment/sample_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_SAMPLE_BATCH_ONCE
#define MIRRORBALL_SAMPLE_BATCH_ONCE
namespace mirrorball {

/// The texels that interpolation needs around a point: from `first` to `last` relative to the one left above it.
struct Reach {
  int first;
  int last;
};
constexpr Reach reachOf(Interpolation interpolation) {
  return interpolation == Interpolation::bicubic ? Reach{-1, 2} : Reach{0, 1};
}

/// Where the images of a map lie in memory.
struct MapTexels {
  std::array<const float*, 6> faces{};
  int width;
  int height;
  RowRange rows;  ///< in memory
  int channels;
  bool is_disc;
  bool is_half;   ///< no light comes from behind
  bool is_whole;  ///< its images have neither a disc nor folds

  explicit MapTexels(const EnvironmentMap& map)
      : width(map.extent().x),
        height(map.extent().y),
        rows(map.rows()),
        channels(map.face(0).channels()),
        is_disc(hasDisc(map.projection())),
        is_half(map.projection() == Projection::hemioctahedral),
        is_whole(!is_disc && !is_half && map.projection() != Projection::octahedral &&
                 map.projection() != Projection::equal_area) {
    for (int face = 0; face < map.faces(); ++face)
      faces[static_cast<std::size_t>(face)] = map.face(face).samples().data();
  }

  /// Whether all texels from (x + first, y + first) to (x + last, y + last) can be read as four floats each, none lies
  /// beside a disc, and those for a cubic lie on one chart.
  bool isInside(int x, int y, Reach reach) const {
    // One column more, since four floats of three channels reach into the next texel.
    if (x + reach.first < 0 || y + reach.first < rows.begin || x + reach.last + 1 >= width ||
        y + reach.last >= rows.end)
      return false;
    return is_whole || isOnOneChart(x, y, reach);
  }

  bool isOnOneChart(int x, int y, Reach reach) const {
    const float half = static_cast<float>(width) / 2.0f;
    const glm::vec2 from_center(static_cast<float>(x) + 1.0f - half, static_cast<float>(y) + 1.0f - half);
    if (is_disc) {
      const float most = half - 3.0f;  // 3 > 1.5 √2, the distance of the farthest texel's centre
      return most > 0.0f && glm::dot(from_center, from_center) <= most * most;
    }
    if (reach.first == 0) return true;
    // The octahedron's edges are the diagonals of the square, or its axes and the diamond between them.
    const glm::vec2 size = glm::abs(from_center);
    if (is_half) return std::abs(size.x - size.y) >= 3.0f;
    return std::min(size.x, size.y) >= 1.5f && std::abs(size.x + size.y - half) >= 3.0f;
  }
};

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Texel = hn::CappedTag<float, 4>;  // r, g, b and whatever follows

/// The sum of kCount × kCount texels, each weighed by the product of its column's and its row's weight.
template <int kCount>
hn::Vec<Texel> weighted(const float* corner, std::size_t channels, std::size_t row, const float* across,
                        const float* down) {
  const Texel d;
  auto sum = hn::Zero(d);
  for (int j = 0; j < kCount; ++j, corner += row) {
    auto line = hn::Zero(d);
    for (int i = 0; i < kCount; ++i)
      line = hn::MulAdd(hn::Set(d, across[i]), hn::LoadU(d, corner + static_cast<std::size_t>(i) * channels), line);
    sum = hn::MulAdd(hn::Set(d, down[j]), line, sum);
  }
  return sum;
}

/// As image/filter.h, bicubic: what falls below zero is raised.
hn::Vec<Texel> raised(hn::Vec<Texel> sum, const float* corner, std::size_t channels, std::size_t row) {
  const Texel d;
  auto least = hn::Zero(d);
  for (int j = 0; j < 4; ++j, corner += row)
    for (int i = 0; i < 4; ++i) least = hn::Min(least, hn::LoadU(d, corner + static_cast<std::size_t>(i) * channels));
  return hn::Max(sum, least);
}

void sampleInside(const MapTexels& map, Interpolation interpolation, const PointBatch& batch, LightBatch& light,
                  std::array<bool, PointBatch::kCapacity>& inside) {
  const Texel d;
  const Reach reach = reachOf(interpolation);
  const auto channels = static_cast<std::size_t>(map.channels);
  const std::size_t row = channels * static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
    const float px = batch.u[i] * static_cast<float>(map.width) - 0.5f;
    const float py = batch.v[i] * static_cast<float>(map.height) - 0.5f;
    // Positions are at least −½, so that truncation after an offset of 1 is floor.
    const int x = static_cast<int>(px + 1.0f) - 1;
    const int y = static_cast<int>(py + 1.0f) - 1;
    inside[i] = map.isInside(x, y, reach) && !(map.is_half && batch.z[i] < 0.0f);
    if (!inside[i]) continue;
    const float tx = px - static_cast<float>(x);
    const float ty = py - static_cast<float>(y);
    const float* corner = map.faces[static_cast<std::size_t>(batch.face[i])] +
                          static_cast<std::size_t>(y + reach.first - map.rows.begin) * row +
                          static_cast<std::size_t>(x + reach.first) * channels;
    if (interpolation == Interpolation::bilinear) {
      const float across[2] = {1.0f - tx, tx};
      const float down[2] = {1.0f - ty, ty};
      hn::StoreU(weighted<2>(corner, channels, row, across, down), d, &light[i].x);
      continue;
    }
    const std::array<float, 4> across = catmullRomWeights(tx);
    const std::array<float, 4> down = catmullRomWeights(ty);
    auto sum = weighted<4>(corner, channels, row, across.data(), down.data());
    if (!hn::AllFalse(d, sum < hn::Zero(d))) sum = raised(sum, corner, channels, row);
    hn::StoreU(sum, d, &light[i].x);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(sampleInside);

void sampleBatch(const EnvironmentMap& map, Interpolation interpolation, const PointBatch& batch, LightBatch& light) {
  std::array<bool, PointBatch::kCapacity> inside;
  inside.fill(false);
  const bool has_colour = map.face(0).channels() >= 3;
  if (has_colour) HWY_DYNAMIC_DISPATCH(sampleInside)(MapTexels(map), interpolation, batch, light, inside);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
    if (!inside[i]) light[i] = glm::vec4(map.radiance({batch.x[i], batch.y[i], batch.z[i]}, interpolation), 0.0f);
}

}  // namespace mirrorball
#endif
