// A decoder interpolates between ends in numbers of 16 bits that stand for half floats, nearly the logarithm of light:
// there lines are fitted to the texels, by their spread and then by least squares. What they are worth is known by the
// error of the light that they decode to.

#include "mirrorball/codec/bc6h/bc6h_search.h"

#include "mirrorball/base/vector_targets.h"
#include "mirrorball/codec/bc6h/bc6h_modes.h"
#include "mirrorball/codec/half_blocks/block_weights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/codec/bc6h/bc6h_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_BC6H_SEARCH_ONCE
#define MIRRORBALL_BC6H_SEARCH_ONCE
namespace mirrorball {

/// Modes of kBc6hModes from the coarsest ends, which always fit, to the finest; for one subset and for two.
constexpr std::array<std::size_t, 4> kModesOfOne{10, 11, 12, 13};
constexpr std::array<std::size_t, 10> kModesOfTwo{9, 1, 6, 7, 8, 5, 0, 2, 3, 4};

/// So many of the 32 partitions, the best by a first estimate, are tried.
constexpr std::size_t kTriedPartitions = 3;

/// Ends that a finer mode does not reach may be nearer cut off than in one that reaches them: so much farther is tried.
constexpr float kSlack = 1.7f;

/// The partitions, as half_blocks/block_lines.inc has them.
constexpr std::array<std::uint32_t, 32> kPartitionCodes = [] {
  std::array<std::uint32_t, 32> codes{};
  for (std::uint32_t i = 0; i < codes.size(); ++i)
    codes[i] = kBc6hPartitions[i] | std::uint32_t{kBc6hAnchors[i]} << 16 | i << 24;
  return codes;
}();

/// The largest index where there are one or two subsets; an anchor's is at most half as large.
constexpr float lastIndex(int subsets) { return static_cast<float>((1 << bc6hIndexBits(subsets)) - 1); }
constexpr float lastOfAnchor(int subsets) { return (lastIndex(subsets) - 1.0f) / 2.0f; }

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

#include "mirrorball/codec/half_blocks/block_lines.inc"

/// 31/64 of a number are the bits of a half float.
struct Bc6hFormat {
  static V halfOf(V number) { return number * set(31.0f / 64.0f); }
  static V numberOf(V half) { return half * set(64.0f / 31.0f); }
  static constexpr const auto& kPartitionCodes = mirrorball::kPartitionCodes;
  static constexpr bool kHasAnchors = true;
};

/// The share of the second end in an index, as the specification rounds it.
template <int kSubsets>
HWY_INLINE V shareOf(V index) {
  return hn::Round(index * set(64.0f / lastIndex(kSubsets))) * set(1.0f / 64.0f);
}

/// A mode of each lane, and what its ends can be.
struct Mode {
  VU number;
  V step;      // from one end to the next, in numbers of 16 bits
  V last;      // the largest quantised end
  V reach[3];  // how far below the first end the others may be; above it is one less
};

HWY_INLINE Mode modeOf(std::size_t number) {
  const Bc6hMode& mode = kBc6hModes[number];
  Mode made{hn::Set(DU(), static_cast<std::uint32_t>(number)),
            set(static_cast<float>(1 << (16 - mode.bits))),
            set(static_cast<float>((1 << mode.bits) - 1)),
            {}};
  for (std::size_t c = 0; c < 3; ++c)
    made.reach[c] = set(mode.is_delta ? static_cast<float>(1 << (mode.deltas[c] - 1)) : 65536.0f);
  return made;
}

/// The finest mode that holds the lines, or would if it reached `slack` times as far.
template <int kSubsets>
HWY_NOINLINE Mode finestMode(const Lines& lines, float slack) {
  V extent[3];
  for (int c = 0; c < 3; ++c) {
    extent[c] = set(0.0f);
    for (int e = 1; e < 2 * kSubsets; ++e) extent[c] = hn::Max(extent[c], hn::Abs(lines.end[e][c] - lines.end[0][c]));
  }
  const auto choose = [&](const auto& numbers) HWY_ATTR {
    Mode chosen = modeOf(numbers[0]);
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const Mode mode = modeOf(numbers[i]);
      M fits = extent[0] <= (mode.reach[0] - set(1.0f)) * mode.step * set(slack);
      for (int c = 1; c < 3; ++c)
        fits = hn::And(fits, extent[c] <= (mode.reach[c] - set(1.0f)) * mode.step * set(slack));
      chosen.number = hn::IfThenElse(hn::RebindMask(DU(), fits), mode.number, chosen.number);
      chosen.step = hn::IfThenElse(fits, mode.step, chosen.step);
      chosen.last = hn::IfThenElse(fits, mode.last, chosen.last);
      for (int c = 0; c < 3; ++c) chosen.reach[c] = hn::IfThenElse(fits, mode.reach[c], chosen.reach[c]);
    }
    return chosen;
  };
  if constexpr (kSubsets == 1)
    return choose(kModesOfOne);
  else
    return choose(kModesOfTwo);
}

/// Quantises ends to what the mode holds, and makes the lines those that it decodes to.
HWY_INLINE void quantize(const Texels& texels, const Mode& mode, int ends, Lines& lines, V* quantized) {
  const V inverse_step = set(1.0f) / mode.step;
  for (int e = 0; e < ends; ++e)
    for (int c = 0; c < 3; ++c) {
      // q stands for (q + ½) steps, but the first and the last for the ends of the range.
      V q = hn::Floor((lines.end[e][c] + texels.middle[c]) * inverse_step);
      q = hn::Min(hn::Max(q, set(0.0f)), mode.last);
      if (e > 0) q = hn::Min(hn::Max(q, quantized[c] - mode.reach[c]), quantized[c] + mode.reach[c] - set(1.0f));
      quantized[3 * e + c] = q;
      V number = (q + set(0.5f)) * mode.step;
      number = hn::IfThenZeroElse(q == set(0.0f), number);
      number = hn::IfThenElse(q == mode.last, set(65535.0f), number);
      lines.end[e][c] = number - texels.middle[c];
    }
}

template <int kSubsets>
HWY_INLINE V errorOf(const Texels& texels, std::size_t i, const V* from, const V* along, V index) {
  const V share = shareOf<kSubsets>(index);
  V error = set(0.0f);
  for (int c = 0; c < 3; ++c) {
    const V off = lightOf<Bc6hFormat>(from[c] + share * along[c]) - texels.light[i][c];
    error = error + off * off;
  }
  return error * texels.light_weight[i];
}

/// The best index of every texel: of the two beside the nearest point of its line the one whose light is nearer.
///
/// returns  the error
template <int kSubsets>
HWY_NOINLINE V chooseIndices(const Texels& texels, const Lines& lines, VU code, V* indices) {
  V all_along[kSubsets][3];
  for (int s = 0; s < kSubsets; ++s)
    for (int c = 0; c < 3; ++c) all_along[s][c] = lines.end[2 * s + 1][c] - lines.end[2 * s][c];
  constexpr int kSecond = kSubsets - 1;
  V error = set(0.0f);
  for (std::size_t i = 0; i < 16; ++i) {
    const M is_second = isSecond(code, i);
    V from[3];
    V along[3];
    V projection = set(0.0f);
    V length2 = set(1e-9f);
    for (int c = 0; c < 3; ++c) {
      const V start =
          kSubsets == 1 ? lines.end[0][c] : hn::IfThenElse(is_second, lines.end[2 * kSecond][c], lines.end[0][c]);
      along[c] = kSubsets == 1 ? all_along[0][c] : hn::IfThenElse(is_second, all_along[kSecond][c], all_along[0][c]);
      from[c] = start + texels.middle[c];
      const V weighed = texels.channel_weight[i][c] * along[c];
      projection = projection + (texels.at[i][c] - start) * weighed;
      length2 = length2 + along[c] * weighed;
    }
    V last = set(i == 0 ? lastOfAnchor(kSubsets) : lastIndex(kSubsets));
    if (kSubsets == 2 && i > 0) last = hn::IfThenElse(isAnchor(code, i), set(lastOfAnchor(kSubsets)), last);
    const V near = hn::Min(hn::Max(projection * set(lastIndex(kSubsets)) / length2, set(0.0f)), last);
    const V lower = hn::Floor(near);
    const V upper = hn::Min(lower + set(1.0f), last);
    const V error_of_lower = errorOf<kSubsets>(texels, i, from, along, lower);
    const V error_of_upper = errorOf<kSubsets>(texels, i, from, along, upper);
    indices[i] = hn::IfThenElse(error_of_upper < error_of_lower, upper, lower);
    error = error + hn::Min(error_of_lower, error_of_upper);
  }
  return error;
}

/// An encoded block.
struct Encoded {
  V error;
  VU mode;
  VU code;     // of the partition
  V ends[12];  // quantised
  V indices[16];
};

template <int kSubsets>
HWY_INLINE void fitEndsTo(const Texels& texels, const V* indices, VU code, Lines& lines) {
  V shares[16];
  for (std::size_t i = 0; i < 16; ++i) shares[i] = shareOf<kSubsets>(indices[i]);
  fitEnds<kSubsets>(texels, shares, code, lines);
}

HWY_INLINE Encoded nothingYet() {
  Encoded none;
  none.error = set(1e30f);
  none.mode = none.code = hn::Zero(DU());
  for (V& end : none.ends) end = set(0.0f);
  for (V& index : none.indices) index = set(0.0f);
  return none;
}

HWY_NOINLINE void keepBetter(const Encoded& other, Encoded& best) {
  const M is_better = other.error < best.error;
  const auto is_better_bits = hn::RebindMask(DU(), is_better);
  best.error = hn::IfThenElse(is_better, other.error, best.error);
  best.mode = hn::IfThenElse(is_better_bits, other.mode, best.mode);
  best.code = hn::IfThenElse(is_better_bits, other.code, best.code);
  for (int e = 0; e < 12; ++e) best.ends[e] = hn::IfThenElse(is_better, other.ends[e], best.ends[e]);
  for (int i = 0; i < 16; ++i) best.indices[i] = hn::IfThenElse(is_better, other.indices[i], best.indices[i]);
}

template <int kSubsets>
HWY_NOINLINE Encoded encode(const Texels& texels, VU code, Lines lines, float slack) {
  Encoded made = nothingYet();
  const Mode mode = finestMode<kSubsets>(lines, slack);
  made.mode = mode.number;
  made.code = code;
  quantize(texels, mode, 2 * kSubsets, lines, made.ends);
  made.error = chooseIndices<kSubsets>(texels, lines, code, made.indices);
  return made;
}

template <int kSubsets>
HWY_NOINLINE void tryPartition(const Texels& texels, VU code, Encoded& best) {
  Lines lines = linesThrough<Bc6hFormat, kSubsets>(texels, code);
  const Encoded first = encode<kSubsets>(texels, code, lines, 1.0f);
  keepBetter(first, best);
  fitEndsTo<kSubsets>(texels, first.indices, code, lines);
  keepBetter(encode<kSubsets>(texels, code, lines, kSlack), best);
}

/// Fits ends once more, to the indices of the best.
template <int kSubsets>
HWY_NOINLINE void refine(const Texels& texels, Encoded& best) {
  const VU code = best.code;
  Lines lines;
  for (auto& end : lines.end)
    for (V& channel : end) channel = set(0.0f);
  fitEndsTo<kSubsets>(texels, best.indices, code, lines);
  keepBetter(encode<kSubsets>(texels, code, lines, kSlack), best);
  keepBetter(encode<kSubsets>(texels, code, lines, 1.0f), best);
}

/// Eight indices leave 1/49 of the squared distances along a line.
HWY_INLINE V misfitOf(const Moments& first, const Moments& second) {
  const Spread a = spreadOf(first);
  const Spread b = spreadOf(second);
  return (a.total + b.total) - set(48.0f / 49.0f) * (a.along + b.along);
}

}  // namespace

void searchBc6hLanes(const HalfBlockTexels& in, Bc6hFound& found) {
  for (std::size_t lane = 0; lane < kHalfBlockBatch; lane += hn::Lanes(D())) {
    const Texels texels = load<Bc6hFormat>(in, lane);
    Encoded best = nothingYet();
    tryPartition<1>(texels, hn::Zero(DU()), best);
    refine<1>(texels, best);

    Encoded best_of_two = nothingYet();
    VU codes[kTriedPartitions];
    choosePartitions<Bc6hFormat, kTriedPartitions>(texels, misfitOf, codes);
    for (const VU code : codes) tryPartition<2>(texels, code, best_of_two);
    refine<2>(texels, best_of_two);
    keepBetter(best_of_two, best);

    hn::Store(best.mode, DU(), &found.modes[lane]);
    hn::Store(hn::ShiftRight<24>(best.code), DU(), &found.partitions[lane]);
    for (std::size_t e = 0; e < 12; ++e) store(best.ends[e], &found.endpoints[e][lane]);
    for (std::size_t i = 0; i < 16; ++i) store(best.indices[i], &found.indices[i][lane]);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(searchBc6hLanes);

void searchBc6h(const HalfBlockTexels& texels, Bc6hFound& found) {
  HWY_DYNAMIC_DISPATCH(searchBc6hLanes)(texels, found);
}

}  // namespace mirrorball
#endif
