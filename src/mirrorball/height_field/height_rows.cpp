// The loops that read and write whole maps, in vector instructions. height_rows_test holds each to its formula.

#include "mirrorball/height_field/height_rows.h"

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/height_field/height_rows.cpp"
// Highway needs its headers in this order.
// clang-format off
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using Floats = hn::Vec<Lanes>;

struct Slope {
  Floats along_u;
  Floats along_v;
};

/// formula/relief/slope.glsl, heightDifference, of the texels from x on.
template <HeightDifference difference>
Slope differenceAt(Lanes d, const HeightRows& rows, int x) {
  const auto load = [&](const float* row, int offset) { return hn::LoadU(d, row + x + offset); };
  if constexpr (difference == HeightDifference::backward) {
    const Floats here = load(rows.row, 0);
    return {here - load(rows.row, -1), here - load(rows.above, 0)};
  } else if constexpr (difference == HeightDifference::forward) {
    const Floats here = load(rows.row, 0);
    return {load(rows.row, 1) - here, load(rows.below, 0) - here};
  } else if constexpr (difference == HeightDifference::central) {
    const Floats half = hn::Set(d, 0.5f);
    return {half * load(rows.row, 1) - half * load(rows.row, -1),
            half * load(rows.below, 0) - half * load(rows.above, 0)};
  } else {
    const Floats eighth = hn::Set(d, 0.125f);
    const Floats quarter = hn::Set(d, 0.25f);
    const auto column = [&](int offset) {
      return eighth * load(rows.above, offset) + quarter * load(rows.row, offset) + eighth * load(rows.below, offset);
    };
    const auto line = [&](const float* row) {
      return eighth * load(row, -1) + quarter * load(row, 0) + eighth * load(row, 1);
    };
    return {column(1) - column(-1), line(rows.below) - line(rows.above)};
  }
}

/// formula/relief/slope.glsl, slopeOfDifference and normalFromSlope, of all texels that have two neighbours and fill a
/// vector.
///
/// returns  the first texel after them
template <HeightDifference difference, SlopeMap map>
int writeInnerSlopes(const HeightRows& rows, float per_texel, float* to) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto limited = [d](Floats value, float limit) {
    return hn::Clamp(value, hn::Set(d, -limit), hn::Set(d, limit));
  };
  int x = 1;
  for (; x + lanes < rows.width; x += lanes) {
    const Slope rise = differenceAt<difference>(d, rows, x);
    const Floats slope_u = limited(limited(rise.along_u, 1e30f) * hn::Set(d, per_texel), 1e18f);
    const Floats slope_v = limited(limited(rise.along_v, 1e30f) * hn::Set(d, per_texel), 1e18f);
    if constexpr (map == SlopeMap::derivatives) {
      hn::StoreInterleaved3(slope_u, hn::Zero(d), slope_v, d, to + 3 * x);
    } else {
      const Floats one = hn::Set(d, 1.0f);
      const Floats shrink = one / hn::Sqrt(slope_u * slope_u + slope_v * slope_v + one);
      hn::StoreInterleaved3(hn::Neg(slope_u) * shrink, slope_v * shrink, shrink, d, to + 3 * x);
    }
  }
  return x;
}

template <SlopeMap map>
int writeInnerMap(const HeightRows& rows, HeightDifference difference, float per_texel, float* to) {
  switch (difference) {
    case HeightDifference::backward:
      return writeInnerSlopes<HeightDifference::backward, map>(rows, per_texel, to);
    case HeightDifference::forward:
      return writeInnerSlopes<HeightDifference::forward, map>(rows, per_texel, to);
    case HeightDifference::central:
      return writeInnerSlopes<HeightDifference::central, map>(rows, per_texel, to);
    case HeightDifference::sobel:
      return writeInnerSlopes<HeightDifference::sobel, map>(rows, per_texel, to);
  }
  return 1;
}

int writeInner(const HeightRows& rows, HeightDifference difference, SlopeMap map, float per_texel, float* to) {
  return map == SlopeMap::normals ? writeInnerMap<SlopeMap::normals>(rows, difference, per_texel, to)
                                  : writeInnerMap<SlopeMap::derivatives>(rows, difference, per_texel, to);
}

/// Of those that fill vectors.
bool areInnerFinite(const float* row, int width) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  // Anything less itself is 0, but for NaN and infinity.
  Floats sum = hn::Zero(d);
  for (int x = 0; x + lanes <= width; x += lanes) {
    const Floats height = hn::LoadU(d, row + x);
    sum = sum + (height - height);
  }
  return hn::AllTrue(d, sum == hn::Zero(d));
}

int writeInnerPatchMaxima(const float* row, const float* below, int count, float* to) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    hn::StoreU(hn::Max(hn::Max(hn::LoadU(d, row + i), hn::LoadU(d, row + i + 1)),
                       hn::Max(hn::LoadU(d, below + i), hn::LoadU(d, below + i + 1))),
               d, to + i);
  return i;
}

int writeInnerPairMaxima(const float* row, const float* below, int count, float* to) {
  const Lanes d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    Floats even, odd, even_below, odd_below;
    hn::LoadInterleaved2(d, row + 2 * i, even, odd);
    hn::LoadInterleaved2(d, below + 2 * i, even_below, odd_below);
    hn::StoreU(hn::Max(hn::Max(even, odd), hn::Max(even_below, odd_below)), d, to + i);
  }
  return i;
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

#include "formula/relief.h"

namespace mirrorball {

HWY_EXPORT(writeInner);
HWY_EXPORT(areInnerFinite);
HWY_EXPORT(writeInnerPatchMaxima);
HWY_EXPORT(writeInnerPairMaxima);

void writeSlopes(const HeightRows& rows, const HeightFieldSettings& settings, SlopeMap map, float* to) {
  const int width = rows.width;
  const float per_texel = settings.scale * static_cast<float>(width);
  const auto writeOne = [&](int x) {
    const int left = texelBeyond(x - 1, width, settings.edges);
    const int right = texelBeyond(x + 1, width, settings.edges);
    const auto three = [&](const float* row) { return glm::vec3(row[left], row[x], row[right]); };
    const glm::vec2 rise = formula::heightDifference(static_cast<int>(settings.difference), three(rows.above),
                                                     three(rows.row), three(rows.below));
    const glm::vec2 slope = formula::slopeOfDifference(rise, per_texel);
    const glm::vec3 texel =
        map == SlopeMap::normals ? formula::normalFromSlope(slope) : glm::vec3(slope.x, 0.0f, slope.y);
    std::copy_n(&texel.x, 3, to + 3 * x);
  };
  writeOne(0);
  for (int x = HWY_DYNAMIC_DISPATCH(writeInner)(rows, settings.difference, map, per_texel, to); x < width; ++x)
    writeOne(x);
}

bool areFinite(const float* row, int width) {
  // Of the last ones, which may not fill a vector, some are looked at twice.
  constexpr int kMostLanes = 16;
  for (int x = std::max(width - kMostLanes, 0); x < width; ++x)
    if (!std::isfinite(row[x])) return false;
  return HWY_DYNAMIC_DISPATCH(areInnerFinite)(row, width);
}

void writePatchMaxima(const float* row, const float* below, int count, float* to) {
  for (int i = HWY_DYNAMIC_DISPATCH(writeInnerPatchMaxima)(row, below, count, to); i < count; ++i)
    to[i] = std::max({row[i], row[i + 1], below[i], below[i + 1]});
}

void writePairMaxima(const float* row, const float* below, int count, float* to) {
  for (int i = HWY_DYNAMIC_DISPATCH(writeInnerPairMaxima)(row, below, count, to); i < count; ++i)
    to[i] = std::max({row[2 * i], row[2 * i + 1], below[2 * i], below[2 * i + 1]});
}

}  // namespace mirrorball
#endif
