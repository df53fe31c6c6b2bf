#include "mirrorball/codec/uastc_hdr/uastc_hdr_colors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mirrorball {
namespace {

using Bytes6 = std::array<std::uint8_t, 6>;
using FloatEnds = std::array<std::array<float, 3>, 2>;

/// A place of a bit in a block's bytes or in a field.
struct BitPlace {
  std::uint8_t of;
  std::uint8_t bit;
};

/// How a colour mode shares out the bits of its bytes that lie above the fields' lowest ones.
template <std::size_t kFields, std::size_t kExtra>
struct Submode {
  int shift;                           // of all fields, up to 12 bits
  std::array<int, kFields> bits;       // of each field
  std::array<BitPlace, kExtra> extra;  // the field and its bit that stands in each of the extra places
};

/// Where the fields of all submodes of a colour mode stand.
template <std::size_t kFields, std::size_t kExtra>
struct Places {
  std::array<std::uint8_t, kFields> byte;  // of each field's lowest bits
  std::array<int, kFields> low_bits;       // so many
  std::array<BitPlace, kExtra> extra;
};

// Fields of two_colors: the largest channel of the second end; how much less the two others are; how much less the
// largest channel of the first end is; how much less yet the others of that are, which is signed.
enum { kA, kB0, kB1, kC, kD0, kD1 };
constexpr Places<6, 6> kPlacesOfTwo{
    {0, 2, 3, 1, 4, 5}, {8, 6, 6, 6, 5, 5}, {{{2, 6}, {3, 6}, {4, 6}, {5, 6}, {4, 5}, {5, 5}}}};
using SubmodeOfTwo = Submode<6, 6>;
constexpr std::array<SubmodeOfTwo, 8> kSubmodesOfTwo{{
    {3, {9, 7, 7, 6, 7, 7}, {{{kB0, 6}, {kB1, 6}, {kD0, 6}, {kD1, 6}, {kD0, 5}, {kD1, 5}}}},
    {3, {9, 8, 8, 6, 6, 6}, {{{kB0, 6}, {kB1, 6}, {kB0, 7}, {kB1, 7}, {kD0, 5}, {kD1, 5}}}},
    {2, {10, 6, 6, 7, 7, 7}, {{{kA, 9}, {kC, 6}, {kD0, 6}, {kD1, 6}, {kD0, 5}, {kD1, 5}}}},
    {2, {10, 7, 7, 7, 6, 6}, {{{kB0, 6}, {kB1, 6}, {kA, 9}, {kC, 6}, {kD0, 5}, {kD1, 5}}}},
    {1, {11, 8, 8, 6, 5, 5}, {{{kB0, 6}, {kB1, 6}, {kB0, 7}, {kB1, 7}, {kA, 9}, {kA, 10}}}},
    {1, {11, 6, 6, 8, 6, 6}, {{{kA, 9}, {kA, 10}, {kC, 7}, {kC, 6}, {kD0, 5}, {kD1, 5}}}},
    {0, {12, 7, 7, 7, 5, 5}, {{{kB0, 6}, {kB1, 6}, {kA, 11}, {kC, 6}, {kA, 9}, {kA, 10}}}},
    {0, {12, 6, 6, 7, 6, 6}, {{{kA, 9}, {kA, 10}, {kA, 11}, {kC, 6}, {kD0, 5}, {kD1, 5}}}},
}};

// Fields of base_and_offset: the largest channel of the second end; how much less the others are, or in the last
// submode these themselves; how much less all channels of the first end are.
enum { kRed, kGreen, kBlue, kScale };
constexpr Places<4, 7> kPlacesOfBase{
    {0, 1, 2, 3}, {6, 5, 5, 5}, {{{1, 6}, {1, 5}, {2, 6}, {2, 5}, {3, 7}, {3, 6}, {3, 5}}}};
using SubmodeOfBase = Submode<4, 7>;
constexpr std::size_t kDirectBase = 5;
constexpr std::array<SubmodeOfBase, 6> kSubmodesOfBase{{
    {1, {11, 5, 5, 7}, {{{kRed, 9}, {kRed, 8}, {kRed, 7}, {kRed, 10}, {kRed, 6}, {kScale, 6}, {kScale, 5}}}},
    {1, {11, 6, 6, 5}, {{{kRed, 8}, {kGreen, 5}, {kRed, 7}, {kBlue, 5}, {kRed, 6}, {kRed, 10}, {kRed, 9}}}},
    {2, {10, 5, 5, 8}, {{{kRed, 9}, {kRed, 8}, {kRed, 7}, {kRed, 6}, {kScale, 7}, {kScale, 6}, {kScale, 5}}}},
    {3, {9, 6, 6, 7}, {{{kRed, 8}, {kGreen, 5}, {kRed, 7}, {kBlue, 5}, {kRed, 6}, {kScale, 6}, {kScale, 5}}}},
    {4, {8, 7, 7, 6}, {{{kGreen, 6}, {kGreen, 5}, {kBlue, 6}, {kBlue, 5}, {kRed, 6}, {kRed, 7}, {kScale, 5}}}},
    {5, {7, 7, 7, 7}, {{{kGreen, 6}, {kGreen, 5}, {kBlue, 6}, {kBlue, 5}, {kRed, 6}, {kScale, 6}, {kScale, 5}}}},
}};

constexpr int bitOf(int value, int bit) { return value >> bit & 1; }
constexpr int lowBits(int value, int count) { return value & ((1 << count) - 1); }

/// Takes the fields from their bytes.
template <std::size_t kFields, std::size_t kExtra>
std::array<int, kFields> fieldsOf(const Submode<kFields, kExtra>& submode, const Places<kFields, kExtra>& places,
                                  std::span<const std::uint8_t> bytes) {
  std::array<int, kFields> fields;
  for (std::size_t i = 0; i < kFields; ++i) fields[i] = lowBits(bytes[places.byte[i]], places.low_bits[i]);
  for (std::size_t i = 0; i < kExtra; ++i)
    fields[submode.extra[i].of] |= bitOf(bytes[places.extra[i].of], places.extra[i].bit) << submode.extra[i].bit;
  return fields;
}

/// Puts the value of a field, which it can hold, to its places, and rounds the byte of its lowest bits. The fields must
/// come in an order in which all other bits of that byte are there already; the upper three are not rounded.
///
/// returns  the field's value as it stands there
template <std::size_t kFields, std::size_t kExtra>
int putField(const Submode<kFields, kExtra>& submode, const Places<kFields, kExtra>& places, std::size_t field,
             int value, const EndpointLevels& levels, Bytes6& bytes) {
  for (std::size_t i = 0; i < kExtra; ++i)
    if (submode.extra[i].of == field)
      bytes[places.extra[i].of] = static_cast<std::uint8_t>(bytes[places.extra[i].of] |
                                                            bitOf(value, submode.extra[i].bit) << places.extra[i].bit);
  std::uint8_t& byte = bytes[places.byte[field]];
  const int count = places.low_bits[field];
  byte = levels.nearest[std::size_t(byte | lowBits(value, count))];
  return value - lowBits(value, count) + lowBits(byte, count);
}

/// The two channels beside the largest one, in the order of their fields: that one and red change places.
constexpr std::array<std::size_t, 2> othersThan(std::size_t largest) {
  return {largest == 1 ? std::size_t{0} : std::size_t{1}, largest == 2 ? std::size_t{0} : std::size_t{2}};
}

int in12Bits(int number) { return std::clamp(number, 0, 0xfff); }

/// The ends of fields in numbers of 12 bits.
ColorEnds endsOfTwo(const std::array<int, 6>& f, std::size_t largest) {
  ColorEnds ends;
  ends[1][largest] = in12Bits(f[kA]);
  ends[0][largest] = in12Bits(f[kA] - f[kC]);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t channel = othersThan(largest)[i];
    ends[1][channel] = in12Bits(f[kA] - f[kB0 + i]);
    ends[0][channel] = in12Bits(f[kA] - f[kB0 + i] - f[kC] - f[kD0 + i]);
  }
  return ends;
}

ColorEnds endsOfBase(const std::array<int, 4>& f, std::size_t largest, bool is_direct) {
  ColorEnds ends;
  ends[1][largest] = f[kRed];
  for (std::size_t i = 0; i < 2; ++i)
    ends[1][othersThan(largest)[i]] = is_direct ? f[kGreen + i] : f[kRed] - f[kGreen + i];
  for (std::size_t c = 0; c < 3; ++c) {
    ends[0][c] = in12Bits(ends[1][c] - f[kScale]);
    ends[1][c] = in12Bits(ends[1][c]);
  }
  return ends;
}

ColorEnds unpackTwoColors(std::span<const std::uint8_t> bytes) {
  const auto largest = static_cast<std::size_t>(bitOf(bytes[4], 7) | bitOf(bytes[5], 7) << 1);
  if (largest == 3)
    return {{{bytes[0] << 4, bytes[2] << 4, lowBits(bytes[4], 7) << 5},
             {bytes[1] << 4, bytes[3] << 4, lowBits(bytes[5], 7) << 5}}};
  const int number = bitOf(bytes[1], 7) | bitOf(bytes[2], 7) << 1 | bitOf(bytes[3], 7) << 2;
  const SubmodeOfTwo& submode = kSubmodesOfTwo[std::size_t(number)];
  std::array<int, 6> f = fieldsOf(submode, kPlacesOfTwo, bytes);
  f[kA] |= bitOf(bytes[1], 6) << 8;
  for (const std::size_t d : {std::size_t(kD0), std::size_t(kD1)})
    if (bitOf(f[d], submode.bits[d] - 1) != 0) f[d] -= 1 << submode.bits[d];
  for (int& field : f) field *= 1 << submode.shift;
  return endsOfTwo(f, largest);
}

ColorEnds unpackBaseAndOffset(std::span<const std::uint8_t> bytes) {
  const int number = bytes[0] >> 6 | bitOf(bytes[1], 7) << 2 | bitOf(bytes[2], 7) << 3;
  const bool is_direct = number == 15;
  const int upper = number >> 2;
  const auto largest = static_cast<std::size_t>(is_direct ? 0 : upper < 3 ? upper : number & 3);
  const std::size_t index = is_direct ? kDirectBase : upper < 3 ? std::size_t(number & 3) : 4;
  std::array<int, 4> f = fieldsOf(kSubmodesOfBase[index], kPlacesOfBase, bytes);
  for (int& field : f) field *= 1 << kSubmodesOfBase[index].shift;
  return endsOfBase(f, largest, is_direct);
}

/// The nearest whole number; of what is above −4096.
int rounded(float value) { return static_cast<int>(value + 4096.5f) - 4096; }

/// The steps from one colour to another that a field can hold.
int stepsWithin(float value, float step, int least, int most) { return std::clamp(rounded(value / step), least, most); }

/// The largest value of a field of so many bits; and of one that is a colour, which must be finite light.
int mostOf(int bits) { return (1 << bits) - 1; }
int mostOfColor(int bits, int shift) { return std::min(mostOf(bits), kLargestColor >> shift); }

std::size_t largestChannel(const std::array<float, 3>& color) {
  return static_cast<std::size_t>(std::max_element(color.begin(), color.end()) - color.begin());
}

/// Whether fields of these bits reach from end to end; ends[1][largest] is the most of all.
bool reaches(const SubmodeOfTwo& submode, const FloatEnds& ends, std::size_t largest) {
  const float step = static_cast<float>(1 << submode.shift);
  const float c = ends[1][largest] - ends[0][largest];
  if (c > step * static_cast<float>(mostOf(submode.bits[kC]))) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t channel = othersThan(largest)[i];
    const float b = ends[1][largest] - ends[1][channel];
    const float d = ends[1][channel] - ends[0][channel] - c;
    if (b > step * static_cast<float>(mostOf(submode.bits[kB0]))) return false;
    if (std::abs(d) > step * static_cast<float>(mostOf(submode.bits[kD0] - 1))) return false;
  }
  return true;
}

PackedColors packedTwo(std::size_t number, const FloatEnds& ends, std::size_t largest, const EndpointLevels& levels) {
  const SubmodeOfTwo& submode = kSubmodesOfTwo[number];
  const float step = static_cast<float>(1 << submode.shift);
  PackedColors packed;
  for (std::size_t i = 0; i < 3; ++i) packed.bytes[1 + i] = static_cast<std::uint8_t>((number >> i & 1u) << 7);
  for (std::size_t i = 0; i < 2; ++i) packed.bytes[4 + i] = static_cast<std::uint8_t>((largest >> i & 1u) << 7);
  std::array<int, 6> f;  // as they stand there
  const auto put = [&](std::size_t field, float value) {
    const bool is_signed = field >= kD0;
    const int bits = submode.bits[field] - (is_signed ? 1 : 0);
    const int most = field == kA ? mostOfColor(bits, submode.shift) : mostOf(bits);
    const int steps = stepsWithin(value, step, is_signed ? -(1 << bits) : 0, most);
    const int there = putField(submode, kPlacesOfTwo, field, lowBits(steps, submode.bits[field]), levels, packed.bytes);
    f[field] = (is_signed && there > mostOf(bits) ? there - (2 << bits) : there) << submode.shift;
    return static_cast<float>(f[field]);
  };
  // Bit 8 of the largest channel has a place of its own.
  const int a_steps = stepsWithin(ends[1][largest], step, 0, mostOfColor(submode.bits[kA], submode.shift));
  packed.bytes[1] = static_cast<std::uint8_t>(packed.bytes[1] | bitOf(a_steps, 8) << 6);
  // What is lost in one field is made good in the next ones.
  const float a = put(kA, ends[1][largest]);
  const float c = put(kC, a - ends[0][largest]);
  for (std::size_t i = 0; i < 2; ++i) put(kB0 + i, a - ends[1][othersThan(largest)[i]]);
  for (std::size_t i = 0; i < 2; ++i)
    put(kD0 + i, a - static_cast<float>(f[kB0 + i]) - c - ends[0][othersThan(largest)[i]]);
  packed.ends = endsOfTwo(f, largest);
  return packed;
}

/// A byte's nearest level that is not above `most`.
std::uint8_t levelUpTo(const EndpointLevels& levels, int byte, int most) {
  byte = std::min(byte, most);
  while (levels.nearest[std::size_t(byte)] > most) --byte;
  return levels.nearest[std::size_t(byte)];
}

/// Each channel of both ends by itself: 8 bits, of blue 7.
PackedColors packedDirectTwo(const FloatEnds& ends, const EndpointLevels& levels) {
  PackedColors packed;
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t c = 0; c < 2; ++c)
      packed.bytes[2 * c + end] = levelUpTo(levels, rounded(ends[end][c] / 16.0f), kLargestColor >> 4);
    packed.bytes[4 + end] =
        levelUpTo(levels, 0x80 | std::min(rounded(ends[end][2] / 32.0f), 0x7f), 0x80 | kLargestColor >> 5);
  }
  packed.ends = unpackTwoColors(packed.bytes);
  return packed;
}

PackedColors packTwoColors(FloatEnds ends, const EndpointLevels& levels) {
  // The second end is the one with the largest channel of all.
  if (ends[0][largestChannel(ends[0])] > ends[1][largestChannel(ends[1])]) std::swap(ends[0], ends[1]);
  const std::size_t largest = largestChannel(ends[1]);
  // From the finest to the coarsest.
  for (std::size_t number = kSubmodesOfTwo.size(); number-- > 0;) {
    if (!reaches(kSubmodesOfTwo[number], ends, largest)) continue;
    const PackedColors packed = packedTwo(number, ends, largest, levels);
    if (areFinite(packed.ends)) return packed;
  }
  return packedDirectTwo(ends, levels);
}

/// Whether fields of these bits reach from the largest channel of the base to the others, and over the offset.
bool reaches(const SubmodeOfBase& submode, const std::array<float, 3>& base, float offset) {
  const float step = static_cast<float>(1 << submode.shift);
  const float least = *std::min_element(base.begin(), base.end());
  const float difference = base[largestChannel(base)] - least;
  return difference <= step * static_cast<float>(mostOf(submode.bits[kGreen])) &&
         offset <= step * static_cast<float>(mostOf(submode.bits[kScale]));
}

PackedColors packedBase(std::size_t number, const std::array<float, 3>& base, float offset,
                        const EndpointLevels& levels) {
  const SubmodeOfBase& submode = kSubmodesOfBase[number];
  const bool is_direct = number == kDirectBase;
  const float step = static_cast<float>(1 << submode.shift);
  const std::size_t largest = is_direct ? 0 : largestChannel(base);
  const std::size_t code = is_direct ? 15 : number < 4 ? largest << 2 | number : 12 | largest;
  PackedColors packed;
  packed.bytes = {static_cast<std::uint8_t>((code & 3u) << 6), static_cast<std::uint8_t>((code >> 2 & 1u) << 7),
                  static_cast<std::uint8_t>((code >> 3) << 7)};
  std::array<int, 4> f;  // as they stand there
  const auto put = [&](std::size_t field, float value) {
    const bool is_color = field == kRed || (is_direct && field != kScale);
    const int bits = submode.bits[field];
    const int steps = stepsWithin(value, step, 0, is_color ? mostOfColor(bits, submode.shift) : mostOf(bits));
    f[field] = putField(submode, kPlacesOfBase, field, steps, levels, packed.bytes) << submode.shift;
    return static_cast<float>(f[field]);
  };
  const float red = put(kRed, base[largest]);
  for (std::size_t i = 0; i < 2; ++i) {
    const float other = base[othersThan(largest)[i]];
    put(kGreen + i, is_direct ? other : red - other);
  }
  put(kScale, offset);
  packed.ends = endsOfBase(f, largest, is_direct);
  return packed;
}

PackedColors packBaseAndOffset(const FloatEnds& ends, const EndpointLevels& levels) {
  float difference = 0.0f;
  for (std::size_t c = 0; c < 3; ++c) difference += (ends[1][c] - ends[0][c]) / 3.0f;
  const float offset = std::abs(difference);
  std::array<float, 3> base;
  for (std::size_t c = 0; c < 3; ++c) base[c] = std::max(0.5f * (ends[0][c] + ends[1][c] + offset), 0.0f);
  for (std::size_t number = 0; number < kDirectBase; ++number) {
    if (!reaches(kSubmodesOfBase[number], base, offset)) continue;
    const PackedColors packed = packedBase(number, base, offset, levels);
    if (areFinite(packed.ends)) return packed;
  }
  // The coarsest reaches everywhere, but its last numbers are no finite light.
  PackedColors packed = packedBase(kDirectBase, base, offset, levels);
  for (float most = static_cast<float>(kLargestColor); !areFinite(packed.ends); most -= 32.0f) {
    for (float& channel : base) channel = std::min(channel, most);
    packed = packedBase(kDirectBase, base, offset, levels);
  }
  return packed;
}

}  // namespace

ColorEnds unpackColors(ColorMode mode, std::span<const std::uint8_t> bytes) {
  return mode == ColorMode::two_colors ? unpackTwoColors(bytes) : unpackBaseAndOffset(bytes);
}

bool areFinite(const ColorEnds& ends) {
  return std::all_of(ends.begin(), ends.end(), [](const std::array<int, 3>& end) {
    return *std::max_element(end.begin(), end.end()) <= kLargestColor;
  });
}

PackedColors packColors(ColorMode mode, const std::array<std::array<float, 3>, 2>& ends, const EndpointLevels& levels) {
  FloatEnds within = ends;
  for (auto& end : within)
    for (float& channel : end) channel = std::clamp(channel, 0.0f, static_cast<float>(kLargestColor));
  return mode == ColorMode::two_colors ? packTwoColors(within, levels) : packBaseAndOffset(within, levels);
}

}  // namespace mirrorball
