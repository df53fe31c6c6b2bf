/// Headers of DDS files as programs are known to write them, though Microsoft's pages say otherwise.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOfTexture;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::oldDds;

// Where the numbers of the headers stand.
constexpr std::size_t kHeaderSizeAt = 4;
constexpr std::size_t kPitchAt = 20;
constexpr std::size_t kMipCountAt = 28;
constexpr std::size_t kPixelFormatSizeAt = 76;
constexpr std::size_t kCaps2At = 112;
constexpr std::size_t kDimensionAt = 132;
constexpr std::size_t kMiscFlagAt = 136;
constexpr std::size_t kArraySizeAt = 140;

constexpr auto makeTexture = testing::textureOf;

Bytes with(Bytes file, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<std::uint8_t>(number >> 8 * i);
  return file;
}

Bytes encoded(const ImageSet& images) { return bytesOfTexture(writeDds, images, {.format = TexelFormat::float32}); }

/// Reads a file that should hold the images; returns what is remarked.
std::vector<std::string> remarksOn(const Bytes& file, const ImageSet& images) {
  const auto read = decodeDds(file);
  if (!read) return {"refused: " + read.error().message};
  EXPECT_EQ(read->images.levels(), images.levels());
  EXPECT_EQ(read->images.faces(), images.faces());
  EXPECT_EQ(read->images.layers(), images.layers());
  if (read->images.faces() != images.faces() || read->images.layers() != images.layers()) return {};
  for (int level = 0; level < std::min(images.levels(), read->images.levels()); ++level)
    for (int layer = 0; layer < images.layers(); ++layer)
      for (int face = 0; face < images.faces(); ++face) {
        const Image& is = read->images.at(level, face, layer);
        const Image& should = images.at(level, face, layer);
        EXPECT_EQ(rgbAt(is, 0, 0), rgbAt(should, 0, 0)) << level << " " << layer << " " << face;
        const glm::ivec2 last(should.width() - 1, should.height() - 1);
        EXPECT_EQ(rgbAt(is, last.x, last.y), rgbAt(should, last.x, last.y)) << level << " " << layer << " " << face;
      }
  return read->oddities;
}

TEST(DdsVariants, WhatIsRightIsNotRemarked) {
  for (const ImageSet& images :
       {makeTexture(3, 6, 1, 3, 4, 4), makeTexture(1, 6, 6, 3, 2, 2), makeTexture(3, 1, 1, 3, 4, 4),
        makeTexture(1, 1, 6, 3, 4, 4), makeTexture(2, 1, 2, 3, 5, 3)})
    EXPECT_THAT(remarksOn(encoded(images), images), IsEmpty());
}

TEST(DdsVariants, ACubeMayBeDeclaredInEitherPlace) {
  for (const int layers : {1, 2}) {
    const ImageSet cube = makeTexture(2, 6, layers, 3, 4, 4);
    EXPECT_THAT(remarksOn(with(encoded(cube), kCaps2At, 0), cube), IsEmpty());
    EXPECT_THAT(remarksOn(with(encoded(cube), kMiscFlagAt, 0), cube),
                ElementsAre("says only in its old header that it is a cube: read as one"));
  }
  // One picture with the old header of a cube has no texels for one.
  const ImageSet picture = makeTexture(1, 1, 1, 3, 4, 4);
  EXPECT_THAT(remarksOn(with(encoded(picture), kCaps2At, 0xfe00), picture), IsEmpty());
}

TEST(DdsVariants, ACubesFacesMayBeCountedAsLayers) {
  for (const int cubes : {1, 2}) {
    const ImageSet cube = makeTexture(2, 6, cubes, 3, 4, 4);
    const Bytes file = with(encoded(cube), kArraySizeAt, static_cast<std::uint32_t>(6 * cubes));
    EXPECT_THAT(remarksOn(file, cube),
                ElementsAre(HasSubstr(cubes == 1 ? "counts 6 layers, and has texels for 1 cube:"
                                                 : "counts 12 layers, and has texels for 2 cubes:")));
    EXPECT_EQ(remarksOn(with(file, kMiscFlagAt, 0), cube).size(), 2u);
  }
}

TEST(DdsVariants, NoLayersAreOneAndNoDimensionIsTwo) {
  const ImageSet cube = makeTexture(1, 6, 1, 3, 4, 4);
  EXPECT_THAT(remarksOn(with(encoded(cube), kArraySizeAt, 0), cube),
              ElementsAre(HasSubstr("array of no layers: read as one")));
  EXPECT_THAT(remarksOn(with(encoded(cube), kDimensionAt, 0), cube), ElementsAre(HasSubstr("read as two-dimensional")));
}

TEST(DdsVariants, SizesOfTheHeadersPartsMayBeWrong) {
  const ImageSet picture = makeTexture(1, 1, 1, 3, 4, 4);
  EXPECT_THAT(remarksOn(with(encoded(picture), kHeaderSizeAt, 24), picture),
              ElementsAre(HasSubstr("states 24 and 32")));
  for (const std::uint32_t size : {0u, 24u})
    EXPECT_THAT(remarksOn(with(encoded(picture), kPixelFormatSizeAt, size), picture),
                ElementsAre(HasSubstr("read as 124 and 32")));
}

TEST(DdsVariants, LevelsAreThoseThatAreThere) {
  const ImageSet picture = makeTexture(3, 1, 1, 3, 4, 4);
  const Bytes file = encoded(picture);
  EXPECT_THAT(remarksOn(with(file, kMipCountAt, 4), picture),
              ElementsAre("counts 4 mip levels, of which its size has 3: read so"));
  // Without the smallest, and with a part of it.
  for (const std::size_t missing : {1u, 16u})
    EXPECT_THAT(remarksOn(Bytes(file.begin(), file.end() - missing), makeTexture(2, 1, 1, 3, 4, 4)),
                ElementsAre("counts 3 mip levels, and has texels for 2: read so"));
  EXPECT_THAT(remarksOn(with(file, kMipCountAt, 0), makeTexture(1, 1, 1, 3, 4, 4)), IsEmpty())
      << "the largest is asked for";
  // Of several images the second would be read from the first one's levels.
  const ImageSet cube = makeTexture(3, 6, 1, 3, 4, 4);
  for (const std::uint32_t count : {0u, 1u, 2u})
    EXPECT_THAT(remarksOn(with(encoded(cube), kMipCountAt, count), cube),
                ElementsAre(HasSubstr("and has texels for 3: read so")));
}

// The last image of a cube or an array ends within its levels, or each has fewer than are counted.
TEST(DdsVariants, OfSeveralImagesTheLevelsThatAllHaveAreRead) {
  for (const ImageSet& images : {makeTexture(3, 6, 1, 3, 4, 4), makeTexture(3, 1, 2, 3, 4, 4)}) {
    const int faces = images.faces(), layers = images.layers();
    const Bytes file = encoded(images);
    // Texels of 16 bytes: one of the smallest level, four of the one before it.
    for (const auto& [missing, levels] : {std::pair(1, 2), {16, 2}, {17, 1}, {80, 1}})
      EXPECT_THAT(remarksOn(Bytes(file.begin(), file.end() - missing), makeTexture(levels, faces, layers, 3, 4, 4)),
                  ElementsAre("counts 3 mip levels, and has texels for " + std::to_string(levels) + ": read so"));
    EXPECT_THAT(remarksOn(Bytes(file.begin(), file.end() - 81), images), ElementsAre(HasSubstr("refused: ")));
    const ImageSet fewer = makeTexture(2, faces, layers, 3, 4, 4);
    EXPECT_THAT(remarksOn(with(encoded(fewer), kMipCountAt, 3), fewer),
                ElementsAre("counts 3 mip levels, and has texels for 2: read so"));
  }
}

// By its length alone the file might as well end in the last texel of the last image.
TEST(DdsVariants, FewerLevelsThanCountedMayBeFilledUp) {
  for (const ImageSet& fewer : {makeTexture(2, 6, 1, 3, 4, 4), makeTexture(2, 1, 2, 3, 4, 4)})
    for (const std::size_t filling : {1u, 31u}) {
      Bytes file = with(encoded(fewer), kMipCountAt, 3);
      file.resize(file.size() + filling);
      EXPECT_THAT(remarksOn(file, fewer), ElementsAre("counts 3 mip levels, and has texels for 2: read so"));
    }
}

TEST(DdsVariants, BytesBehindTheTexelsAreLeftOut) {
  for (const ImageSet& images : {makeTexture(1, 6, 1, 3, 4, 4), makeTexture(2, 1, 1, 3, 4, 4)}) {
    Bytes file = encoded(images);
    file.insert(file.end(), 7, std::uint8_t{1});
    EXPECT_THAT(remarksOn(file, images), IsEmpty());
  }
}

TEST(DdsVariants, RowsMayBePadded) {
  // Three texels of three bytes, and three bytes behind each row.
  Bytes texels;
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 12; ++i)
      texels.push_back(i < 9 ? static_cast<std::uint8_t>(row == 0 ? 0 : 255) : std::uint8_t{77});
  const testing::OldDds header{
      .width = 3, .height = 2, .flags = 0x40, .bits = 24, .masks = {0xff0000, 0xff00, 0xff, 0}};
  const auto read = decodeDds(with(oldDds(header, texels), kPitchAt, 12));
  ASSERT_TRUE(read) << read.error().message;
  for (int x = 0; x < 3; ++x) {
    EXPECT_EQ(rgbAt(read->images.at(0, 0), x, 0), glm::vec3(0.0f));
    EXPECT_EQ(rgbAt(read->images.at(0, 0), x, 1), glm::vec3(1.0f));
  }
  EXPECT_THAT(read->oddities, ElementsAre("has rows of 12 bytes for 9 of texels: the rest of each is left out"));
  // A pitch alone says nothing: many are wrong.
  EXPECT_THAT(decodeDds(with(oldDds(header, Bytes(18, 9)), kPitchAt, 12))->oddities, IsEmpty());
}

// The texel's lowest ten bits are set. Of red and blue the one is read that the masks do not put there, since D3DX
// wrote the two masks exchanged.
TEST(DdsVariants, TenBitsBeforeDx10HaveExchangedMasks) {
  for (const bool is_red_high : {false, true}) {
    const std::array<std::uint32_t, 4> masks{is_red_high ? 0x3ff00000u : 0x3ffu, 0xffc00u,
                                             is_red_high ? 0x3ffu : 0x3ff00000u, 0xc0000000u};
    const auto read = decodeDds(oldDds({.flags = 0x41, .bits = 32, .masks = masks}, {0xff, 0x03, 0x00, 0xc0}));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(rgbaAt(read->images.at(0, 0), 0, 0), is_red_high ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 0, 1, 1));
    EXPECT_THAT(read->oddities, ElementsAre(HasSubstr("where D3DX exchanged red and blue: read so")));
    EXPECT_EQ(read->oddities.front(), read->channel_guess);
  }
}

TEST(DdsVariants, WhatIsTypelessIsReadAsItsUsualType) {
  struct Typeless {
    std::uint32_t number;
    Bytes texel;
    glm::vec3 light;
    const char* as;
  };
  for (const Typeless& kind : {Typeless{9, {0, 0x3c, 0, 0x40, 0, 0x44, 0, 0x3c}, {1, 2, 4}, "r16g16b16a16 sfloat"},
                               Typeless{27, {255, 0, 51, 255}, {1, 0, 0.2f}, "r8g8b8a8 unorm"},
                               Typeless{90, {255, 0, 51, 255}, {0.2f, 0, 1}, "b8g8r8a8 unorm"},
                               Typeless{23, {0xff, 0x03, 0, 0xc0}, {1, 0, 0}, "a2b10g10r10 unorm"}}) {
    Bytes file = encoded(makeTexture(1, 1, 1, 3, 1, 1));
    file.resize(148);
    file.insert(file.end(), kind.texel.begin(), kind.texel.end());
    const auto read = decodeDds(with(file, 128, kind.number));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(rgbAt(read->images.at(0, 0), 0, 0), kind.light);
    EXPECT_THAT(read->oddities, ElementsAre("leaves open what its samples are (DXGI_FORMAT " +
                                            std::to_string(kind.number) + ", typeless): read as " + kind.as));
  }
}

TEST(DdsVariants, FacesThatAreNotListedAreReadWhereTheyAre) {
  testing::OldDds header{.flags = 4, .code = 113};
  for (const std::uint32_t caps2 : {0x200u, 0x600u, 0xfa00u}) {
    header.caps2 = caps2;
    const auto read = decodeDds(oldDds(header, Bytes(6 * 8)));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->images.faces(), 6);
    EXPECT_THAT(read->oddities, ElementsAre(HasSubstr("and has texels for six: read so")));
  }
  header.caps2 = 0xfc00;  // all faces, but not that it is a cube
  EXPECT_EQ(decodeDds(oldDds(header, Bytes(6 * 8)))->images.faces(), 6);
  EXPECT_EQ(decodeDds(oldDds(header, Bytes(1 * 8)))->images.faces(), 1);
}

}  // namespace
}  // namespace mirrorball
