// A decoder interpolates between ends in numbers of 16 bits that stand for half floats, nearly the logarithm of light:
// there lines are fitted to the texels, by their spread and then by least squares. What they are worth is known by the
// error of the light that they decode to. The offset of base_and_offset is the same for all channels: along such a line
// light becomes brighter and keeps its hue.

#include "mirrorball/codec/uastc_hdr/uastc_hdr_search.h"

#include "mirrorball/base/vector_targets.h"
#include "mirrorball/codec/half_blocks/block_weights.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_colors.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_modes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/codec/uastc_hdr/uastc_hdr_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_UASTC_HDR_SEARCH_ONCE
#define MIRRORBALL_UASTC_HDR_SEARCH_ONCE
namespace mirrorball {

/// The partitions, as half_blocks/block_lines.inc has them; there are no anchors.
constexpr std::array<std::uint32_t, kUastcHdrPartitions.size()> kUastcHdrPartitionCodes = [] {
  std::array<std::uint32_t, kUastcHdrPartitions.size()> codes{};
  for (std::uint32_t i = 0; i < codes.size(); ++i) codes[i] = kUastcHdrPartitions[i].second() | i << 24;
  return codes;
}();

/// So many partitions, the best by a first estimate, are tried of each colour mode.
constexpr std::size_t kTriedPartitionsOfBase = 2;
constexpr std::size_t kTriedPartitionsOfTwo = 1;

/// A mode of kUastcHdrModes, which must be there.
constexpr std::uint32_t modeNumber(ColorMode color_mode, int subsets, int weights) {
  std::uint32_t number = 0;
  while (kUastcHdrModes[number].color_mode != color_mode || kUastcHdrModes[number].subsets != subsets ||
         kUastcHdrModes[number].weights != weights)
    ++number;
  return number;
}

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

#include "mirrorball/codec/half_blocks/block_lines.inc"

/// A number is twice a half float's bits, and a bit more in between two powers of two: uastc_hdr_block.cpp's curve and its
/// inverse, as what the number's and the half float's lower bits add.
struct UastcHdrFormat {
  static HWY_INLINE V halfOf(V number) {
    const V mantissa = number - hn::Floor(number * set(1.0f / 2048.0f)) * set(2048.0f);
    const V to_power = hn::Min(mantissa, set(2048.0f) - mantissa);
    return number * set(0.5f) - hn::Min(to_power * set(0.125f), set(64.0f));
  }
  static HWY_INLINE V numberOf(V half) {
    const V mantissa = half - hn::Floor(half * set(1.0f / 1024.0f)) * set(1024.0f);
    const V more = hn::Min(mantissa * set(2.0f / 3.0f), (set(1024.0f) - mantissa) * set(0.4f));
    return half + half + hn::Min(more, set(128.0f));
  }
  static constexpr const auto& kPartitionCodes = kUastcHdrPartitionCodes;
  static constexpr bool kHasAnchors = false;
};

/// The shares of the second end that a mode's weights stand for.
struct Shares {
  float last;  // weight
  alignas(64) float of[16];
};

HWY_INLINE Shares sharesOf(int weights) {
  const WeightLevels& levels = weightLevels(weights);
  Shares shares{static_cast<float>(weights - 1), {}};
  for (std::size_t i = 0; i < 16; ++i) shares.of[i] = static_cast<float>(levels.shares[i]) / 64.0f;
  return shares;
}

HWY_INLINE V shareOf(const Shares& shares, V weight) {
  return hn::GatherIndex(D(), shares.of, hn::ConvertTo(DS(), weight));
}

/// What two of UASTC HDR's subsets leave of squared distances where lines have any direction. Four weights leave 1/9 of
/// them along a line.
HWY_INLINE V misfitOfTwo(const Moments& first, const Moments& second) {
  const Spread a = spreadOf(first);
  const Spread b = spreadOf(second);
  return (a.total + b.total) - set(8.0f / 9.0f) * (a.along + b.along);
}

/// The same where all channels rise alike, for one subset; eight weights leave 1/49.
HWY_INLINE V misfitOfOffset(const Moments& moments) {
  const V* s = moments.sums;
  const V inverse = set(1.0f) / hn::Max(s[0], set(1e-6f));
  const V sum = s[1] + s[2] + s[3];
  const V squares = s[4] + s[5] + s[6];
  const V mixed = s[7] + s[8] + s[9];
  const V total = squares - (s[1] * s[1] + s[2] * s[2] + s[3] * s[3]) * inverse;
  const V along = (squares + mixed + mixed - sum * sum * inverse) * set(1.0f / 3.0f);
  return total - set(48.0f / 49.0f) * along;
}

HWY_INLINE V misfitOfBase(const Moments& first, const Moments& second) {
  return misfitOfOffset(first) + misfitOfOffset(second);
}

/// Lines along which all channels rise alike, as long as the texels reach.
template <int kSubsets>
HWY_NOINLINE Lines offsetLines(const Texels& texels, VU code) {
  Moments moments[2] = {noMoments(), noMoments()};
  for (std::size_t i = 0; i < 16; ++i) {
    const Moments texel = momentsOf(texels, i);
    add(texel, moments[0]);
    if (kSubsets == 1) continue;
    const M is_second = isSecond(code, i);
    for (int k = 0; k < 4; ++k) moments[1].sums[k] = moments[1].sums[k] + hn::IfThenElseZero(is_second, texel.sums[k]);
  }
  if (kSubsets == 2) moments[0] = difference(moments[0], moments[1]);
  Lines lines;
  for (int s = 0; s < kSubsets; ++s) {
    V mean[3];
    V middle = set(0.0f);
    for (int c = 0; c < 3; ++c) {
      mean[c] = moments[s].sums[c + 1] / hn::Max(moments[s].sums[0], set(1e-6f));
      middle = middle + mean[c] * set(1.0f / 3.0f);
    }
    V low = set(0.0f);
    V high = set(0.0f);
    for (std::size_t i = 0; i < 16; ++i) {
      V off = (texels.at[i][0] + texels.at[i][1] + texels.at[i][2]) * set(1.0f / 3.0f) - middle;
      if (kSubsets == 2) {
        const M is_second = isSecond(code, i);
        off = s == 1 ? hn::IfThenElseZero(is_second, off) : hn::IfThenZeroElse(is_second, off);
      }
      low = hn::Min(low, off);
      high = hn::Max(high, off);
    }
    for (int c = 0; c < 3; ++c) {
      lines.end[2 * s][c] = mean[c] + low;
      lines.end[2 * s + 1][c] = mean[c] + high;
    }
  }
  return lines;
}

/// The ends of lines along which all channels rise alike that come nearest to the texels with these shares: of each channel
/// x, least squares of x + share · offset. Lines whose texels all have one share stay as they are.
template <int kSubsets>
HWY_NOINLINE void fitOffsets(const Texels& texels, const V* shares, VU code, Lines& lines) {
  for (int s = 0; s < kSubsets; ++s) {
    V w[3], wb[3], wbb[3], wx[3], wbx[3];
    for (int c = 0; c < 3; ++c) w[c] = wb[c] = wbb[c] = wx[c] = wbx[c] = set(0.0f);
    for (std::size_t i = 0; i < 16; ++i)
      for (int c = 0; c < 3; ++c) {
        V weight = texels.channel_weight[i][c];
        if (kSubsets == 2) {
          const M is_second = isSecond(code, i);
          weight = s == 1 ? hn::IfThenElseZero(is_second, weight) : hn::IfThenZeroElse(is_second, weight);
        }
        const V weighed_share = weight * shares[i];
        w[c] = w[c] + weight;
        wb[c] = wb[c] + weighed_share;
        wbb[c] = wbb[c] + weighed_share * shares[i];
        wx[c] = wx[c] + weight * texels.at[i][c];
        wbx[c] = wbx[c] + weighed_share * texels.at[i][c];
      }
    V squares = set(0.0f);
    V products = set(0.0f);
    V all = set(0.0f);
    for (int c = 0; c < 3; ++c) {
      const V mean_share = wb[c] / hn::Max(w[c], set(kTiny));
      squares = squares + (wbb[c] - wb[c] * mean_share);
      products = products + (wbx[c] - wx[c] * mean_share);
      all = all + wbb[c];
    }
    const M is_solvable = squares > set(1e-4f) * all;
    const V offset = products / hn::IfThenElse(is_solvable, squares, set(1.0f));
    for (int c = 0; c < 3; ++c) {
      const V begin = (wx[c] - wb[c] * offset) / hn::Max(w[c], set(kTiny));
      lines.end[2 * s][c] = hn::IfThenElse(is_solvable, begin, lines.end[2 * s][c]);
      lines.end[2 * s + 1][c] = hn::IfThenElse(is_solvable, begin + offset, lines.end[2 * s + 1][c]);
    }
  }
}

/// Packs the ends into the mode's bytes, block by block, and makes the lines those that the bytes stand for.
template <int kSubsets>
HWY_NOINLINE void pack(const Texels& texels, const UastcHdrMode& mode, Lines& lines, V* colors) {
  alignas(64) float ends[4][3][kHalfBlockBatch];
  alignas(64) float bytes[12][kHalfBlockBatch];
  for (int e = 0; e < 2 * kSubsets; ++e)
    for (int c = 0; c < 3; ++c)
      hn::Store((lines.end[e][c] + texels.middle[c]) * set(1.0f / 16.0f), D(), ends[e][c]);
  const EndpointLevels& levels = endpointLevels(mode.endpoints);
  const auto step = static_cast<std::size_t>(numbersOf(mode.color_mode));
  for (std::size_t lane = 0; lane < hn::Lanes(D()); ++lane)
    for (std::size_t s = 0; s < kSubsets; ++s) {
      std::array<std::array<float, 3>, 2> wished;
      for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t c = 0; c < 3; ++c) wished[e][c] = ends[2 * s + e][c][lane];
      const PackedColors packed = packColors(mode.color_mode, wished, levels);
      for (std::size_t i = 0; i < step; ++i) bytes[s * step + i][lane] = static_cast<float>(packed.bytes[i]);
      for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t c = 0; c < 3; ++c) ends[2 * s + e][c][lane] = static_cast<float>(packed.ends[e][c]);
    }
  for (int e = 0; e < 2 * kSubsets; ++e)
    for (int c = 0; c < 3; ++c) lines.end[e][c] = hn::Load(D(), ends[e][c]) * set(16.0f) - texels.middle[c];
  for (std::size_t i = 0; i < 12; ++i) colors[i] = i < kSubsets * step ? hn::Load(D(), bytes[i]) : set(0.0f);
}

HWY_INLINE V errorOf(const Texels& texels, std::size_t i, const V* from, const V* along, V share) {
  V error = set(0.0f);
  for (int c = 0; c < 3; ++c) {
    const V off = lightOf<UastcHdrFormat>(from[c] + share * along[c]) - texels.light[i][c];
    error = error + off * off;
  }
  return error * texels.light_weight[i];
}

/// The best weight of every texel: of the two beside the nearest point of its line the one whose light is nearer.
///
/// returns  the error
template <int kSubsets>
HWY_NOINLINE V chooseWeights(const Texels& texels, const Lines& lines, VU code, const Shares& shares, V* weights) {
  constexpr int kSecond = kSubsets - 1;
  V error = set(0.0f);
  for (std::size_t i = 0; i < 16; ++i) {
    const M is_second = isSecond(code, i);
    V from[3];
    V along[3];
    V projection = set(0.0f);
    V length2 = set(1e-9f);
    for (int c = 0; c < 3; ++c) {
      V start = lines.end[0][c];
      V end = lines.end[1][c];
      if (kSubsets == 2) {
        start = hn::IfThenElse(is_second, lines.end[2 * kSecond][c], start);
        end = hn::IfThenElse(is_second, lines.end[2 * kSecond + 1][c], end);
      }
      along[c] = end - start;
      from[c] = start + texels.middle[c];
      const V weighed = texels.channel_weight[i][c] * along[c];
      projection = projection + (texels.at[i][c] - start) * weighed;
      length2 = length2 + along[c] * weighed;
    }
    const V near = hn::Min(hn::Max(projection * set(shares.last) / length2, set(0.0f)), set(shares.last));
    const V lower = hn::Floor(near);
    const V upper = hn::Min(lower + set(1.0f), set(shares.last));
    const V error_of_lower = errorOf(texels, i, from, along, shareOf(shares, lower));
    const V error_of_upper = errorOf(texels, i, from, along, shareOf(shares, upper));
    weights[i] = hn::IfThenElse(error_of_upper < error_of_lower, upper, lower);
    error = error + hn::Min(error_of_lower, error_of_upper);
  }
  return error;
}

/// An encoded block.
struct Encoded {
  V error;
  VU mode;  // of kUastcHdrModes
  VU code;  // of the partition
  V colors[12];
  V weights[16];
  V shares[16];  // that the weights stand for
};

HWY_NOINLINE void keepBetter(const Encoded& other, Encoded& best) {
  const M is_better = other.error < best.error;
  const auto is_better_bits = hn::RebindMask(DU(), is_better);
  best.error = hn::IfThenElse(is_better, other.error, best.error);
  best.mode = hn::IfThenElse(is_better_bits, other.mode, best.mode);
  best.code = hn::IfThenElse(is_better_bits, other.code, best.code);
  for (int i = 0; i < 12; ++i) best.colors[i] = hn::IfThenElse(is_better, other.colors[i], best.colors[i]);
  for (int i = 0; i < 16; ++i) {
    best.weights[i] = hn::IfThenElse(is_better, other.weights[i], best.weights[i]);
    best.shares[i] = hn::IfThenElse(is_better, other.shares[i], best.shares[i]);
  }
}

/// Encodes with lines near to those given.
template <ColorMode kColorMode, int kSubsets, int kWeights>
HWY_NOINLINE Encoded encode(const Texels& texels, VU code, Lines lines) {
  constexpr std::uint32_t kMode = modeNumber(kColorMode, kSubsets, kWeights);
  const Shares shares = sharesOf(kWeights);
  Encoded made;
  made.mode = hn::Set(DU(), kMode);
  made.code = code;
  pack<kSubsets>(texels, kUastcHdrModes[kMode], lines, made.colors);
  made.error = chooseWeights<kSubsets>(texels, lines, code, shares, made.weights);
  for (std::size_t i = 0; i < 16; ++i) made.shares[i] = shareOf(shares, made.weights[i]);
  return made;
}

template <ColorMode kColorMode, int kSubsets>
HWY_INLINE Lines fitted(const Texels& texels, const Encoded& encoded, VU code, Lines lines) {
  if constexpr (kColorMode == ColorMode::two_colors)
    fitEnds<kSubsets>(texels, encoded.shares, code, lines);
  else
    fitOffsets<kSubsets>(texels, encoded.shares, code, lines);
  return lines;
}

/// Encodes with the first of some counts of weights, fits lines to that, and encodes with all of them.
template <ColorMode kColorMode, int kSubsets, int kFirst, int... kOthers>
HWY_NOINLINE void tryLines(const Texels& texels, VU code, const Lines& lines, Encoded& best) {
  const Encoded first = encode<kColorMode, kSubsets, kFirst>(texels, code, lines);
  keepBetter(first, best);
  const Lines better = fitted<kColorMode, kSubsets>(texels, first, code, lines);
  const Encoded second = encode<kColorMode, kSubsets, kFirst>(texels, code, better);
  keepBetter(second, best);
  const Lines best_lines = fitted<kColorMode, kSubsets>(texels, second, code, better);
  keepBetter(encode<kColorMode, kSubsets, kFirst>(texels, code, best_lines), best);
  (keepBetter(encode<kColorMode, kSubsets, kOthers>(texels, code, best_lines), best), ...);
}

HWY_NOINLINE Encoded bestOf(const Texels& texels) {
  constexpr ColorMode kTwo = ColorMode::two_colors;
  constexpr ColorMode kBase = ColorMode::base_and_offset;
  const VU one = hn::Zero(DU());
  Encoded best = encode<kTwo, 1, 16>(texels, one, linesThrough<UastcHdrFormat, 1>(texels, one));
  tryLines<kTwo, 1, 16, 12>(texels, one, linesThrough<UastcHdrFormat, 1>(texels, one), best);
  tryLines<kBase, 1, 16>(texels, one, offsetLines<1>(texels, one), best);

  VU codes[kTriedPartitionsOfBase];
  choosePartitions<UastcHdrFormat, kTriedPartitionsOfBase>(texels, misfitOfBase, codes);
  for (const VU code : codes) tryLines<kBase, 2, 8, 6, 4>(texels, code, offsetLines<2>(texels, code), best);
  VU codes_of_two[kTriedPartitionsOfTwo];
  choosePartitions<UastcHdrFormat, kTriedPartitionsOfTwo>(texels, misfitOfTwo, codes_of_two);
  for (const VU code : codes_of_two)
    tryLines<kTwo, 2, 4, 3>(texels, code, linesThrough<UastcHdrFormat, 2>(texels, code), best);
  return best;
}

HWY_INLINE void store(V whole, std::uint32_t* to) {
  hn::Store(hn::BitCast(DU(), hn::ConvertTo(DS(), whole)), DU(), to);
}

}  // namespace

void searchUastcHdrLanes(const HalfBlockTexels& in, std::array<UastcHdrBlock, kHalfBlockBatch>& found) {
  alignas(64) std::uint32_t numbers[30][kHalfBlockBatch];
  for (std::size_t lane = 0; lane < kHalfBlockBatch; lane += hn::Lanes(D())) {
    const Encoded best = bestOf(load<UastcHdrFormat>(in, lane));
    hn::Store(best.mode, DU(), numbers[28] + lane);
    hn::Store(hn::ShiftRight<24>(best.code), DU(), numbers[29] + lane);
    for (std::size_t i = 0; i < 12; ++i) store(best.colors[i], numbers[i] + lane);
    for (std::size_t i = 0; i < 16; ++i) store(best.weights[i], numbers[12 + i] + lane);
  }
  for (std::size_t block = 0; block < kHalfBlockBatch; ++block) {
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(numbers[i][block]); };
    UastcHdrBlock& made = found[block] = {.mode = at(28), .partition = at(29)};
    for (std::size_t i = 0; i < 12; ++i) made.colors[i] = at(i);
    for (std::size_t i = 0; i < 16; ++i) made.weights[i] = at(12 + i);
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(searchUastcHdrLanes);

void searchUastcHdr(const HalfBlockTexels& texels, std::array<UastcHdrBlock, kHalfBlockBatch>& found) {
  HWY_DYNAMIC_DISPATCH(searchUastcHdrLanes)(texels, found);
  for (std::size_t block = 0; block < kHalfBlockBatch; ++block) {
    bool is_solid = true;
    for (std::size_t i = 3; i < 48; ++i) is_solid &= texels.halves[i][block] == texels.halves[i % 3][block];
    if (!is_solid) continue;
    found[block] = {.is_solid = true};
    for (std::size_t c = 0; c < 3; ++c) found[block].color[c] = texels.halves[c][block];
  }
}

}  // namespace mirrorball
#endif
