#include "mirrorball/codec/bc6h/bc6h.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/range.h"
#include "mirrorball/codec/bc6h/bc6h_block.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/half_blocks/half_blocks_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using BlockBytes = std::array<std::uint8_t, kBc6hBlockSize>;
using testing::bytesOfTexture;

Image throughBc6h(const Image& image) { return testing::throughBlocks(testing::kBc6hCodec, image); }

/// What stands in a block comes back: every mode with random contents, in every partition.
TEST(Bc6hBlock, PartsComeBack) {
  std::mt19937 random(5);
  const auto below = [&](int bound) { return static_cast<int>(random() % static_cast<unsigned>(bound)); };
  for (int mode_index = 0; mode_index < 14; ++mode_index)
    for (int round = 0; round < 320; ++round) {
      const Bc6hMode& mode = kBc6hModes[std::size_t(mode_index)];
      Bc6hBlock block{.mode = mode_index, .partition = mode.subsets == 2 ? round % 32 : 0};
      for (std::size_t c = 0; c < 6 * std::size_t(mode.subsets); ++c) {
        const int range = 1 << mode.bitsOf(c);
        const int first = block.endpoints[c % 3];
        block.endpoints[c] = below(range);
        // A sum may not leave the range, or it would be another that does not.
        if (c >= 3 && mode.is_delta)
          block.endpoints[c] = std::clamp(first + block.endpoints[c] - range / 2, 0, (1 << mode.bits) - 1);
      }
      const int indices = 1 << bc6hIndexBits(mode.subsets);
      for (std::uint8_t& index : block.indices) index = static_cast<std::uint8_t>(below(indices));
      block.indices[0] /= 2;
      if (mode.subsets == 2) block.indices[kBc6hAnchors[std::size_t(block.partition)]] /= 2;
      BlockBytes bytes;
      writeBc6hBlock(block, bytes);
      const auto read = readBc6hBlock(bytes, false);
      ASSERT_TRUE(read);
      ASSERT_EQ(read->mode, block.mode);
      ASSERT_EQ(read->partition, block.partition);
      ASSERT_EQ(read->endpoints, block.endpoints);
      ASSERT_EQ(read->indices, block.indices);
    }
}

TEST(Bc6hBlock, ReservedModesAreBlack) {
  for (const int code : {0x13, 0x17, 0x1b, 0x1f}) {
    BlockBytes bytes;
    bytes.fill(0xff);
    bytes[0] = static_cast<std::uint8_t>(0xe0 | code);
    for (const bool is_signed : {false, true}) {
      std::array<std::uint16_t, 48> halves;
      halves.fill(1);
      decodeBc6hBlock(bytes, is_signed, halves);
      EXPECT_THAT(halves, ::testing::Each(0)) << code;
    }
  }
}

/// By hand: mode 11, whose ends are 10 bits each, from 0 to 1023 in red, 1023 to 0 in green and 512 in blue; the
/// indices are 0 to 7, 8, …, 15, of which the first has three bits.
TEST(Bc6hBlock, OneByHand) {
  std::uint64_t low = 0x03;
  low |= std::uint64_t{1023} << 15;  // gw
  low |= std::uint64_t{512} << 25;   // bw
  low |= std::uint64_t{1023} << 35;  // rx
  low |= std::uint64_t{512} << 55;   // bx: nine bits of 0, and the last one is the first of the second half
  std::uint64_t high = 1;
  for (std::uint64_t i = 1; i < 16; ++i) high |= i << 4 * i;
  BlockBytes bytes;
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[i] = static_cast<std::uint8_t>(low >> 8 * i);
    bytes[8 + i] = static_cast<std::uint8_t>(high >> 8 * i);
  }
  constexpr int kWeights[16] = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};
  std::array<std::uint16_t, 48> halves;
  decodeBc6hBlock(bytes, false, halves);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(halves[3 * i], (0xffff * kWeights[i] + 32) / 64 * 31 / 64) << i;
    EXPECT_EQ(halves[3 * i + 1], (0xffff * (64 - kWeights[i]) + 32) / 64 * 31 / 64) << i;
    EXPECT_EQ(halves[3 * i + 2], ((512 << 16) + 0x8000) / 1024 * 31 / 64) << i;
  }
  EXPECT_EQ(halves[45], 0x7bff) << "65504";
}

/// One colour needs no more than half a step of mode 14's ends, which have all 16 bits.
TEST(Bc6h, OneColourIsAHalfFloat) {
  for (const glm::vec3 color : {glm::vec3(1.0f), glm::vec3(0.003f, 2.0f, 700.0f), glm::vec3(65504.0f, 1e-4f, 0.25f)}) {
    Image image(4, 4, 3);
    for (int i = 0; i < 16; ++i)
      for (int c = 0; c < 3; ++c) image.texel(i % 4, i / 4)[c] = color[c];
    EXPECT_LT(testing::maxHalfError(throughBc6h(image), image), 1.0f / 1024.0f) << color.x << " " << color.y;
  }
}

/// Two colours three octaves apart, in the shape of each partition: only two subsets, or one line, can be so near.
TEST(Bc6h, EveryPartitionIsFound) {
  for (const std::uint16_t partition : kBc6hPartitions) {
    Image image(4, 4, 3);
    for (int i = 0; i < 16; ++i) {
      const bool is_second = partition >> i & 1;
      const float change = 1.0f + 0.02f * static_cast<float>(i % 3);
      const glm::vec3 color = (is_second ? glm::vec3(4.0f, 0.5f, 1.0f) : glm::vec3(0.5f, 1.0f, 4.0f)) * change;
      for (int c = 0; c < 3; ++c) image.texel(i % 4, i / 4)[c] = color[c];
    }
    EXPECT_LT(testing::maxHalfError(throughBc6h(image), image), 0.17f) << std::hex << partition;
  }
}

TEST(Bc6hFile, DdsSaysWhatItHolds) {
  const Bytes file = bytesOfTexture(writeDds, testing::textureOf(2, 1, 1, 3, 9, 5), {.format = TexelFormat::bc6h});
  ASSERT_EQ(file.size(), 148u + 6 * 16 + 16);
  EXPECT_EQ(littleU32(file.data() + 8), 0xa1007u) << "dwFlags: caps, size, pixel format, mips, linear size";
  EXPECT_EQ(littleU32(file.data() + 20), 6u * 16) << "dwPitchOrLinearSize";
  EXPECT_EQ(littleU32(file.data() + 128), 95u) << "DXGI_FORMAT_BC6H_UF16";
  EXPECT_EQ(littleU32(file.data() + 144), 3u) << "opaque";
}

/// Signed files are read, as is DDS's form that does not say.
TEST(Bc6hFile, OtherFormsAreRead) {
  Bytes ktx2 = bytesOfTexture(writeKtx2, ImageSet(Image(4, 4, 3, 1.0f)), {.format = TexelFormat::bc6h});
  // Mode 11 with all its bits: red and green from −1 to −1, and blue from the largest.
  const BlockBytes block = {0x03 | 0xe0, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1, 0, 0, 0, 0, 0, 0, 0};
  std::copy(block.begin(), block.end(), ktx2.end() - 16);
  ktx2[12] = 144;
  const auto is_signed = decodeImageSet(ktx2);
  ASSERT_TRUE(is_signed) << is_signed.error().message;
  EXPECT_EQ(is_signed->format, "KTX2, bc6h sfloat");
  EXPECT_LT(is_signed->images.at(0, 0).texel(0, 0)[0], 0.0f);

  const Image grey = testing::colorRamp(4, 4);
  Bytes file = bytesOfTexture(writeDds, ImageSet(grey), {.format = TexelFormat::bc6h});
  file[128] = 94;  // DXGI_FORMAT_BC6H_TYPELESS
  const auto typeless = decodeImageSet(file);
  ASSERT_TRUE(typeless) << typeless.error().message;
  EXPECT_EQ(typeless->format, "DDS, bc6h ufloat");
  EXPECT_LT(testing::maxHalfError(typeless->images.at(0, 0), grey), 0.012f);
}

}  // namespace
}  // namespace mirrorball
