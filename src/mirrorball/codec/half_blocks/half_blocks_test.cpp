/// What all kinds of compressed blocks of half floats have in common, and how they stand in files.
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>

#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/base/range.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/half_blocks/half_blocks_testing.h"
#include "mirrorball/codec/half_blocks/half_rows.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOfTexture;
using testing::colorRamp;
using testing::encodedBlocks;
using testing::halfBlockBytes;
using testing::HalfBlockCodec;
using ::testing::HasSubstr;
using testing::maxHalfError;
using testing::octaveNoise;
using testing::throughBlocks;

constexpr auto kNameOfCodec = [](const auto& codec) { return std::string(codec.param.name); };

using HalfBlocks = ::testing::TestWithParam<HalfBlockCodec>;

TEST_P(HalfBlocks, BlackAndTheBrightestAreExact) {
  for (const float value : {0.0f, -0.0f, kLargestHalf}) {
    const Image image(8, 8, 3, value);
    EXPECT_EQ(maxHalfError(throughBlocks(GetParam(), image), Image(8, 8, 3, std::abs(value))), 0.0f) << value;
  }
}

TEST_P(HalfBlocks, SmoothLightIsNearlyExact) {
  const Image image = colorRamp(64, 32);
  EXPECT_LT(maxHalfError(throughBlocks(GetParam(), image), image), 0.012f);
}

/// Texels of a sun beside dark ones: what is bright stays bright, and what is dark does not shine.
TEST_P(HalfBlocks, ASunBesideTheDarkKeepsItsLight) {
  for (const int sun_texels : {1, 3, 8}) {
    Image image(4, 4, 3, 0.01f);
    for (int i = 0; i < sun_texels; ++i)
      for (int c = 0; c < 3; ++c) image.texel(i % 4, i / 4)[c] = 6e4f;
    const Image found = throughBlocks(GetParam(), image);
    for (int i = 0; i < 16; ++i) {
      const float* const texel = found.texel(i % 4, i / 4);
      for (int c = 0; c < 3; ++c) {
        if (i < sun_texels)
          EXPECT_NEAR(texel[c], 6e4f, 6e3f) << sun_texels << " texels, " << i;
        else
          EXPECT_LT(texel[c], 600.0f) << sun_texels << " texels, " << i;
      }
    }
  }
}

/// Random light of the widest range gives finite light that is not negative.
TEST_P(HalfBlocks, TheWidestRangeIsSurvived) {
  std::mt19937 random(3);
  Image image(64, 64, 3);
  for (float& sample : image.samples())
    sample = std::min(std::exp2(static_cast<float>(random() % 32) - 15.5f), 65504.0f);
  const Image found = throughBlocks(GetParam(), image);
  for (const float sample : found.samples()) ASSERT_TRUE(sample >= 0.0f && sample <= 65504.0f) << sample;
}

/// Sides that are no multiples of 4, down to one texel; as of the last mip levels.
TEST_P(HalfBlocks, AnySizeIsHeld) {
  for (const int width : {1, 2, 3, 4, 5, 67})
    for (const int height : {1, 2, 3, 4, 7}) {
      const Image image = colorRamp(width, height);
      ASSERT_LT(maxHalfError(throughBlocks(GetParam(), image), image), 0.012f) << width << "x" << height;
    }
}

TEST_P(HalfBlocks, GreyAndAlphaAreTakenAndDropped) {
  Image grey(8, 4, 1);
  Image color(8, 4, 3);
  Image with_alpha(8, 4, 4);
  for (int i = 0; i < 32; ++i) {
    const float light = 0.5f + static_cast<float>(i) / 32.0f;
    grey.samples()[std::size_t(i)] = light;
    for (int c = 0; c < 3; ++c) color.texel(i % 8, i / 8)[c] = with_alpha.texel(i % 8, i / 8)[c] = light;
    with_alpha.texel(i % 8, i / 8)[3] = i % 2 > 0 ? -1.0f : std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_EQ(encodedBlocks(GetParam(), grey), encodedBlocks(GetParam(), color));
  EXPECT_EQ(encodedBlocks(GetParam(), with_alpha), encodedBlocks(GetParam(), color));
}

TEST_P(HalfBlocks, WhatDoesNotFitIsRefused) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float value :
       {-1e-30f, -1.0f, 65505.0f, 1e30f, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    Image image(5, 5, 3, 1.0f);
    image.texel(4, 4)[1] = value;
    Bytes bytes(halfBlockBytes(image));
    EXPECT_FALSE(GetParam().encode(image.samples(), 3, 5, bytes)) << value;
    EXPECT_THAT(bytes, ::testing::Each(0)) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, HalfBlocks, ::testing::Values(testing::kBc6hCodec, testing::kUastcHdrCodec),
                         kNameOfCodec);

class HalfBlockFile : public testing::FolderTest, public ::testing::WithParamInterface<HalfBlockCodec> {};

/// What the file holds is what the encoder makes of each image by itself, at any level, face and layer.
TEST_P(HalfBlockFile, EveryContainerAndShapeComesBack) {
  using Write = Result<void>(const ImageSet&, const TextureWriteOptions&, const WriteAt&);
  struct Container {
    const char* extension;
    Write* write;
  };
  for (const Container& container : {Container{"ktx2", writeKtx2}, Container{"dds", writeDds}})
    for (const int faces : {1, 6})
      for (const int levels : {1, 4})
        for (const int layers : {1, 2}) {
          if (!holdsFormat(container.extension, GetParam().format)) continue;
          SCOPED_TRACE(container.extension + std::string(" faces ") + std::to_string(faces) + " levels " +
                       std::to_string(levels) + " layers " + std::to_string(layers));
          const ImageSet images = testing::textureOf(levels, faces, layers, 3, faces == 6 ? 9 : 11, 9);
          const auto read = decodeImageSet(bytesOfTexture(container.write, images, {.format = GetParam().format}));
          ASSERT_TRUE(read) << read.error().message;
          EXPECT_THAT(read->format, HasSubstr(", " + std::string(GetParam().in_files)));
          ASSERT_EQ(read->images.levels(), levels);
          for (int level = 0; level < levels; ++level)
            for (int layer = 0; layer < layers; ++layer)
              for (int face = 0; face < faces; ++face) {
                const Image& image = images.at(level, face, layer);
                const Image& found = read->images.at(level, face, layer);
                ASSERT_EQ(found.width(), image.width());
                ASSERT_EQ(found.height(), image.height());
                ASSERT_TRUE(areEqual(found.samples(), throughBlocks(GetParam(), image).samples()));
              }
        }
}

/// A KTX 2 header says what the specification wants of these formats: no numbers with a byte order, blocks of 4 x 4.
/// Three.js and Basis Universal tell UASTC HDR from other ASTC by the colour model.
TEST_P(HalfBlockFile, Ktx2SaysWhatItHolds) {
  const Bytes file = bytesOfTexture(writeKtx2, testing::textureOf(3, 6, 1, 3, 8, 8), {.format = GetParam().format});
  EXPECT_EQ(littleU32(file.data() + 12), GetParam().vk_format);
  EXPECT_EQ(littleU32(file.data() + 16), 1u) << "typeSize";
  for (std::size_t level = 0; level < 3; ++level) {
    EXPECT_EQ(littleU64(file.data() + 80 + 24 * level) % 16, 0u) << "levels begin at whole blocks";
    EXPECT_EQ(littleU64(file.data() + 88 + 24 * level), level == 0 ? 6u * 4 * 16 : 6u * 16);
  }
  const Bytes expected = {44,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          2,
                          0,
                          40,
                          0,  // size, vendor and type, version 2, size of the block
                          GetParam().color_model,
                          1,
                          1,
                          0,
                          3,
                          3,
                          0,
                          0,  // BT709, linear; 4 x 4 texels
                          16,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,  // bytes of a block
                          0,
                          0,
                          127,
                          0x80,
                          0,
                          0,
                          0,
                          0,  // 128 bits of colour, unsigned floats
                          0,
                          0,
                          0,
                          0,
                          0,
                          0,
                          0x80,
                          0x3f};  // from 0 to 1
  const std::uint32_t at = littleU32(file.data() + 48);
  EXPECT_EQ(Bytes(file.data() + at, file.data() + at + 44), expected);
}

/// Strips as `convert` makes them put the same bytes where the whole does.
TEST_P(HalfBlockFile, StripsGiveTheSameFile) {
  const Image image = octaveNoise(1030, 22);
  for (const std::string extension : {"ktx2", "dds"}) {
    if (!holdsFormat(extension, GetParam().format)) continue;
    const std::string name = "whole." + extension;
    const TextureWriteOptions options{.format = GetParam().format};
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

TEST_P(HalfBlockFile, AnyNumberOfThreadsGivesTheSameFile) {
  const ImageSet images(octaveNoise(512, 128));
  const TextureWriteOptions options{.format = GetParam().format};
  ASSERT_TRUE(writeImageSet(folder_ / "many.ktx2", images, options));
  const testing::OneThread one;
  ASSERT_TRUE(writeImageSet(folder_ / "one.ktx2", images, options));
  EXPECT_TRUE(*readFile(folder_ / "one.ktx2") == *readFile(folder_ / "many.ktx2"));
}

TEST_P(HalfBlockFile, TheFirstMisfitIsNamed) {
  Image image(2000, 40, 3, 1.0f);
  image.texel(3, 39)[0] = 1e6f;
  image.texel(1999, 17)[2] = -2.0f;
  const auto result = writeImageSet(folder_ / "a.ktx2", ImageSet(image), {.format = GetParam().format});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::out_of_range);
  EXPECT_THAT(result.error().message, HasSubstr("texel (1999, 17) of level 0 is 1 1 -2, but " +
                                                std::string(GetParam().name) + " holds 0 to 65504"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ktx2"));
}

INSTANTIATE_TEST_SUITE_P(Kinds, HalfBlockFile, ::testing::Values(testing::kBc6hCodec, testing::kUastcHdrCodec),
                         kNameOfCodec);

}  // namespace
}  // namespace mirrorball
