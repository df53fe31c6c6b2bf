#include "mirrorball/bake/harmonics/legendre.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/harmonics/legendre.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_LEGENDRE_ONCE
#define MIRRORBALL_LEGENDRE_ONCE
namespace mirrorball {

/// Beside values of about 1 smaller ones are nothing, and sums of products with floats that are denormal take a hundred
/// times as long: all transforms took twice as long with them.
inline constexpr double kMinValue = 0x1p-64;

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The stretch on a vector of rings, some of which have an exponent of their own.
void advanceScaled(const double* step, LegendreBlock& block, std::size_t ring, float* values) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> narrow;
  const auto none = hn::Zero(d);
  const auto cosine = hn::Load(d, &block.cosine[ring]);
  auto before = hn::Load(d, &block.before[ring]);
  auto here = hn::Load(d, &block.here[ring]);
  auto exponent = hn::Load(d, &block.exponent[ring]);
  for (std::size_t k = 0; k < kLegendreStretch; ++k) {
    const auto counts = hn::And(exponent == none, hn::Abs(here) > hn::Set(d, kMinValue));
    hn::Store(hn::DemoteTo(narrow, hn::IfThenElseZero(counts, here)), narrow, values + k * kLegendreBlock + ring);
    const auto next = hn::MulSub(hn::Mul(hn::Set(d, step[k]), cosine), here, before);
    const auto is_scaled = exponent < none;
    const auto has_grown = hn::And(is_scaled, hn::Abs(next) > hn::Set(d, 0x1p480));
    const auto scale = hn::IfThenElse(has_grown, hn::Set(d, 0x1p-960), hn::Set(d, 1.0));
    before = hn::Mul(here, scale);
    here = hn::Mul(next, scale);
    exponent = hn::Add(exponent, hn::IfThenElseZero(has_grown, hn::Set(d, 1.0)));
  }
  hn::Store(before, d, &block.before[ring]);
  hn::Store(here, d, &block.here[ring]);
  hn::Store(exponent, d, &block.exponent[ring]);
}

/// Four vectors of rings at once, since each step waits for the one before.
void advanceRings(const double* step, LegendreBlock& block, float* values) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> narrow;
  const std::size_t lanes = hn::Lanes(d);
  const auto min = hn::Set(d, kMinValue);
  const auto store = [&](auto value, float* to) {
    const auto counted = hn::IfThenElseZero(hn::Abs(value) > min, value);
    hn::Store(hn::DemoteTo(narrow, counted), narrow, to);
  };
  for (std::size_t ring = 0; ring < kLegendreBlock; ring += 4 * lanes) {
    const std::size_t r1 = ring + lanes;
    const std::size_t r2 = ring + 2 * lanes;
    const std::size_t r3 = ring + 3 * lanes;
    if (std::any_of(&block.exponent[ring], &block.exponent[ring] + 4 * lanes, [](double e) { return e < 0.0; })) {
      for (const std::size_t first : {ring, r1, r2, r3}) advanceScaled(step, block, first, values);
      continue;
    }
    const auto cosine0 = hn::Load(d, &block.cosine[ring]);
    const auto cosine1 = hn::Load(d, &block.cosine[r1]);
    const auto cosine2 = hn::Load(d, &block.cosine[r2]);
    const auto cosine3 = hn::Load(d, &block.cosine[r3]);
    auto before0 = hn::Load(d, &block.before[ring]);
    auto before1 = hn::Load(d, &block.before[r1]);
    auto before2 = hn::Load(d, &block.before[r2]);
    auto before3 = hn::Load(d, &block.before[r3]);
    auto here0 = hn::Load(d, &block.here[ring]);
    auto here1 = hn::Load(d, &block.here[r1]);
    auto here2 = hn::Load(d, &block.here[r2]);
    auto here3 = hn::Load(d, &block.here[r3]);
    // Two steps a turn, so that nothing has to be moved: `before` becomes the next value, then `here` does.
    for (std::size_t k = 0; k < kLegendreStretch; k += 2) {
      float* even = values + k * kLegendreBlock;
      float* odd = even + kLegendreBlock;
      store(here0, even + ring);
      store(here1, even + r1);
      store(here2, even + r2);
      store(here3, even + r3);
      const auto first = hn::Set(d, step[k]);
      before0 = hn::MulSub(hn::Mul(first, cosine0), here0, before0);
      before1 = hn::MulSub(hn::Mul(first, cosine1), here1, before1);
      before2 = hn::MulSub(hn::Mul(first, cosine2), here2, before2);
      before3 = hn::MulSub(hn::Mul(first, cosine3), here3, before3);
      store(before0, odd + ring);
      store(before1, odd + r1);
      store(before2, odd + r2);
      store(before3, odd + r3);
      const auto second = hn::Set(d, step[k + 1]);
      here0 = hn::MulSub(hn::Mul(second, cosine0), before0, here0);
      here1 = hn::MulSub(hn::Mul(second, cosine1), before1, here1);
      here2 = hn::MulSub(hn::Mul(second, cosine2), before2, here2);
      here3 = hn::MulSub(hn::Mul(second, cosine3), before3, here3);
    }
    hn::Store(before0, d, &block.before[ring]);
    hn::Store(before1, d, &block.before[r1]);
    hn::Store(before2, d, &block.before[r2]);
    hn::Store(before3, d, &block.before[r3]);
    hn::Store(here0, d, &block.here[ring]);
    hn::Store(here1, d, &block.here[r1]);
    hn::Store(here2, d, &block.here[r2]);
    hn::Store(here3, d, &block.here[r3]);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(advanceRings);

std::vector<double> legendreSeeds(int orders) {
  // P̄_mm² = (2m+1)!! / (4π (2m)!!) sin^2m θ.
  std::vector<double> seeds;
  double log2_square = -std::log2(4.0 * std::numbers::pi);
  for (int m = 0; m < orders; ++m) {
    if (m > 0) log2_square += std::log2((2.0 * m + 1.0) / (2.0 * m));
    seeds.push_back(log2_square / 2.0);
  }
  return seeds;
}

LegendreOrder::LegendreOrder(int order, int bands, double seed) : m(order), log2_seed(seed) {
  const int stretches = (bands - m + kLegendreStretch - 1) / kLegendreStretch;
  const int count = stretches * kLegendreStretch;
  step.reserve(static_cast<std::size_t>(count));
  scale.reserve(static_cast<std::size_t>(count));
  // β_{l+1} P̄_{l+1} = cos θ P̄_l − β_l P̄_{l−1} with β_l² = (l² − m²) / (4l² − 1); the scales h make it one product
  // and one difference: h_{l+1} = h_{l−1} β_l / β_{l+1}.
  const auto beta = [this](int l) { return std::sqrt((double(l) * l - double(m) * m) / (4.0 * l * l - 1.0)); };
  double scale_before = 1.0;
  double scale_here = 1.0;
  double beta_here = 0.0;
  for (int l = m; l < m + count; ++l) {
    const double beta_next = beta(l + 1);
    const double scale_next = l == m ? 1.0 : scale_before * beta_here / beta_next;
    scale.push_back(scale_here);
    step.push_back(scale_here / (scale_next * beta_next));
    scale_before = scale_here;
    scale_here = scale_next;
    beta_here = beta_next;
  }
}

LegendreBlock::LegendreBlock(const LegendreOrder& order, const double* cosines, const double* log2_sines, int count) {
  for (std::size_t ring = 0; ring < static_cast<std::size_t>(count); ++ring) {
    cosine[ring] = cosines[ring];
    const double log2_value = order.log2_seed + order.m * log2_sines[ring];
    exponent[ring] = std::min(std::round(log2_value / 960.0), 0.0);
    here[ring] = std::exp2(log2_value - 960.0 * exponent[ring]);
  }
}

void advance(const LegendreOrder& order, int first, LegendreBlock& block, float* values) {
  HWY_DYNAMIC_DISPATCH(advanceRings)(order.step.data() + first, block, values);
}

bool vanishes(int order, int bands, double sine) {
  const double turning = bands * sine;
  return order > turning + 5.0 * std::cbrt(turning) + 12.0;
}

}  // namespace mirrorball
#endif
