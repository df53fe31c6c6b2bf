#include "mirrorball/bake/harmonic_transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mirrorball/bake/legendre.h"
#include "mirrorball/bake/ring_spectra.h"
#include "mirrorball/base/parallel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/harmonic_transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// rows_of_8[i] += Σ_k legendre[k · step_k + i · step_i] · values[k], for eight rows at once: each value is eight floats.
void addProducts(const float* legendre, std::size_t step_i, std::size_t step_k, const float* values,
                 std::size_t values_step, std::size_t count, float* rows, std::size_t rows_step) {
  const hn::CappedTag<float, 8> d;
  for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(d)) {
    auto a = hn::LoadU(d, rows + lane);
    auto b = hn::LoadU(d, rows + rows_step + lane);
    auto c = hn::LoadU(d, rows + 2 * rows_step + lane);
    auto e = hn::LoadU(d, rows + 3 * rows_step + lane);
    auto f = hn::LoadU(d, rows + 4 * rows_step + lane);
    auto g = hn::LoadU(d, rows + 5 * rows_step + lane);
    auto h = hn::LoadU(d, rows + 6 * rows_step + lane);
    auto i = hn::LoadU(d, rows + 7 * rows_step + lane);
    for (std::size_t k = 0; k < count; ++k) {
      const auto value = hn::LoadU(d, values + k * values_step + lane);
      const float* p = legendre + k * step_k;
      a = hn::MulAdd(hn::Set(d, p[0]), value, a);
      b = hn::MulAdd(hn::Set(d, p[step_i]), value, b);
      c = hn::MulAdd(hn::Set(d, p[2 * step_i]), value, c);
      e = hn::MulAdd(hn::Set(d, p[3 * step_i]), value, e);
      f = hn::MulAdd(hn::Set(d, p[4 * step_i]), value, f);
      g = hn::MulAdd(hn::Set(d, p[5 * step_i]), value, g);
      h = hn::MulAdd(hn::Set(d, p[6 * step_i]), value, h);
      i = hn::MulAdd(hn::Set(d, p[7 * step_i]), value, i);
    }
    hn::StoreU(a, d, rows + lane);
    hn::StoreU(b, d, rows + rows_step + lane);
    hn::StoreU(c, d, rows + 2 * rows_step + lane);
    hn::StoreU(e, d, rows + 3 * rows_step + lane);
    hn::StoreU(f, d, rows + 4 * rows_step + lane);
    hn::StoreU(g, d, rows + 5 * rows_step + lane);
    hn::StoreU(h, d, rows + 6 * rows_step + lane);
    hn::StoreU(i, d, rows + 7 * rows_step + lane);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {
namespace {

HWY_EXPORT(addProducts);

using Coefficient = HarmonicCoefficients::Value;
static_assert(sizeof(Coefficient) == 8 * sizeof(float) && sizeof(RingPair) == 16 * sizeof(float));

/// cos θ and log₂ sin θ of a map's northern rings.
struct Rings {
  std::vector<double> cosines;
  std::vector<double> sines;
  std::vector<double> log2_sines;

  explicit Rings(const RingSpectra& spectra) {
    for (int pair = 0; pair < spectra.pairs(); ++pair) {
      const double theta = spectra.theta(pair);
      cosines.push_back(std::cos(theta));
      sines.push_back(std::sin(theta));
      log2_sines.push_back(std::log2(sines.back()));
    }
  }
};

/// Calls `visit(first pair, l − m, legendre)` for each stretch of bands on each block of rings that an order reaches;
/// legendre holds [band][ring].
template <typename Visit>
void forEachStretch(const LegendreOrder& order, int bands, const Rings& rings, const Visit& visit) {
  alignas(64) float legendre[kLegendreStretch * kLegendreBlock];
  const int pairs = static_cast<int>(rings.cosines.size());
  for (int begin = 0; begin < pairs; begin += kLegendreBlock) {
    const int count = std::min(kLegendreBlock, pairs - begin);
    if (vanishes(order.m, bands, rings.sines[static_cast<std::size_t>(begin + count - 1)])) continue;
    LegendreBlock block(order, rings.cosines.data() + begin, rings.log2_sines.data() + begin, count);
    for (int first = 0; order.m + first < bands; first += kLegendreStretch) {
      advance(order, first, block, legendre);
      visit(begin, first, legendre);
    }
  }
}

constexpr std::size_t kRows = 8;  // that addProducts takes at once

float* floatsOf(RingPair::Value& value) { return &value.real.x; }
const float* floatsOf(const RingPair::Value& value) { return &value.real.x; }

/// Σ over the rings of one order; every other band meets the even or the odd part of the pairs.
void analyseOrder(std::span<const RingPair> pairs, const LegendreOrder& order, int bands, const Rings& rings,
                  std::vector<Coefficient>& coefficients) {
  forEachStretch(order, bands, rings, [&](int begin, int first, const float* legendre) {
    const RingPair& pair = pairs[static_cast<std::size_t>(begin)];
    for (std::size_t parity = 0; parity < 2; ++parity)
      for (std::size_t k = parity; k < kLegendreStretch; k += 2 * kRows) HWY_DYNAMIC_DISPATCH(addProducts)
    (legendre + k * kLegendreBlock, 2 * kLegendreBlock, 1, floatsOf(parity == 0 ? pair.even : pair.odd), 16,
     kLegendreBlock, &coefficients[static_cast<std::size_t>(first) + k].real.x, 16);
  });
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const auto scale = static_cast<float>(order.scale[i]);
    coefficients[i].real *= scale;
    coefficients[i].imaginary *= scale;
  }
}

/// Σ over the bands of one order, on every ring.
void synthesizeOrder(const std::vector<Coefficient>& coefficients, const LegendreOrder& order,
                     const std::vector<float>& weights, const Rings& rings, std::span<RingPair> pairs) {
  const int bands = static_cast<int>(weights.size());
  std::vector<Coefficient> weighted(order.scale.size(), Coefficient{glm::vec4(0.0f), glm::vec4(0.0f)});
  for (int l = order.m; l < bands; ++l) {
    const auto i = static_cast<std::size_t>(l - order.m);
    const float weight = weights[static_cast<std::size_t>(l)] * static_cast<float>(order.scale[i]);
    weighted[i] = {coefficients[i].real * weight, coefficients[i].imaginary * weight};
  }
  std::fill(pairs.begin(), pairs.end(), kNoLight);
  forEachStretch(order, bands, rings, [&](int begin, int first, const float* legendre) {
    for (std::size_t parity = 0; parity < 2; ++parity)
      for (std::size_t ring = 0; ring < kLegendreBlock; ring += kRows) {
        RingPair& pair = pairs[static_cast<std::size_t>(begin) + ring];
        HWY_DYNAMIC_DISPATCH(addProducts)
        (legendre + parity * kLegendreBlock + ring, 1, 2 * kLegendreBlock,
         &weighted[static_cast<std::size_t>(first) + parity].real.x, 16, kLegendreStretch / 2,
         floatsOf(parity == 0 ? pair.even : pair.odd), 16);
      }
  });
}

}  // namespace

HarmonicCoefficients::HarmonicCoefficients(int bands) : orders_(static_cast<std::size_t>(bands)) {
  for (int m = 0; m < bands; ++m) {
    const int stretches = (bands - m + kLegendreStretch - 1) / kLegendreStretch;
    order(m).resize(static_cast<std::size_t>(stretches * kLegendreStretch), {glm::vec4(0.0f), glm::vec4(0.0f)});
  }
}

HarmonicCoefficients analyse(const EnvironmentMap& panorama, const BrightTexels& without, int bands) {
  RingSpectra spectra = spectraOfRows(panorama, without, bands);
  const Rings rings(spectra);
  const std::vector<double> seeds = legendreSeeds(bands);
  HarmonicCoefficients coefficients(bands);
  parallelFor(static_cast<std::size_t>(bands), 4, [&](std::size_t begin, std::size_t end) {
    for (int m = static_cast<int>(begin); m < static_cast<int>(end); ++m) {
      const std::span<RingPair> pairs = spectra.order(m);
      std::fill(pairs.begin() + spectra.pairs(), pairs.end(), kNoLight);
      analyseOrder(pairs, LegendreOrder(m, bands, seeds[static_cast<std::size_t>(m)]), bands, rings,
                   coefficients.order(m));
    }
  });
  return coefficients;
}

SphereGrid synthesize(const HarmonicCoefficients& coefficients, const std::vector<float>& weights) {
  const int bands = static_cast<int>(weights.size());
  assert(bands <= coefficients.bands());
  // Half of the bands are weighed so lightly that what interpolation does to them is not seen.
  const int rings = quickLength(std::max(bands * 5 / 4, 16));
  RingSpectra spectra(rings, bands);
  const Rings places(spectra);
  const std::vector<double> seeds = legendreSeeds(bands);
  parallelFor(static_cast<std::size_t>(bands), 4, [&](std::size_t begin, std::size_t end) {
    for (int m = static_cast<int>(begin); m < static_cast<int>(end); ++m)
      synthesizeOrder(coefficients.order(m), LegendreOrder(m, bands, seeds[static_cast<std::size_t>(m)]), weights,
                      places, spectra.order(m));
  });
  return gridOf(spectra, quickLength(std::max(2 * bands + 2, 32)));
}

}  // namespace mirrorball
#endif
