#include "mirrorball/codec/texture/ktx1.h"

#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/base/bit_cast.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using testing::appendU32;
using ::testing::HasSubstr;
using testing::Ktx1;
using testing::ktx1Header;
using ::testing::StartsWith;

constexpr std::uint32_t kRgb = 0x1907;
constexpr std::uint32_t kRgba = 0x1908;
constexpr std::uint32_t kUnsignedByte = 0x1401;

/// A file of one level.
Bytes oneLevel(const Ktx1& header, std::uint32_t stated_size, const Bytes& texels, const Bytes& key_values = {}) {
  Bytes file = ktx1Header(header, key_values);
  appendU32(file, stated_size, header.big_endian);
  file.insert(file.end(), texels.begin(), texels.end());
  return file;
}

Bytes floats(std::initializer_list<float> values, bool big_endian) {
  Bytes bytes;
  for (const float value : values) appendU32(bytes, bitCast<std::uint32_t>(value), big_endian);
  return bytes;
}

TEST(Ktx1, BothByteOrdersAreRead) {
  for (const bool big_endian : {false, true}) {
    const Bytes file = oneLevel({.big_endian = big_endian}, 16, floats({1.0f, 2.0f, 3.0f, 4.0f}, big_endian));
    const auto read = decodeKtx1(file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(rgbaAt(read->images.at(0, 0), 0, 0), glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(read->format, std::string("KTX1, r32g32b32a32 sfloat") + (big_endian ? ", big-endian" : ""));
  }
  // Halves are turned by twos, words by fours.
  const Ktx1 half{.type = 0x140b, .type_size = 2, .format = kRgba, .internal_format = 0x881a, .big_endian = true};
  EXPECT_EQ(rgbaAt(decodeKtx1(oneLevel(half, 8, {0x3c, 0, 0x40, 0, 0x44, 0, 0x38, 0}))->images.at(0, 0), 0, 0),
            glm::vec4(1.0f, 2.0f, 4.0f, 0.5f));
  const Ktx1 shared{.type = 0x8c3e, .format = kRgb, .internal_format = 0x8c3d, .big_endian = true};
  EXPECT_EQ(rgbAt(decodeKtx1(oneLevel(shared, 4, {0x81, 0x01, 0x01, 0x00}))->images.at(0, 0), 0, 0),
            glm::vec3(1.0f, 0.5f, 0.25f));
  const Ktx1 packed{.type = 0x8c3b, .format = kRgb, .internal_format = 0x8c3a};
  EXPECT_EQ(rgbAt(decodeKtx1(oneLevel(packed, 4, {0xc0, 0x03, 0x20, 0x70}))->images.at(0, 0), 0, 0),
            glm::vec3(1.0f, 2.0f, 0.5f));
}

/// The numbers that Filament's cmgen writes, now and until version 1.8: no glType of OpenGL's.
TEST(Ktx1, FilesOfFilamentsCmgenAreRead) {
  for (const std::uint32_t format : {kRgb, 0x8c3au}) {
    const Ktx1 cmgen{.type = 0x8c3a, .type_size = 1, .format = format, .internal_format = 0x8c3a};
    const auto read = decodeKtx1(oneLevel(cmgen, 4, {0xc0, 0x03, 0x20, 0x70}));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(rgbAt(read->images.at(0, 0), 0, 0), glm::vec3(1.0f, 2.0f, 0.5f));
    EXPECT_EQ(read->format, "KTX1, b10g11r11 ufloat");
  }
}

TEST(Ktx1, Bc6hIsRead) {
  const std::vector<float> white(6 * 5 * 3, 1.0f);
  Bytes blocks(4 * 16);
  ASSERT_TRUE(packTexels(TexelFormat::bc6h, white, 3, 6, blocks));
  for (const std::uint32_t format : {0x8e8eu, 0x8e8fu}) {
    const Ktx1 header{.type = 0, .type_size = 1, .format = 0, .internal_format = format, .width = 6, .height = 5};
    const auto read = decodeKtx1(oneLevel(header, 64, blocks));
    ASSERT_TRUE(read) << read.error().message;
    const bool is_signed = format == 0x8e8e;
    EXPECT_EQ(read->format, is_signed ? "KTX1, bc6h sfloat" : "KTX1, bc6h ufloat");
    // Signed, the same bits mean other light.
    EXPECT_EQ(rgbAt(read->images.at(0, 0), 5, 4) == glm::vec3(1.0f), !is_signed);
  }
}

TEST(Ktx1, RowsArePaddedToFour) {
  // Three texels of three bytes: 9 bytes and 3 of padding a row.
  const Ktx1 header{
      .type = kUnsignedByte, .type_size = 1, .format = kRgb, .internal_format = 0x8c41, .width = 3, .height = 2};
  Bytes texels;
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < 9; ++i) texels.push_back(static_cast<std::uint8_t>(100 * row + i));
    texels.insert(texels.end(), {77, 77, 77});
  }
  const auto read = decodeKtx1(oneLevel(header, 24, texels));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(rgbAt(read->images.at(0, 0), 2, 1).z, formula::linearFromSrgb1(108.0f / 255.0f)) << "GL_SRGB8";
}

/// A cube states the size of one face; an array of cubes, that of the whole level.
TEST(Ktx1, CubesArraysAndLevels) {
  for (const std::uint32_t layers : {0u, 2u}) {
    Bytes file = ktx1Header({.width = 2, .height = 2, .layers = layers, .faces = 6, .levels = 2});
    const std::uint32_t count = std::max(layers, 1u) * 6;
    for (std::uint32_t level = 0; level < 2; ++level) {
      const std::uint32_t texels = level == 0 ? 4 : 1;
      appendU32(file, 16 * texels * (layers > 0 ? count : 1), false);
      for (std::uint32_t image = 0; image < count; ++image)
        for (std::uint32_t i = 0; i < 4 * texels; ++i)
          appendU32(file, bitCast<std::uint32_t>(static_cast<float>(100 * level + image)), false);
    }
    const auto read = decodeKtx1(file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->images.layers(), static_cast<int>(std::max(layers, 1u)));
    for (int level = 0; level < 2; ++level)
      for (int layer = 0; layer < read->images.layers(); ++layer)
        for (int face = 0; face < 6; ++face)
          EXPECT_EQ(read->images.at(level, face, layer).texel(0, 0)[0],
                    static_cast<float>(100 * level + 6 * layer + face));
  }
}

/// Older versions of gli stated the size of all six faces, others that of one image of an array.
TEST(Ktx1, SizesOfLevelsThatAreTakenForThoseOfImagesAreReadAndTold) {
  for (const std::uint32_t layers : {0u, 2u}) {
    const std::uint32_t count = std::max(layers, 1u) * 6;
    Bytes file = ktx1Header({.width = 2, .height = 2, .layers = layers, .faces = 6, .levels = 2});
    for (const std::uint32_t texels : {4u, 1u}) {
      appendU32(file, 16 * texels * (layers > 0 ? 1 : count), false);
      for (std::uint32_t image = 0; image < count; ++image)
        for (std::uint32_t i = 0; i < 4 * texels; ++i)
          appendU32(file, bitCast<std::uint32_t>(static_cast<float>(image)), false);
    }
    const auto read = decodeKtx1(file);
    ASSERT_TRUE(read) << read.error().message;
    for (int level = 0; level < 2; ++level)
      EXPECT_EQ(read->images.at(level, 5, read->images.layers() - 1).texel(0, 0)[0], static_cast<float>(count - 1));
    EXPECT_THAT(read->oddities,
                ::testing::ElementsAre(HasSubstr(layers > 0 ? "the size of one image" : "of six faces")));
    // Both ways in one file are damage.
    const std::size_t second = file.size() - 4 - 16 * count;
    file[second] ^= 1;
    EXPECT_THAT(decodeKtx1(file).error().message, HasSubstr("level 1 at byte"));
  }
}

TEST(Ktx1, LevelsAreThoseThatAreThere) {
  Bytes file = testing::ktx1Header({.width = 4, .height = 4, .levels = 3});
  for (const std::uint32_t size : {256u, 64u, 16u}) {
    testing::appendU32(file, size, false);
    file.insert(file.end(), size, std::uint8_t{0x3f});
  }
  EXPECT_THAT(decodeKtx1(file)->oddities, ::testing::IsEmpty());
  for (const auto& [missing, levels] : {std::pair(1, 2), {20, 2}, {21, 1}, {88, 1}}) {
    const auto cut = decodeKtx1(Bytes(file.begin(), file.end() - missing));
    ASSERT_TRUE(cut) << missing << ": " << cut.error().message;
    EXPECT_EQ(cut->images.levels(), levels);
    EXPECT_THAT(cut->oddities, ::testing::ElementsAre("counts 3 mip levels, and has texels for " +
                                                      std::to_string(levels) + ": read so"));
  }
  EXPECT_FALSE(decodeKtx1(Bytes(file.begin(), file.end() - 89)));
}

TEST(Ktx1, NoFacesAreOne) {
  const auto read = decodeKtx1(oneLevel({.faces = 0}, 16, floats({1.0f, 2.0f, 3.0f, 4.0f}, false)));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(rgbaAt(read->images.at(0, 0), 0, 0), glm::vec4(1, 2, 3, 4));
}

TEST(Ktx1, OrientationAndMetadataAreRead) {
  Bytes key_values;
  appendU32(key_values, 23, false);
  for (const char c : std::string("KTXorientation\0S=r,T=u\0", 23)) key_values.push_back(static_cast<std::uint8_t>(c));
  key_values.push_back(0);
  appendU32(key_values, 11, false);  // a value needs no zero
  for (const char c : std::string("envmap\0cube", 11)) key_values.push_back(static_cast<std::uint8_t>(c));
  key_values.push_back(0);
  const Ktx1 header{.type = 0x1406, .format = 0x1903, .internal_format = 0x822e, .height = 2};
  const auto read = decodeKtx1(oneLevel(header, 8, floats({1.0f, 2.0f}, false), key_values));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->images.at(0, 0).texel(0, 0)[0], 2.0f) << "stored bottom up";
  EXPECT_EQ(read->metadata, (Metadata{{"envmap", "cube"}}));
}

TEST(Ktx1, WhatIsNotReadIsNamed) {
  const auto messageOf = [](const Bytes& file) {
    const auto result = decodeKtx1(file);
    EXPECT_FALSE(result);
    return result ? "" : result.error().message;
  };
  const Ktx1 etc{.type = 0, .type_size = 1, .format = 0, .internal_format = 0x8d64, .width = 4, .height = 4};
  EXPECT_THAT(messageOf(oneLevel(etc, 8, Bytes(8))), HasSubstr("ETC1 block compression"));
  EXPECT_THAT(messageOf(oneLevel({.type = 0x8033, .internal_format = 0x8056}, 4, Bytes(4))),
              HasSubstr("glType 0x8033, glFormat 0x1908, glInternalFormat 0x8056"));
  EXPECT_THAT(messageOf(oneLevel({.depth = 2}, 16, Bytes(16))), HasSubstr("three-dimensional"));
  EXPECT_THAT(messageOf(oneLevel({.height = 0}, 16, Bytes(16))), HasSubstr("one-dimensional"));
  EXPECT_THAT(messageOf(oneLevel({}, 17, Bytes(16))),
              HasSubstr("level 0 at byte 64 says it has 17 bytes; as r32g32b32a32 sfloat it has 16"));
  EXPECT_THAT(messageOf(oneLevel({.width = 2}, 32, Bytes(16))), HasSubstr("its levels have 36 bytes from byte 64 on"));
  Bytes no_order = oneLevel({}, 16, Bytes(16));
  no_order[13] = 9;
  EXPECT_THAT(messageOf(no_order), HasSubstr("byte 12"));
}

/// What Filament's ktxreader looks at; for its packed format it takes no other glType.
TEST(Ktx1, TheHeaderIsAsFilamentReadsIt) {
  struct Numbers {
    TexelFormat format;
    std::array<std::uint32_t, 5> gl;  ///< type, size of a word, format, internal format, base internal format
  };
  for (const Numbers& numbers : {Numbers{TexelFormat::b10g11r11, {0x8c3a, 4, kRgb, 0x8c3a, kRgb}},
                                 Numbers{TexelFormat::half, {0x140b, 2, kRgba, 0x881a, kRgba}},
                                 Numbers{TexelFormat::float32, {0x1406, 4, kRgba, 0x8814, kRgba}},
                                 Numbers{TexelFormat::bc6h, {0, 1, 0, 0x8e8f, kRgb}}}) {
    const ImageSet cube = testing::textureOf(3, 6, 1, 3, 8, 8);
    const Bytes file =
        testing::bytesOfTexture(writeKtx1, cube, {.format = numbers.format, .metadata = {{"sh", "1 2"}}});
    const auto u32 = [&](std::size_t at) { return littleU32(file.data() + at); };
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(u32(16 + 4 * i), numbers.gl[i]) << i;
    const std::array<std::uint32_t, 6> shape{8, 8, 0, 0, 6, 3};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(u32(36 + 4 * i), shape[i]) << i;
    EXPECT_EQ(std::string(file.begin() + 68, file.begin() + 92), std::string("KTXorientation\0S=r,T=d\0\0", 24));
    EXPECT_EQ(u32(92), 7u);
    EXPECT_EQ(std::string(file.begin() + 96, file.begin() + 104), std::string("sh\0001 2\0", 7) + '\0');
    // Before each level the size of one face.
    std::size_t at = 104;
    for (const std::uint32_t side : {8u, 4u, 2u}) {
      const bool is_compressed = numbers.format == TexelFormat::bc6h;
      const std::uint32_t size =
          is_compressed ? (side + 3) / 4 * ((side + 3) / 4) * 16
                        : side * side * static_cast<std::uint32_t>(blockSize(storedFormat(numbers.format)));
      EXPECT_EQ(u32(at), size) << side;
      at += 4 + 6 * size;
    }
    EXPECT_EQ(at, file.size());
  }
}

TEST(Ktx1, ALevelHasLessThanFourGibibytes) {
  const TextureShape shape{.width = 16384, .height = 16384, .faces = 6};
  EXPECT_TRUE(ktx1Layout(shape, {.format = TexelFormat::half}));
  const auto layout = ktx1Layout(shape, {.format = TexelFormat::float32});
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::too_large);
  EXPECT_THAT(layout.error().message, StartsWith("a level of a KTX file has at most 4 GiB; use .ktx2"));
}

}  // namespace
}  // namespace mirrorball
