#include "mirrorball/codec/bc6h/bc6h.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/base/range.h"
#include "mirrorball/codec/bc6h/bc6h_block.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/half_blocks/half_rows.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using BlockBytes = std::array<std::uint8_t, kBc6hBlockSize>;
using testing::bytesOfTexture;
using ::testing::HasSubstr;

std::size_t blockBytes(const Image& image) {
  return std::size_t((image.width() + 3) / 4) * std::size_t((image.height() + 3) / 4) * kBc6hBlockSize;
}

Bytes encoded(const Image& image) {
  Bytes bytes(blockBytes(image));
  EXPECT_TRUE(encodeBc6h(image.samples(), image.channels(), image.width(), bytes));
  return bytes;
}

Image decoded(const Bytes& bytes, int width, int height) {
  Image image(width, height, 3);
  const std::size_t row = std::size_t((width + 3) / 4) * kBc6hBlockSize;
  for (int y = 0; y < height; y += 4) decodeBc6hRow(bytes.data() + std::size_t(y / 4) * row, false, y, image);
  return image;
}

Image throughBlocks(const Image& image) { return decoded(encoded(image), image.width(), image.height()); }

/// The greatest difference of a channel, as a share of its texel's brightest one.
float maxError(const Image& found, const Image& expected) {
  float max = 0.0f;
  for (int y = 0; y < expected.height(); ++y)
    for (int x = 0; x < expected.width(); ++x) {
      const glm::vec3 light = rgbAt(expected, x, y);
      const glm::vec3 off = glm::abs(rgbAt(found, x, y) - light);
      max = std::max(max, std::max({off.x, off.y, off.z}) / std::max({light.x, light.y, light.z, 1e-4f}));
    }
  return max;
}

/// Light of many powers of two, of which neighbours know nothing.
Image noise(int width, int height, int channels = 3) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> exponent(-6.0f, 6.0f);
  Image image(width, height, channels);
  for (float& sample : image.samples()) sample = std::exp2(exponent(random));
  return image;
}

/// Red, green and blue rise from 0.5 at different rates, by a few percent a texel.
Image ramp(int width, int height, int channels = 3) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.texel(x, y)[c] = 0.5f * std::exp2(0.02f * static_cast<float>(x + 2 * y) + 0.3f * static_cast<float>(c));
  return image;
}

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

TEST(Bc6h, BlackAndTheBrightestAreExact) {
  for (const float value : {0.0f, -0.0f, kLargestHalf}) {
    const Image image(8, 8, 3, value);
    EXPECT_EQ(maxError(throughBlocks(image), Image(8, 8, 3, std::abs(value))), 0.0f) << value;
  }
}

/// One colour needs no more than half a step of mode 14's ends, which have all 16 bits.
TEST(Bc6h, OneColourIsAHalfFloat) {
  for (const glm::vec3 color : {glm::vec3(1.0f), glm::vec3(0.003f, 2.0f, 700.0f), glm::vec3(65504.0f, 1e-4f, 0.25f)}) {
    Image image(4, 4, 3);
    for (int i = 0; i < 16; ++i)
      for (int c = 0; c < 3; ++c) image.texel(i % 4, i / 4)[c] = color[c];
    EXPECT_LT(maxError(throughBlocks(image), image), 1.0f / 1024.0f) << color.x << " " << color.y;
  }
}

TEST(Bc6h, SmoothLightIsNearlyExact) {
  const Image image = ramp(64, 32);
  EXPECT_LT(maxError(throughBlocks(image), image), 0.012f);
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
    EXPECT_LT(maxError(throughBlocks(image), image), 0.17f) << std::hex << partition;
  }
}

/// Sides that are no multiples of 4, down to one texel; as of the last mip levels.
TEST(Bc6h, AnySizeIsHeld) {
  for (const int width : {1, 2, 3, 4, 5, 67})
    for (const int height : {1, 2, 3, 4, 7}) {
      const Image image = ramp(width, height);
      ASSERT_LT(maxError(throughBlocks(image), image), 0.012f) << width << "x" << height;
    }
}

TEST(Bc6h, GreyAndAlphaAreTakenAndDropped) {
  Image grey(8, 4, 1);
  Image color(8, 4, 3);
  Image with_alpha(8, 4, 4);
  for (int i = 0; i < 32; ++i) {
    const float light = 0.5f + static_cast<float>(i) / 32.0f;
    grey.samples()[std::size_t(i)] = light;
    for (int c = 0; c < 3; ++c) color.texel(i % 8, i / 8)[c] = with_alpha.texel(i % 8, i / 8)[c] = light;
    with_alpha.texel(i % 8, i / 8)[3] = i % 2 > 0 ? -1.0f : std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_EQ(encoded(grey), encoded(color));
  EXPECT_EQ(encoded(with_alpha), encoded(color));
}

TEST(Bc6h, WhatDoesNotFitIsRefused) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float value :
       {-1e-30f, -1.0f, 65505.0f, 1e30f, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    Image image(5, 5, 3, 1.0f);
    image.texel(4, 4)[1] = value;
    Bytes bytes(blockBytes(image));
    EXPECT_FALSE(encodeBc6h(image.samples(), 3, 5, bytes)) << value;
    EXPECT_THAT(bytes, ::testing::Each(0)) << value;
  }
}

/// What the file holds is what the encoder makes of each image by itself, at any level, face and layer.
TEST(Bc6hFile, EveryContainerAndShapeComesBack) {
  struct Container {
    const char* name;
    Bytes (*write)(const ImageSet&);
  };
  const Container containers[] = {
      {"KTX2", [](const ImageSet& set) { return bytesOfTexture(writeKtx2, set, {.format = TexelFormat::bc6h}); }},
      {"DDS", [](const ImageSet& set) { return bytesOfTexture(writeDds, set, {.format = TexelFormat::bc6h}); }}};
  for (const Container& container : containers)
    for (const int faces : {1, 6})
      for (const int levels : {1, 4})
        for (const int layers : {1, 2}) {
          SCOPED_TRACE(container.name + std::string(" faces ") + std::to_string(faces) + " levels " +
                       std::to_string(levels) + " layers " + std::to_string(layers));
          const ImageSet images = testing::textureOf(levels, faces, layers, 3, faces == 6 ? 9 : 11, 9);
          const auto read = decodeImageSet(container.write(images));
          ASSERT_TRUE(read) << read.error().message;
          EXPECT_THAT(read->format, HasSubstr(", bc6h ufloat"));
          ASSERT_EQ(read->images.levels(), levels);
          for (int level = 0; level < levels; ++level)
            for (int layer = 0; layer < layers; ++layer)
              for (int face = 0; face < faces; ++face) {
                const Image& image = images.at(level, face, layer);
                const Image& found = read->images.at(level, face, layer);
                ASSERT_EQ(found.width(), image.width());
                ASSERT_EQ(found.height(), image.height());
                ASSERT_TRUE(areEqual(found.samples(), throughBlocks(image).samples()));
              }
        }
}

/// A KTX 2 header says what the specification wants of this format: no numbers with a byte order, blocks of 4 x 4.
TEST(Bc6hFile, Ktx2SaysWhatItHolds) {
  const Bytes file = bytesOfTexture(writeKtx2, testing::textureOf(3, 6, 1, 3, 8, 8), {.format = TexelFormat::bc6h});
  EXPECT_EQ(littleU32(file.data() + 12), 143u) << "VK_FORMAT_BC6H_UFLOAT_BLOCK";
  EXPECT_EQ(littleU32(file.data() + 16), 1u) << "typeSize";
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(littleU64(file.data() + 80 + 24 * level) % 16, 0u) << "levels begin at whole blocks";
    EXPECT_EQ(littleU64(file.data() + 88 + 24 * level), level == 0 ? 6u * 4 * 16 : 6u * 16);
  }
  const Bytes expected = {44,  0, 0,   0,    0, 0, 0,    0,
                          2,   0, 40,  0,                        // size, vendor and type, version 2, size of the block
                          133, 1, 1,   0,    3, 3, 0,    0,      // KHR_DF_MODEL_BC6H, BT709, linear; 4 x 4 texels
                          16,  0, 0,   0,    0, 0, 0,    0,      // bytes of a block
                          0,   0, 127, 0x80, 0, 0, 0,    0,      // 128 bits of colour, unsigned floats
                          0,   0, 0,   0,    0, 0, 0x80, 0x3f};  // from 0 to 1
  const std::uint32_t at = littleU32(file.data() + 48);
  EXPECT_EQ(Bytes(file.data() + at, file.data() + at + 44), expected);
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

  const Image grey = ramp(4, 4);
  Bytes file = bytesOfTexture(writeDds, ImageSet(grey), {.format = TexelFormat::bc6h});
  file[128] = 94;  // DXGI_FORMAT_BC6H_TYPELESS
  const auto typeless = decodeImageSet(file);
  ASSERT_TRUE(typeless) << typeless.error().message;
  EXPECT_EQ(typeless->format, "DDS, bc6h ufloat");
  EXPECT_LT(maxError(typeless->images.at(0, 0), grey), 0.012f);
}

using Bc6hFileTest = testing::FolderTest;

/// Strips as `convert` makes them put the same bytes where the whole does.
TEST_F(Bc6hFileTest, StripsGiveTheSameFile) {
  const Image image = noise(1030, 22);
  for (const std::string name : {"whole.ktx2", "whole.dds"}) {
    const TextureWriteOptions options{.format = TexelFormat::bc6h};
    ASSERT_TRUE(writeImageSet(folder_ / name, ImageSet(image), options));
    auto writer = TextureWriter::create(folder_ / ("strips_" + name), {1030, 22}, 1, 3, options);
    ASSERT_TRUE(writer) << writer.error().message;
    for (const glm::ivec2 begin : {glm::ivec2(1024, 16), glm::ivec2(0, 0), glm::ivec2(1024, 0), glm::ivec2(0, 16)}) {
      Image strip(std::min(1024, 1030 - begin.x), std::min(16, 22 - begin.y), 3);
      for (int y = 0; y < strip.height(); ++y)
        std::copy_n(image.texel(begin.x, begin.y + y), 3 * strip.width(), strip.texel(0, y));
      ASSERT_TRUE(writer->write(0, begin, strip));
    }
    ASSERT_TRUE(writer->commit());
    EXPECT_TRUE(*readFile(folder_ / name) == *readFile(folder_ / ("strips_" + name))) << name;
  }
}

TEST_F(Bc6hFileTest, AnyNumberOfThreadsGivesTheSameFile) {
  const ImageSet images(noise(512, 128));
  const TextureWriteOptions options{.format = TexelFormat::bc6h};
  ASSERT_TRUE(writeImageSet(folder_ / "many.ktx2", images, options));
  const testing::OneThread one;
  ASSERT_TRUE(writeImageSet(folder_ / "one.ktx2", images, options));
  EXPECT_TRUE(*readFile(folder_ / "one.ktx2") == *readFile(folder_ / "many.ktx2"));
}

TEST_F(Bc6hFileTest, TheFirstMisfitIsNamed) {
  Image image(2000, 40, 3, 1.0f);
  image.texel(3, 39)[0] = 1e6f;
  image.texel(1999, 17)[2] = -2.0f;
  const auto result = writeImageSet(folder_ / "a.ktx2", ImageSet(image), {.format = TexelFormat::bc6h});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::out_of_range);
  EXPECT_THAT(result.error().message, HasSubstr("texel (1999, 17) of level 0 is 1 1 -2, but bc6h holds 0 to 65504"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ktx2"));
}

}  // namespace
}  // namespace mirrorball
