#include "mirrorball/bake/legendre.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/legendre.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_LEGENDRE_ONCE
#define MIRRORBALL_LEGENDRE_ONCE
namespace mirrorball {

/// The stretch on one ring, where it may have an exponent of its own.
inline void advanceRing(const double* step, LegendreBlock& block, std::size_t ring, float* values) {
  const double cosine = block.cosine[ring];
  double before = block.before[ring];
  double here = block.here[ring];
  int& exponent = block.exponent[ring];
  for (std::size_t k = 0; k < kLegendreStretch; ++k) {
    values[k * kLegendreBlock + ring] = exponent == 0 ? static_cast<float>(here) : 0.0f;
    const double next = step[k] * cosine * here - before;
    before = here;
    here = next;
    if (exponent < 0 && std::abs(here) > 0x1p480) {
      before *= 0x1p-960;
      here *= 0x1p-960;
      ++exponent;
    }
  }
  block.before[ring] = before;
  block.here[ring] = here;
}

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void advanceRings(const double* step, LegendreBlock& block, float* values) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> narrow;
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t ring = 0; ring < kLegendreBlock; ring += lanes) {
    if (std::any_of(&block.exponent[ring], &block.exponent[ring] + lanes, [](int e) { return e < 0; })) {
      for (std::size_t i = 0; i < lanes; ++i) advanceRing(step, block, ring + i, values);
      continue;
    }
    const auto cosine = hn::Load(d, &block.cosine[ring]);
    auto before = hn::Load(d, &block.before[ring]);
    auto here = hn::Load(d, &block.here[ring]);
    for (std::size_t k = 0; k < kLegendreStretch; ++k) {
      hn::Store(hn::DemoteTo(narrow, here), narrow, values + k * kLegendreBlock + ring);
      const auto next = hn::MulSub(hn::Mul(hn::Set(d, step[k]), cosine), here, before);
      before = here;
      here = next;
    }
    hn::Store(before, d, &block.before[ring]);
    hn::Store(here, d, &block.here[ring]);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(advanceRings);

LegendreOrder::LegendreOrder(int order, int bands) : m(order) {
  const int stretches = (bands - m + kLegendreStretch - 1) / kLegendreStretch;
  const int count = stretches * kLegendreStretch;
  step.reserve(static_cast<std::size_t>(count));
  scale.reserve(static_cast<std::size_t>(count));
  // P̄_mm² = (2m+1)!! / (4π (2m)!!) sin^2m θ.
  double log2_square = -std::log2(4.0 * std::numbers::pi);
  for (int k = 1; k <= m; ++k) log2_square += std::log2((2.0 * k + 1.0) / (2.0 * k));
  log2_seed = log2_square / 2;
  // β_{l+1} P̄_{l+1} = cos θ P̄_l − β_l P̄_{l−1} with β_l² = (l² − m²) / (4l² − 1); the scales h make it one product and
  // one difference: h_{l+1} = h_{l−1} β_l / β_{l+1}.
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
    exponent[ring] = std::min(static_cast<int>(std::round(log2_value / 960.0)), 0);
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
