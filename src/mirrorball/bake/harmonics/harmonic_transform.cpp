#include "mirrorball/bake/harmonics/harmonic_transform.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>

#include "mirrorball/bake/harmonics/legendre.h"
#include "mirrorball/bake/harmonics/ring_spectra.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/vector_targets.h"

#ifndef MIRRORBALL_BAND_VALUES
#define MIRRORBALL_BAND_VALUES
namespace mirrorball {

/// Red, green and blue of a band, and their imaginary parts; order 0 has none, and white in their place.
constexpr std::size_t kBandChannels = 6;
using BandValues = std::array<float, kBandChannels>;

/// Each of them on the rings of a block.
using RingSums = std::array<std::array<float, kLegendreBlock>, kBandChannels>;

/// From the values of one ring to the next one's, and from one coefficient to the next but one.
constexpr std::size_t kFloatsApart = 16;
constexpr std::size_t kRows = 8;  ///< of coefficients, that products are added to at once

}  // namespace mirrorball
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/harmonics/harmonic_transform.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Of every other band a row: rows[i] += Σ_k legendre[2 i][k] · values[k] over the rings of a block. Rows are two
/// apart; each, and each value, is eight floats.
void addProducts(const float* legendre, const float* values, float* rows) {
  const hn::CappedTag<float, 8> d;
  for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(d)) {
    hn::Vec<decltype(d)> sums[kRows];
    for (std::size_t i = 0; i < kRows; ++i) sums[i] = hn::Zero(d);
    for (std::size_t k = 0; k < kLegendreBlock; ++k) {
      const auto value = hn::LoadU(d, values + k * kFloatsApart + lane);
      for (std::size_t i = 0; i < kRows; ++i)
        sums[i] = hn::MulAdd(hn::Set(d, legendre[2 * i * kLegendreBlock + k]), value, sums[i]);
    }
    for (std::size_t i = 0; i < kRows; ++i) {
      float* row = rows + i * kFloatsApart + lane;
      hn::StoreU(hn::Add(hn::LoadU(d, row), sums[i]), d, row);
    }
  }
}

/// Of every other band of a stretch: sums[c][ring] += Σ_k legendre[2 k][ring] · values[2 k][c], for the first `rings`
/// of a block, rounded up.
void addBands(const float* legendre, const BandValues* values, std::size_t rings, RingSums& sums) {
  const hn::CappedTag<float, 8> d;
  const std::size_t lanes = hn::Lanes(d);
  // Two vectors of each channel, so that no product waits for another; all stay in registers.
  for (std::size_t ring = 0; ring < rings; ring += 2 * lanes) {
    hn::Vec<decltype(d)> a[kBandChannels];
    hn::Vec<decltype(d)> b[kBandChannels];
    for (std::size_t c = 0; c < kBandChannels; ++c) {
      a[c] = hn::Zero(d);
      b[c] = hn::Zero(d);
    }
    for (std::size_t k = 0; k < kLegendreStretch; k += 2) {
      const auto legendre_a = hn::Load(d, legendre + k * kLegendreBlock + ring);
      const auto legendre_b = hn::Load(d, legendre + k * kLegendreBlock + ring + lanes);
      for (std::size_t c = 0; c < kBandChannels; ++c) {
        const auto value = hn::Set(d, values[k][c]);
        a[c] = hn::MulAdd(legendre_a, value, a[c]);
        b[c] = hn::MulAdd(legendre_b, value, b[c]);
      }
    }
    for (std::size_t c = 0; c < kBandChannels; ++c) {
      hn::Store(hn::Add(hn::Load(d, &sums[c][ring]), a[c]), d, &sums[c][ring]);
      hn::Store(hn::Add(hn::Load(d, &sums[c][ring + lanes]), b[c]), d, &sums[c][ring + lanes]);
    }
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {
namespace {

HWY_EXPORT(addProducts);
HWY_EXPORT(addBands);

using Coefficient = HarmonicCoefficients::Value;
static_assert(2 * sizeof(Coefficient) == kFloatsApart * sizeof(float) &&
              sizeof(RingPair) == kFloatsApart * sizeof(float));

/// The northern rings of so many equally spaced ones, half a space from the poles.
struct Rings {
  std::vector<double> cosines;
  std::vector<double> sines;
  std::vector<double> log2_sines;

  explicit Rings(int count) {
    for (int ring = 0; ring < (count + 1) / 2; ++ring) {
      const double theta = std::numbers::pi * (ring + 0.5) / count;
      cosines.push_back(std::cos(theta));
      sines.push_back(std::sin(theta));
      log2_sines.push_back(std::log2(sines.back()));
    }
  }

  int pairs() const { return static_cast<int>(cosines.size()); }
};

/// Calls `visit(place of the first pair, how many, Legendre functions at l = m)` for each block of the rings from
/// `first` on that an order reaches.
template <typename Visit>
void forEachBlock(const LegendreOrder& order, int bands, const Rings& rings, int first, const Visit& visit) {
  const int end = std::min(first + RingSpectra::kPairs, rings.pairs());
  for (int begin = first; begin < end; begin += kLegendreBlock) {
    const int count = std::min(kLegendreBlock, end - begin);
    if (vanishes(order.m, bands, rings.sines[static_cast<std::size_t>(begin + count - 1)])) continue;
    LegendreBlock block(order, rings.cosines.data() + begin, rings.log2_sines.data() + begin, count);
    visit(begin - first, count, block);
  }
}

/// Σ over the rings of one order; every other band meets the even or the odd part of the pairs.
void analyseOrder(const RingSpectra& spectra, int first, const Rings& rings, const LegendreOrder& order,
                  std::vector<Coefficient>& coefficients) {
  forEachBlock(order, spectra.orders(), rings, first, [&](int place, int, LegendreBlock& block) {
    alignas(64) float legendre[kLegendreStretch * kLegendreBlock];
    const RingPair& pair = spectra.order(order.m)[static_cast<std::size_t>(place)];
    const auto add_products = HWY_DYNAMIC_DISPATCH(addProducts);
    for (int l = 0; order.m + l < spectra.orders(); l += kLegendreStretch) {
      advance(order, l, block, legendre);
      for (std::size_t parity = 0; parity < 2; ++parity)
        for (std::size_t k = parity; k < kLegendreStretch; k += 2 * kRows)
          add_products(legendre + k * kLegendreBlock, parity == 0 ? &pair.even.real.x : &pair.odd.real.x,
                       &coefficients[static_cast<std::size_t>(l) + k].real.x);
    }
  });
}

/// The coefficients of one order, each times its band's weight and `scale`.
std::vector<BandValues> weightedOrder(const std::vector<Coefficient>& coefficients, const LegendreOrder& order,
                                      const std::vector<float>& weights) {
  std::vector<BandValues> weighted(order.scale.size(), BandValues{});
  for (std::size_t i = 0; i + static_cast<std::size_t>(order.m) < weights.size(); ++i) {
    const float weight = weights[i + static_cast<std::size_t>(order.m)] * static_cast<float>(order.scale[i]);
    const glm::vec4 real = coefficients[i].real * weight;
    const glm::vec3 other =
        order.m == 0 ? glm::vec3(real.w, 0.0f, 0.0f) : glm::vec3(coefficients[i].imaginary * weight);
    weighted[i] = {real.x, real.y, real.z, other.x, other.y, other.z};
  }
  return weighted;
}

RingPair::Value valueOf(const RingSums& sums, std::size_t ring, bool is_order_0) {
  const glm::vec3 real(sums[0][ring], sums[1][ring], sums[2][ring]);
  const glm::vec3 other(sums[3][ring], sums[4][ring], sums[5][ring]);
  if (is_order_0) return {glm::vec4(real, other.x), glm::vec4(0.0f)};
  return {glm::vec4(real, 0.0f), glm::vec4(other, 0.0f)};
}

/// Σ over the bands of one order, on every ring.
void synthesizeOrder(const std::vector<BandValues>& weighted, const Rings& rings, const LegendreOrder& order, int first,
                     RingSpectra& spectra) {
  const std::span<RingPair> pairs = spectra.order(order.m);
  std::fill(pairs.begin(), pairs.end(), kNoLight);
  forEachBlock(order, spectra.orders(), rings, first, [&](int place, int count, LegendreBlock& block) {
    alignas(64) float legendre[kLegendreStretch * kLegendreBlock];
    alignas(64) std::array<RingSums, 2> sums{};
    const auto add_bands = HWY_DYNAMIC_DISPATCH(addBands);
    for (int l = 0; order.m + l < spectra.orders(); l += kLegendreStretch) {
      advance(order, l, block, legendre);
      for (std::size_t parity = 0; parity < 2; ++parity)
        add_bands(legendre + parity * kLegendreBlock, &weighted[static_cast<std::size_t>(l) + parity],
                  static_cast<std::size_t>(count), sums[parity]);
    }
    for (std::size_t ring = 0; ring < static_cast<std::size_t>(count); ++ring)
      pairs[static_cast<std::size_t>(place) + ring] = {valueOf(sums[0], ring, order.m == 0),
                                                       valueOf(sums[1], ring, order.m == 0)};
  });
}

/// Calls `visit(m)` for all orders on all cores.
template <typename Visit>
void forEachOrder(int orders, const Visit& visit) {
  parallelFor(static_cast<std::size_t>(orders), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t m = begin; m < end; ++m) visit(static_cast<int>(m));
  });
}

/// The same, each order a step, until it is told to stop.
template <typename Visit>
void forEachOrder(int orders, ProgressCounter& steps, const Visit& visit) {
  forEachOrder(orders, [&](int m) {
    if (steps.stopped()) return;
    visit(m);
    steps.advance();
  });
}

/// Columns and rings for so many bands.
glm::ivec2 gridSizeFor(int bands, GridDensity density) {
  const bool is_dense = density == GridDensity::dense;
  const int columns = (is_dense ? 4 : 2) * bands + 2;
  const int rings = is_dense ? 2 * bands : bands * 9 / 8;
  return {quickLength(std::max(columns, 32)), quickLength(std::max(rings, 16))};
}

/// l and m < bands, each order rounded up to whole stretches.
std::uint64_t harmonicCount(int bands) { return std::uint64_t(bands) * std::uint64_t(bands + kLegendreStretch) / 2; }

/// Of a transform: each order each time that the spectra are filled.
std::size_t stepsOf(const Rings& rings, int bands) {
  const int fillings = (rings.pairs() + RingSpectra::kPairs - 1) / RingSpectra::kPairs;
  return std::size_t(fillings) * std::size_t(bands);
}

}  // namespace

HarmonicCoefficients::HarmonicCoefficients(int bands)
    : bands_(bands), orders_(static_cast<std::size_t>(bands)), legendre_(static_cast<std::size_t>(bands)) {
  const std::vector<double> seeds = legendreSeeds(bands);
  forEachOrder(bands, [&](int m) {
    const auto at = static_cast<std::size_t>(m);
    legendre_[at] = LegendreOrder(m, bands, seeds[at]);
    orders_[at].resize(legendre_[at].scale.size(), {glm::vec4(0.0f), glm::vec4(0.0f)});
  });
}

std::uint64_t harmonicBytes(int bands) {
  constexpr std::uint64_t kLegendreConstants = 2 * sizeof(double);
  return harmonicCount(bands) * (sizeof(Coefficient) + kLegendreConstants);
}

std::uint64_t analysisBytes(int bands) { return std::uint64_t(bands) * RingSpectra::kPairs * sizeof(RingPair); }

std::uint64_t synthesisBytes(int bands, GridDensity density) {
  const glm::ivec2 size = gridSizeFor(bands, density);
  const std::uint64_t grid = std::uint64_t(size.x) * std::uint64_t(size.y) * sizeof(glm::vec4);
  return harmonicCount(bands) * sizeof(BandValues) + analysisBytes(bands) + grid;
}

Result<HarmonicCoefficients> analyse(const EnvironmentMap& panorama, const BrightLights& without, int bands,
                                     const ProgressFunction& progress) {
  HarmonicCoefficients coefficients(bands);
  const RowTransform rows(panorama, without, bands);
  const Rings rings(panorama.extent().y);
  RingSpectra spectra(bands);
  ProgressCounter steps(progress, stepsOf(rings, bands));
  for (int first = 0; first < rings.pairs(); first += RingSpectra::kPairs) {
    rows.run(first, spectra);
    forEachOrder(bands, steps,
                 [&](int m) { analyseOrder(spectra, first, rings, coefficients.legendre(m), coefficients.order(m)); });
    MIRRORBALL_TRY_VOID(steps.result());
  }
  forEachOrder(bands, [&](int m) {
    std::vector<Coefficient>& order = coefficients.order(m);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto scale = static_cast<float>(coefficients.legendre(m).scale[i]);
      order[i] = {order[i].real * scale, order[i].imaginary * scale};
    }
  });
  return coefficients;
}

Result<SphereGrid> synthesize(const HarmonicCoefficients& coefficients, const std::vector<float>& weights,
                              GridDensity density, const ProgressFunction& progress) {
  const int bands = static_cast<int>(weights.size());
  assert(bands <= coefficients.bands());
  std::vector<std::vector<BandValues>> weighted(weights.size());
  forEachOrder(bands, [&](int m) {
    weighted[static_cast<std::size_t>(m)] = weightedOrder(coefficients.order(m), coefficients.legendre(m), weights);
  });
  const glm::ivec2 size = gridSizeFor(bands, density);
  SphereGrid grid(size.y, size.x);
  const GridTransform transform(grid, bands);
  const Rings rings(grid.rings());
  RingSpectra spectra(bands);
  ProgressCounter steps(progress, stepsOf(rings, bands));
  for (int first = 0; first < rings.pairs(); first += RingSpectra::kPairs) {
    forEachOrder(bands, steps, [&](int m) {
      synthesizeOrder(weighted[static_cast<std::size_t>(m)], rings, coefficients.legendre(m), first, spectra);
    });
    MIRRORBALL_TRY_VOID(steps.result());
    transform.run(first, spectra);
  }
  grid.close();
  return grid;
}

}  // namespace mirrorball
#endif
