// The twin in vector instructions of image/filter.h for points whose texels all lie inside one image; those near an
// edge or a fold are left to EnvironmentMap::radiance. sample_batch_test holds both to the same values.

#include "mirrorball/environment/convert/sample_batch.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <hwy/cache_control.h>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/environment/convert/sample_batch.cpp"
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
  std::span<const float> row_bends;  ///< of a panorama
  bool is_disc;
  bool is_half;   ///< no light comes from behind
  bool is_whole;  ///< its images have neither a disc nor folds

  explicit MapTexels(const EnvironmentMap& map)
      : width(map.extent().x),
        height(map.extent().y),
        rows(map.rows()),
        channels(map.face(0).channels()),
        row_bends(map.rowBends()),
        is_disc(hasDisc(map.projection())),
        is_half(map.projection() == Projection::hemioctahedral),
        is_whole(!is_disc && !is_half && map.projection() != Projection::octahedral &&
                 map.projection() != Projection::equal_area) {
    for (int face = 0; face < map.faces(); ++face)
      faces[static_cast<std::size_t>(face)] = map.face(face).samples().data();
  }

  /// The part of an image where all texels that `reach` names can be read as four floats each.
  struct Inside {
    glm::ivec2 min;
    glm::ivec2 max;
  };
  Inside inside(Reach reach) const {
    // One column more, since four floats of three channels reach into the next texel.
    return {{-reach.first, rows.begin - reach.first}, {width - reach.last - 2, rows.end - reach.last - 1}};
  }

  /// EnvironmentMap::rowBendAt.
  ///
  /// y   the texel left above
  float rowBend(int y) const { return row_bends.empty() ? 0.0f : row_bends[static_cast<std::size_t>(y + 1)]; }

  /// Whether none of the texels lies beside a disc, and those for a cubic lie in one smooth region.
  bool isOnOneChart(int x, int y, Reach reach) const {
    if (is_whole) return true;
    const float half = static_cast<float>(width) / 2.0f;
    const glm::vec2 from_center(static_cast<float>(x) + 1.0f - half, static_cast<float>(y) + 1.0f - half);
    if (is_disc) {
      const float max = half - 3.0f;  // 3 > 1.5 √2, the distance of the farthest texel's centre
      return max > 0.0f && glm::dot(from_center, from_center) <= max * max;
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
#if HWY_TARGET == HWY_SCALAR

// Without vectors of four there is nothing to gain.
void sampleInside(const MapTexels&, Interpolation, const PointBatch&, LightBatch&,
                  std::array<bool, PointBatch::kCapacity>&) {}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Texel = hn::CappedTag<float, 4>;    // r, g, b and whatever follows
using Texels = hn::CappedTag<float, 16>;  // one, two or four texels side by side
template <class D>
using Indices = decltype(hn::SetTableIndices(D(), static_cast<const int32_t*>(nullptr)));

/// How smooth light is between texels, which are in the first three lanes each.
float smoothnessBetween(hn::Vec<Texel> min, hn::Vec<Texel> max) {
  const Texel d;
  // Most texels have so little contrast, which is quickly seen.
  if (hn::AllTrue(d, hn::Or(max <= hn::Mul(min, hn::Set(d, 8.0f)), hn::Not(hn::FirstN(d, 3))))) return 1.0f;
  HWY_ALIGN std::array<float, 4> least, most;
  hn::Store(min, d, least.data());
  hn::Store(max, d, most.data());
  return mirrorball::shareByContrast({{least[0], least[1], least[2]}, {most[0], most[1], most[2]}});
}

/// The four texels around the point, each weighed by the product of its column's and its row's weight.
void bilinearInside(const float* corner, std::size_t channels, std::size_t row, glm::vec2 t, glm::vec4& light) {
  const Texel d;
  const auto first = hn::LoadU(d, corner);
  const auto second = hn::LoadU(d, corner + channels);
  const auto third = hn::LoadU(d, corner + row);
  const auto fourth = hn::LoadU(d, corner + row + channels);
  const auto between = [&](float share, auto a, auto b) {
    return hn::MulAdd(hn::Set(d, share), b, hn::Mul(hn::Set(d, 1.0f - share), a));
  };
  hn::StoreU(between(t.y, between(t.x, first, second), between(t.x, third, fourth)), d, &light.x);
  light.w = smoothnessBetween(hn::Min(hn::Min(first, second), hn::Min(third, fourth)),
                              hn::Max(hn::Max(first, second), hn::Max(third, fourth)));
}

/// The greatest of each texel's four lanes, in all of them.
template <class V>
V maxOfTexel(V v) {
  const V pairs = hn::Max(v, hn::Shuffle2301(v));
  return hn::Max(pairs, hn::Shuffle1032(pairs));
}

/// image/filter.h, contrastOf, for as many texels as there are side by side; each one's fourth lane holds its third.
template <class D, class V = hn::Vec<D>>
V contrastOf(D d, V min, V max) {
  const V little = hn::Mul(hn::Max(maxOfTexel(max), hn::Zero(d)), hn::Set(d, 1.0f / 64.0f));
  return maxOfTexel(hn::Div(hn::Add(hn::Abs(max), little), hn::Max(hn::Add(min, little), hn::Set(d, 1e-30f))));
}

/// image/filter.h, shareBelow, likewise.
template <class D, class V = hn::Vec<D>>
V shareBelow(D d, float whole, V contrast) {
  const V share = hn::NegMulAdd(hn::Set(d, 2.0f / whole), contrast, hn::Set(d, 2.0f));
  return hn::Min(hn::Max(share, hn::Zero(d)), hn::Set(d, 1.0f));
}

/// image/filter.h, limitedCubic, likewise.
///
/// contrast   rises to that of these texels, if they have much
template <class D, class V = hn::Vec<D>>
HWY_INLINE V limitedCubic(D d, V before, V first, V second, V after, V t, V share, V line_bend, V& crossing_share,
                          V& contrast) {
  const V zero = hn::Zero(d);
  const V half = hn::Set(d, 0.5f);
  const V slope = hn::Sub(second, first);
  const V half_slope = hn::Mul(half, slope);
  const V from_first = hn::Sub(before, first);
  const V from_second = hn::Sub(after, second);
  const V bend = hn::MulAdd(half, from_first, half_slope);
  const V next_bend = hn::MulSub(half, from_second, half_slope);
  const V arch = hn::NegMulAdd(t, t, t);
  const V rest = hn::Sub(hn::Set(d, 1.0f), t);
  const V change = hn::Mul(hn::Neg(arch), hn::MulAdd(t, next_bend, hn::Mul(rest, bend)));

  const V min = hn::Min(first, second);
  const V max = hn::Max(first, second);
  const V darkest = hn::Min(min, hn::Min(before, after));
  const V brightest = hn::Max(max, hn::Max(before, after));
  V place = t;
  // Most texels have so little contrast, which is quickly seen.
  if (!hn::AllTrue(d, brightest <= hn::Mul(darkest, hn::Set(d, 8.0f)))) {
    const V along = contrastOf(d, darkest, brightest);
    contrast = hn::Max(contrast, along);
    share = hn::Mul(share, shareBelow(d, kCubicContrast, along));
    place = hn::MulAdd(hn::Mul(hn::Sub(hn::Set(d, 1.0f), share), line_bend), arch, t);
    const V near_before = hn::MulAdd(rest, from_first, first);
    const V near_after = hn::MulAdd(t, from_second, second);
    const V crossing =
        contrastOf(d, hn::Min(min, hn::Min(near_before, near_after)), hn::Max(max, hn::Max(near_before, near_after)));
    crossing_share = shareBelow(d, kCubicContrast, crossing);
  }
  const V trough = hn::Max(hn::Min(hn::Min(bend, next_bend), hn::Min(from_first, from_second)), zero);
  const V peak = hn::Min(hn::Max(hn::Max(bend, next_bend), hn::Max(from_first, from_second)), zero);
  const V twice = hn::Add(arch, arch);
  const V lowest = hn::Max(hn::NegMulAdd(twice, trough, min), hn::Min(min, zero));
  const V highest = hn::NegMulAdd(twice, peak, max);
  const V line = hn::MulAdd(place, slope, first);
  return hn::Min(hn::Max(hn::MulAdd(share, change, line), lowest), highest);
}

/// `bicubic` of image/filter.h for several points at a time: down the columns point by point, four texels side by side;
/// then across, as many points side by side.
class BicubicInside {
 public:
  BicubicInside(std::size_t channels, std::size_t row)
      : channels_(channels), row_(row), loaded_(hn::FirstN(Texels(), channels * kTexels)), order_(orderOf(channels)) {}

  /// corner     the first of the point's 16 texels
  /// t          where among the inner four it lies
  /// row_bend   MapTexels::rowBend
  /// index      of the point in the batch
  void add(const float* corner, glm::vec2 t, float row_bend, std::size_t index) {
    const Texels d;
    const auto down = hn::Set(d, t.y);
    const auto line_bend = hn::Set(d, row_bend);
    const auto whole = hn::Set(d, 1.0f);
    auto share = whole;
    auto contrast = whole;
    HWY_ALIGN std::array<float, 16> columns;
    for (std::size_t column = 0; column < 4; column += kTexels) {
      const float* top = corner + column * channels_;
      auto crossing_share = whole;
      const auto light = limitedCubic(d, load(top), load(top + row_), load(top + 2 * row_), load(top + 3 * row_), down,
                                      whole, line_bend, crossing_share, contrast);
      hn::Store(light, d, columns.data() + column * 4);
      share = hn::Min(share, crossing_share);
    }
    if (!hn::AllTrue(d, share == whole)) share = hn::MinOfLanes(d, share);
    smoothness_[count_] = hn::AllTrue(d, contrast == whole) ? 1.0f : smoothnessAt(hn::MaxOfLanes(d, contrast));
    const Texel one;
    hn::Store(hn::Set(one, hn::GetLane(share)), one, shares_.data() + 4 * count_);
    for (std::size_t column = 0; column < 4; ++column)
      hn::Store(hn::Load(one, columns.data() + 4 * column), one, columns_[column].data() + 4 * count_);
    hn::Store(hn::Set(one, t.x), one, across_.data() + 4 * count_);
    indices_[count_++] = index;
  }

  /// Answers for all points that were added.
  void finish(LightBatch& light) const {
    const Texels d;
    HWY_ALIGN std::array<float, 4 * kTexels> answers, across_contrasts;
    for (std::size_t begin = 0; begin < count_; begin += kTexels) {
      const auto column = [&](std::size_t number) { return hn::Load(d, columns_[number].data() + 4 * begin); };
      const auto across = hn::Load(d, across_.data() + 4 * begin);
      const auto share = hn::Load(d, shares_.data() + 4 * begin);
      auto contrast = hn::Set(d, 1.0f);
      auto crossing_share = share;  // by nothing
      hn::Store(limitedCubic(d, column(0), column(1), column(2), column(3), across, share, hn::Zero(d), crossing_share,
                             contrast),
                d, answers.data());
      const Texel one;
      const bool is_smooth = hn::AllTrue(d, contrast == hn::Set(d, 1.0f));
      if (!is_smooth) hn::Store(contrast, d, across_contrasts.data());
      for (std::size_t point = 0; point < std::min(kTexels, count_ - begin); ++point) {
        glm::vec4& answer = light[indices_[begin + point]];
        hn::StoreU(hn::Load(one, answers.data() + 4 * point), one, &answer.x);
        answer.w = smoothness_[begin + point];
        if (!is_smooth)
          answer.w = std::min(answer.w, mirrorball::shareBelow(kCubicContrast, across_contrasts[4 * point]));
      }
    }
  }

 private:
  static float smoothnessAt(hn::Vec<Texels> contrast) {
    return mirrorball::shareBelow(kCubicContrast, hn::GetLane(contrast));
  }

  static constexpr std::size_t kTexels = hn::MaxLanes(Texels()) / 4;
  using Lanes = std::array<float, 4 * PointBatch::kCapacity>;

  /// Each texel's red, green, blue and blue again: what else follows must not count in its contrast.
  static Indices<Texels> orderOf(std::size_t channels) {
    HWY_ALIGN std::array<int32_t, 4 * kTexels> order;
    for (std::size_t lane = 0; lane < order.size(); ++lane)
      order[lane] = static_cast<int32_t>(lane / 4 * channels + std::min<std::size_t>(lane % 4, 2));
    return hn::SetTableIndices(Texels(), order.data());
  }

  /// Four texels of three channels fill 12 of 16 lanes: what lies behind them may not be there to be read.
  hn::Vec<Texels> load(const float* texels) const {
    const Texels d;
    const auto lanes = kTexels == 4 ? hn::MaskedLoad(loaded_, d, texels) : hn::LoadU(d, texels);
    return hn::TableLookupLanes(lanes, order_);
  }

  std::size_t channels_;
  std::size_t row_;
  hn::Mask<Texels> loaded_;
  Indices<Texels> order_;
  HWY_ALIGN std::array<Lanes, 4> columns_;
  HWY_ALIGN Lanes across_;
  HWY_ALIGN Lanes shares_;
  std::array<float, PointBatch::kCapacity> smoothness_;  ///< down the columns
  std::array<std::size_t, PointBatch::kCapacity> indices_;
  std::size_t count_ = 0;
};

/// The texels that points lie between.
struct Cells {
  template <typename Value>
  using Values = PointBatch::Values<Value>;

  HWY_ALIGN Values<int32_t> x, y;         ///< of the texel left above
  HWY_ALIGN Values<float> tx, ty;         ///< from its centre to those of the next, in [0, 1]
  HWY_ALIGN Values<int32_t> is_readable;  ///< not 0 where all texels around can be
};

Cells cellsOf(const MapTexels& map, Reach reach, const PointBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const MapTexels::Inside inside = map.inside(reach);
  const auto isFrom = [&](int min, int max, auto cell) {
    return hn::And(cell >= hn::Set(d, static_cast<float>(min)), cell <= hn::Set(d, static_cast<float>(max)));
  };
  Cells cells;
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); i += hn::Lanes(d)) {
    const auto positionOf = [&](const PointBatch::Values<float>& along, int extent) {
      return hn::Sub(hn::Mul(hn::Load(d, along.data() + i), hn::Set(d, static_cast<float>(extent))), hn::Set(d, 0.5f));
    };
    const auto px = positionOf(batch.u, map.width);
    const auto py = positionOf(batch.v, map.height);
    const auto x = hn::Floor(px);
    const auto y = hn::Floor(py);
    auto readable = hn::And(isFrom(inside.min.x, inside.max.x, x), isFrom(inside.min.y, inside.max.y, y));
    if (map.is_half) readable = hn::And(readable, hn::Load(d, batch.z.data() + i) >= hn::Zero(d));
    hn::Store(hn::ConvertTo(di, x), di, cells.x.data() + i);
    hn::Store(hn::ConvertTo(di, y), di, cells.y.data() + i);
    hn::Store(hn::Sub(px, x), d, cells.tx.data() + i);
    hn::Store(hn::Sub(py, y), d, cells.ty.data() + i);
    hn::Store(hn::VecFromMask(di, hn::RebindMask(di, readable)), di, cells.is_readable.data() + i);
  }
  return cells;
}

/// How many points before their turn texels are asked for: long enough for memory,
/// not so long that they are gone again.
constexpr std::size_t kAhead = 8;

/// Asks for texels: rows of a map lie pages apart, and where neighbouring points go among them no processor guesses.
void prefetch(const float* corner, std::size_t channels, std::size_t row, Reach reach) {
  for (int line = reach.first; line <= reach.last; ++line, corner += row) hwy::Prefetch(corner + 2 * channels);
}

void sampleInside(const MapTexels& map, Interpolation interpolation, const PointBatch& batch, LightBatch& light,
                  std::array<bool, PointBatch::kCapacity>& inside) {
  const Reach reach = reachOf(interpolation);
  const auto channels = static_cast<std::size_t>(map.channels);
  const std::size_t row = channels * static_cast<std::size_t>(map.width);
  const Cells cells = cellsOf(map, reach, batch);
  const auto cornerOf = [&](std::size_t i) {
    return map.faces[static_cast<std::size_t>(batch.face[i])] +
           static_cast<std::size_t>(cells.y[i] + reach.first - map.rows.begin) * row +
           static_cast<std::size_t>(cells.x[i] + reach.first) * channels;
  };
  const auto count = static_cast<std::size_t>(batch.count);
  BicubicInside bicubic_inside(channels, row);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t later = i + kAhead;
    if (later < count && cells.is_readable[later] != 0) prefetch(cornerOf(later), channels, row, reach);
    inside[i] = cells.is_readable[i] != 0 && map.isOnOneChart(cells.x[i], cells.y[i], reach);
    if (!inside[i]) continue;
    glm::vec2 t(cells.tx[i], cells.ty[i]);
    const float row_bend = map.rowBend(cells.y[i]);
    if (interpolation == Interpolation::bicubic) {
      bicubic_inside.add(cornerOf(i), t, row_bend, i);
    } else {
      t.y += row_bend * t.y * (1.0f - t.y);  // EnvironmentMap::keepingLightOfRows
      bilinearInside(cornerOf(i), channels, row, t, light[i]);
    }
  }
  bicubic_inside.finish(light);
}

#endif

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
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
    if (inside[i]) continue;
    const auto [radiance, texels] = map.interpolated({batch.x[i], batch.y[i], batch.z[i]}, interpolation);
    light[i] = glm::vec4(radiance, shareByContrast(texels));
  }
}

}  // namespace mirrorball
#endif
