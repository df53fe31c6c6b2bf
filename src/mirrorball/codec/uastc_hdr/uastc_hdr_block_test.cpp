#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/uastc_hdr/uastc_hdr_colors.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"

namespace mirrorball {
namespace {

using Block = std::array<std::uint8_t, kHalfBlockSize>;
using Halves = std::array<std::uint16_t, 48>;

/// So many bits from `at` on.
void setBits(Block& block, int at, int count, std::uint32_t bits) {
  for (int i = 0; i < count; ++i) {
    std::uint8_t& byte = block[std::size_t((at + i) / 8)];
    const int bit = (at + i) % 8;
    byte = static_cast<std::uint8_t>((byte & ~(1 << bit)) | (bits >> i & 1u) << bit);
  }
}

Block blockOfHex(std::string_view digits) {
  Block block;
  for (std::size_t i = 0; i < block.size(); ++i)
    block[i] = static_cast<std::uint8_t>(std::stoi(std::string(digits.substr(2 * i, 2)), nullptr, 16));
  return block;
}

/// Any block of a mode.
UastcHdrBlock randomBlock(std::uint8_t mode_index, std::mt19937& random) {
  const auto below = [&](int bound) { return static_cast<std::size_t>(random() % static_cast<unsigned>(bound)); };
  const UastcHdrMode& mode = kUastcHdrModes[mode_index];
  UastcHdrBlock block{.mode = mode_index};
  if (mode.subsets == 2) block.partition = static_cast<std::uint8_t>(below(kUastcHdrPartitions.size()));
  for (std::size_t i = 0; i < std::size_t(mode.numbers()); ++i)
    block.colors[i] = endpointLevels(mode.endpoints).values[below(mode.endpoints)];
  for (std::uint8_t& weight : block.weights) weight = static_cast<std::uint8_t>(below(mode.weights));
  return block;
}

TEST(UastcHdrBlock, PartsComeBack) {
  std::mt19937 random(5);
  for (std::uint8_t mode = 0; mode < kUastcHdrModes.size(); ++mode)
    for (int round = 0; round < 300; ++round) {
      const UastcHdrBlock block = randomBlock(mode, random);
      Block bytes;
      writeUastcHdrBlock(block, bytes);
      const auto read = readUastcHdrBlock(bytes);
      const auto step = static_cast<std::size_t>(numbersOf(kUastcHdrModes[mode].color_mode));
      bool is_finite = true;
      for (std::size_t at = 0; at < std::size_t(kUastcHdrModes[mode].numbers()); at += step)
        is_finite &=
            areFinite(unpackColors(kUastcHdrModes[mode].color_mode, std::span(block.colors).subspan(at, step)));
      ASSERT_EQ(read.has_value(), is_finite);
      if (!read) continue;
      ASSERT_EQ(read->mode, block.mode);
      ASSERT_EQ(read->partition, block.partition);
      ASSERT_EQ(read->colors, block.colors);
      ASSERT_EQ(read->weights, block.weights);
    }
}

/// A block of every kind, and its first and last texel as both astcenc 4.2.0 and Basis Universal's transcoder (of
/// three.js 0.187) decode it. The containers' test has many more of each.
TEST(UastcHdrBlock, EveryKindDecodesAsOthersDo) {
  struct Vector {
    std::string_view block;
    std::array<std::uint16_t, 6> halves;
  };
  constexpr Vector kVectors[] = {
      {"51606132e3dd43ab01000000400c2da9", {12800, 30640, 15040, 19552, 30400, 21696}},
      {"4260b9e4226329fa00000000b1ddf1aa", {10332, 10279, 9924, 10613, 10508, 10279}},
      {"5260fb0b6c177b5e00000098d9f96a8f", {14268, 13804, 14046, 14293, 13812, 14146}},
      {"4360c1b0636d14210000405d2846908f", {9632, 11264, 9472, 9257, 10900, 8991}},
      {"53600dd14577d5dc00005fc08c2fb532", {19089, 18891, 18678, 19492, 19176, 18968}},
      {"4162c946c387f6b60140a79ace467a89", {17432, 16456, 19552, 13384, 13432, 16408}},
      {"5162033ca2c5c37640c629ca11e48286", {28678, 27968, 27834, 28630, 27925, 27808}},
      {"42626d54f85cbb2d336666c9689cf6fd", {10688, 7264, 18880, 11312, 8768, 15856}},
      {"51e05cb779a501000000000080aae707", {20480, 16480, 28096, 21600, 17600, 29248}},
      {"42e07abc9cd80000000000006de050c2", {11204, 10672, 10928, 10585, 10151, 10378}},
      {"52e0f4114db5000000000020fbfd5a63", {7360, 1024, 4800, 0, 0, 0}},
      {"43e0f46129810100000000d170d4e8a7", {24768, 7424, 3108, 31168, 12288, 5120}},
      {"53e0843bca9b0000000088d7bcba5de0", {5904, 6400, 8288, 1024, 1472, 3328}},
      {"41e2cc5bb178010000786b484dfb62ca", {11381, 14291, 12700, 10516, 13423, 11860}},
      {"51e24af54e1c010000b53f9adc6a8ef6", {26111, 25279, 25887, 24444, 23617, 24183}},
      {"42e28833ec870000621e5597e197e3ce", {1444, 3300, 4925, 1791, 3635, 5254}},
      {"51c8099612dcb541aa0550521c6a491a", {12808, 12450, 12450, 10816, 0, 9664}},
      {"424806d6d9466527ba48fc042dfa4402", {17856, 6192, 22288, 14486, 15073, 3172}},
      {"51481a0eb82aa36db800b01580e47c10", {1344, 1072, 1344, 2792, 2464, 2792}},
      {"428867ee575e89689800ed10b080c451", {12321, 12024, 9709, 11968, 11712, 9408}},
      {"528802eed56a1d4c45bc70255ab6992c", {10912, 10816, 11288, 2352, 2368, 2656}},
      {"438813ae188ffed73e0e51592a84335b", {14888, 6696, 19426, 18334, 10142, 22770}},
      {"5308098ee4da2d89b361db1f16cd70bb", {28673, 28595, 28194, 30186, 29835, 29799}},
      {"fcffffffffffffffe361c3104844003c", {25059, 4291, 17480, 25059, 4291, 17480}},
  };
  std::set<int> kinds;
  for (const Vector& vector : kVectors) {
    const Block block = blockOfHex(vector.block);
    Halves halves;
    ASSERT_TRUE(decodeUastcHdrBlock(block, halves)) << vector.block;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(halves[c], vector.halves[c]) << vector.block;
      EXPECT_EQ(halves[45 + c], vector.halves[3 + c]) << vector.block;
    }
    const auto read = readUastcHdrBlock(block);
    ASSERT_TRUE(read);
    kinds.insert(read->is_solid ? -1 : read->mode);
    Block again;
    writeUastcHdrBlock(*read, again);
    EXPECT_EQ(again, block) << vector.block;
  }
  EXPECT_EQ(kinds.size(), kUastcHdrModes.size() + 1) << "each is of another kind";
}

/// By hand: four weights a texel, and each channel of both ends as it is, 8 bits, of blue 7: red from 0 to 2, green 1,
/// blue 0.25. Weights 0, 1, 2, 3 stand for 0, 21, 43 and 64 64ths.
TEST(UastcHdrBlock, OneByHand) {
  Block block{};
  setBits(block, 5, 2, 2);  // the grid of weights has 4 × 4
  setBits(block, 0, 2, 2);  // four levels: 100 in binary, of which the lowest bit stands at bit 4
  setBits(block, 13, 4, 11);
  // Half floats of 1, 2 and 0.25 are 15, 16 and 13 times 1024: numbers of 16 bits twice that, and of 8 bits 120, 128,
  // 104.
  const std::array<std::uint8_t, 6> colors{0, 128, 120, 120, 0x80 | 52, 0x80 | 52};
  for (int i = 0; i < 6; ++i) setBits(block, 17 + 8 * i, 8, colors[std::size_t(i)]);
  for (int texel = 0; texel < 16; ++texel) {
    const unsigned weight = static_cast<unsigned>(texel) % 4;
    setBits(block, 127 - 2 * texel, 1, weight & 1u);
    setBits(block, 126 - 2 * texel, 1, weight >> 1);
  }
  Halves halves;
  ASSERT_TRUE(decodeUastcHdrBlock(block, halves));
  // 32768 · 21/64 = 10752 is 5 · 2048 + 512, whose mantissa becomes 3 · 512 / 8; 32768 · 43/64 = 22016 is
  // 10 · 2048 + 1536, which becomes (5 · 1536 − 2048) / 8.
  constexpr std::array<std::uint16_t, 4> kRed{0, 5 * 1024 + 192, 10 * 1024 + 704, 16 * 1024};
  for (std::size_t texel = 0; texel < 16; ++texel) {
    EXPECT_EQ(halves[3 * texel], kRed[texel % 4]) << texel;
    EXPECT_EQ(halves[3 * texel + 1], 0x3c00) << texel;
    EXPECT_EQ(halves[3 * texel + 2], 0x3400) << texel;
  }
}

TEST(UastcHdrBlock, OneColourIsExact) {
  for (const std::array<std::uint16_t, 3> color :
       {std::array<std::uint16_t, 3>{0, 1, 0x7bff}, {0x3c00, 0x3555, 0x0400}}) {
    Block bytes;
    writeUastcHdrBlock({.is_solid = true, .color = color}, bytes);
    EXPECT_EQ(bytes[0], 0xfc);
    Halves halves;
    ASSERT_TRUE(decodeUastcHdrBlock(bytes, halves));
    for (std::size_t i = 0; i < 48; ++i) ASSERT_EQ(halves[i], color[i % 3]);
  }
}

/// Other ASTC, and what is no ASTC: none of it is decoded to something.
TEST(UastcHdrBlock, OthersAreRefused) {
  Block solid;
  writeUastcHdrBlock({.is_solid = true, .color = {0x3c00, 0x3c00, 0x3c00}}, solid);
  std::mt19937 random(9);
  const auto one_subset = [&] {
    UastcHdrBlock block = randomBlock(4, random);
    block.colors = {10, 20, 10, 20, 0x80 | 10, 0x80 | 20};
    Block bytes;
    writeUastcHdrBlock(block, bytes);
    return bytes;
  }();
  const auto two_subsets = [&] {
    UastcHdrBlock block = randomBlock(16, random);
    block.colors = {};
    Block bytes;
    writeUastcHdrBlock(block, bytes);
    return bytes;
  }();
  for (const Block& block : {solid, one_subset, two_subsets}) ASSERT_TRUE(readUastcHdrBlock(block));
  struct Change {
    const char* what;
    Block block;
    int at;
    int count;
    std::uint32_t bits;
  };
  for (const Change& change :
       {Change{"8-bit colour", solid, 9, 1, 0}, Change{"a reserved bit", solid, 10, 1, 0},
        Change{"an empty extent", solid, 12, 13, 0x1fff - 1}, Change{"infinity", solid, 64, 16, 0x7c00},
        Change{"NaN", solid, 80, 16, 0x7e00}, Change{"negative", solid, 96, 16, 0x8001},
        Change{"two planes", one_subset, 10, 1, 1}, Change{"fewer weights", one_subset, 5, 2, 0},
        Change{"a wider grid", one_subset, 2, 2, 1}, Change{"2 levels", one_subset, 0, 5, 1},
        Change{"20 levels", one_subset, 0, 11, 0x253}, Change{"a reserved mode", one_subset, 0, 4, 0},
        Change{"three subsets", one_subset, 11, 2, 2}, Change{"four subsets", one_subset, 11, 2, 3},
        Change{"8-bit ends", one_subset, 13, 4, 8}, Change{"ends with alpha", one_subset, 13, 4, 14},
        Change{"light that is not finite", one_subset, 25, 8, 0xff},
        Change{"a partition that BC6H lacks", two_subsets, 13, 10, 1},
        Change{"two ways of storing ends", two_subsets, 23, 2, 2}}) {
    Block block = change.block;
    setBits(block, change.at, change.count, change.bits);
    Halves halves;
    halves.fill(1);
    EXPECT_FALSE(decodeUastcHdrBlock(block, halves)) << change.what;
    EXPECT_THAT(halves, ::testing::Each(1)) << change.what;
  }
}

/// Whatever the bits are, what is decoded is finite and not negative.
TEST(UastcHdrBlock, AnyBitsAreSurvived) {
  std::mt19937 random(13);
  int decoded = 0;
  for (int round = 0; round < 200000; ++round) {
    Block block;
    for (std::uint8_t& byte : block) byte = static_cast<std::uint8_t>(random());
    // Every other one says that it is a grid of 4 × 4 in one or two subsets.
    if (round % 2 > 0) {
      setBits(block, 2, 2, 0);
      setBits(block, 5, 4, 2);
      setBits(block, 10, 3, std::uint32_t(random() % 2 << 1));
    }
    Halves halves;
    if (!decodeUastcHdrBlock(block, halves)) continue;
    ++decoded;
    ASSERT_LT(*std::max_element(halves.begin(), halves.end()), 0x7c00);
  }
  EXPECT_GT(decoded, 1000);
}

}  // namespace
}  // namespace mirrorball
