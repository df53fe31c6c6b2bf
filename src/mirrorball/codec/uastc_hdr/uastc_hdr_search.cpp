// A decoder interpolates between ends in numbers of 16 bits that stand for half floats, nearly the logarithm of light:
// there lines are fitted to the texels, by their spread and then by least squares. What they are worth is known by the
// error of the light that they decode to. The offset of base_and_offset is the same for all channels: along such a line
// light becomes brighter and keeps its hue.

#include "mirrorball/codec/uastc_hdr/uastc_hdr_search.h"

#include <span>

#include "mirrorball/base/vector_targets.h"
#include "mirrorball/codec/bc6h/bc6h_modes.h"
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

/// The weight of BC6H that the transcoder takes for one of ASTC: the nearest, of two the one farther from the middle.
constexpr int nearestInBc6h(int share, int subsets) {
  const int bits = bc6hIndexBits(subsets);
  int nearest = 0;
  for (int index = 0; index < 1 << bits; ++index) {
    const int weight = bc6hWeight(index, bits);
    const int off = (weight < share ? share - weight : weight - share) * 2 - (weight >= 32 ? 1 : 0);
    const int least = (nearest < share ? share - nearest : nearest - share) * 2 - (nearest >= 32 ? 1 : 0);
    if (off < least) nearest = weight;
  }
  return nearest;
}

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

#include "mirrorball/codec/half_blocks/block_lines.inc"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_lines.inc"

/// The shares of the second end that a mode's weights stand for, in ASTC and in BC6H.
struct Shares {
  float last;  // weight
  alignas(64) float of[16];
  alignas(64) float in_bc6h[16];
};

HWY_INLINE Shares sharesOf(int subsets, int weights) {
  const WeightLevels& levels = weightLevels(weights);
  Shares shares{static_cast<float>(weights - 1), {}, {}};
  for (std::size_t i = 0; i < 16; ++i) {
    shares.of[i] = static_cast<float>(levels.shares[i]) / 64.0f;
    shares.in_bc6h[i] = static_cast<float>(nearestInBc6h(levels.shares[i], subsets)) / 64.0f;
  }
  return shares;
}

HWY_INLINE V shareOf(const float* shares, V weight) {
  return hn::GatherIndex(D(), shares, hn::ConvertTo(DS(), weight));
}

/// Packs the ends into the mode's bytes, block by block, and makes the lines those that the bytes stand for.
template <int kSubsets>
HWY_NOINLINE void pack(const Texels& texels, const UastcHdrMode& mode, Lines& lines, V* colors) {
  alignas(64) float ends[4][3][kHalfBlockBatch];
  alignas(64) float bytes[12][kHalfBlockBatch];
  for (int e = 0; e < 2 * kSubsets; ++e)
    for (int c = 0; c < 3; ++c) hn::Store((lines.end[e][c] + texels.middle[c]) * set(1.0f / 16.0f), D(), ends[e][c]);
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

/// A line of one texel's subset, in what a decoder interpolates.
struct TexelLine {
  V from[3];
  V along[3];
};

template <int kSubsets>
HWY_INLINE TexelLine lineOf(const Lines& lines, M is_second) {
  constexpr int kSecond = 2 * (kSubsets - 1);
  TexelLine line;
  for (int c = 0; c < 3; ++c) {
    V end = lines.end[1][c];
    line.from[c] = lines.end[0][c];
    if (kSubsets == 2) {
      line.from[c] = hn::IfThenElse(is_second, lines.end[kSecond][c], line.from[c]);
      end = hn::IfThenElse(is_second, lines.end[kSecond + 1][c], end);
    }
    line.along[c] = end - line.from[c];
  }
  return line;
}

/// What a GPU that has ASTC HDR and one that has BC6H get wrong together.
HWY_INLINE V errorOf(const Texels& texels, std::size_t i, const TexelLine& line, const TexelLine& in_bc6h,
                     const Shares& shares, V weight) {
  const V share = shareOf(shares.of, weight);
  const V share_in_bc6h = shareOf(shares.in_bc6h, weight);
  V error = set(0.0f);
  for (int c = 0; c < 3; ++c) {
    const V light = lightOf<UastcHdrFormat>(line.from[c] + texels.middle[c] + share * line.along[c]);
    const V light_in_bc6h = lightOfHalf(in_bc6h.from[c] + share_in_bc6h * in_bc6h.along[c]);
    const V off = light - texels.light[i][c];
    const V off_in_bc6h = light_in_bc6h - texels.light[i][c];
    error = error + (off * off + off_in_bc6h * off_in_bc6h);
  }
  return error * texels.light_weight[i];
}

/// The best weight of every texel: of the two beside the nearest point of its line the one with the smaller error.
///
/// returns  the error
template <int kSubsets>
HWY_NOINLINE V chooseWeights(const Texels& texels, const Lines& lines, VU code, const Shares& shares, V* weights) {
  const Lines all_in_bc6h = transcoded<kSubsets>(texels, lines);
  V error = set(0.0f);
  for (std::size_t i = 0; i < 16; ++i) {
    const M is_second = isSecond(code, i);
    const TexelLine line = lineOf<kSubsets>(lines, is_second);
    const TexelLine in_bc6h = lineOf<kSubsets>(all_in_bc6h, is_second);
    V projection = set(0.0f);
    V length2 = set(1e-9f);
    for (int c = 0; c < 3; ++c) {
      const V weighed = texels.channel_weight[i][c] * line.along[c];
      projection = projection + (texels.at[i][c] - line.from[c]) * weighed;
      length2 = length2 + line.along[c] * weighed;
    }
    const V near = hn::Min(hn::Max(projection * set(shares.last) / length2, set(0.0f)), set(shares.last));
    const V lower = hn::Floor(near);
    const V upper = hn::Min(lower + set(1.0f), set(shares.last));
    const V error_of_lower = errorOf(texels, i, line, in_bc6h, shares, lower);
    const V error_of_upper = errorOf(texels, i, line, in_bc6h, shares, upper);
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
  const Shares shares = sharesOf(kSubsets, kWeights);
  Encoded made;
  made.mode = hn::Set(DU(), kMode);
  made.code = code;
  pack<kSubsets>(texels, kUastcHdrModes[kMode], lines, made.colors);
  made.error = chooseWeights<kSubsets>(texels, lines, code, shares, made.weights);
  for (std::size_t i = 0; i < 16; ++i) made.shares[i] = shareOf(shares.of, made.weights[i]);
  return made;
}

template <ColorMode kColorMode, int kSubsets>
HWY_INLINE Lines fitted(const Texels& texels, const Encoded& encoded, Lines lines) {
  if constexpr (kColorMode == ColorMode::two_colors)
    fitEnds<kSubsets>(texels, encoded.shares, encoded.code, lines);
  else
    fitOffsets<kSubsets>(texels, encoded.shares, encoded.code, lines);
  return lines;
}

HWY_INLINE Encoded nothingYet() {
  Encoded none;
  none.error = set(1e30f);
  none.mode = none.code = hn::Zero(DU());
  for (V& color : none.colors) color = set(0.0f);
  for (std::size_t i = 0; i < 16; ++i) none.weights[i] = none.shares[i] = set(0.0f);
  return none;
}

template <ColorMode kColorMode, int kSubsets>
HWY_INLINE Lines linesOf(const Texels& texels, VU code) {
  if constexpr (kColorMode == ColorMode::two_colors)
    return linesThrough<UastcHdrFormat, kSubsets>(texels, code);
  else
    return offsetLines<kSubsets>(texels, code);
}

/// Encodes in each of some partitions with the first of some counts of weights; fits lines to the best of these, and
/// encodes them with all counts.
template <ColorMode kColorMode, int kSubsets, int kFirst, int... kOthers>
HWY_NOINLINE void tryPartitions(const Texels& texels, std::span<const VU> codes, Encoded& best) {
  Encoded first = nothingYet();
  for (const VU code : codes)
    keepBetter(encode<kColorMode, kSubsets, kFirst>(texels, code, linesOf<kColorMode, kSubsets>(texels, code)), first);
  keepBetter(first, best);
  const Lines lines = fitted<kColorMode, kSubsets>(texels, first, linesOf<kColorMode, kSubsets>(texels, first.code));
  keepBetter(encode<kColorMode, kSubsets, kFirst>(texels, first.code, lines), best);
  (keepBetter(encode<kColorMode, kSubsets, kOthers>(texels, first.code, lines), best), ...);
}

HWY_NOINLINE Encoded bestOf(const Texels& texels) {
  constexpr ColorMode kTwo = ColorMode::two_colors;
  constexpr ColorMode kBase = ColorMode::base_and_offset;
  Encoded best = nothingYet();
  const VU whole[] = {hn::Zero(DU())};
  tryPartitions<kTwo, 1, 16, 12>(texels, whole, best);
  tryPartitions<kBase, 1, 16>(texels, whole, best);
  VU codes[kTriedPartitionsOfBase];
  choosePartitions<UastcHdrFormat, kTriedPartitionsOfBase>(texels, misfitOfBase, codes);
  tryPartitions<kBase, 2, 8, 6>(texels, codes, best);
  VU codes_of_two[kTriedPartitionsOfTwo];
  choosePartitions<UastcHdrFormat, kTriedPartitionsOfTwo>(texels, misfitOfTwo, codes_of_two);
  tryPartitions<kTwo, 2, 4, 3>(texels, codes_of_two, best);
  return best;
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
