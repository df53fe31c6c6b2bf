#include "mirrorball/codec/texture/dds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/texture/texture_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOfTexture;
using ::testing::HasSubstr;
using testing::oldDds;
using testing::textureOf;

Bytes ddsBytes(const ImageSet& images, const TextureWriteOptions& options = {}) {
  return bytesOfTexture(writeDds, images, options);
}

/// Every byte of a small cube, from Microsoft's "DDS_HEADER", "DDS_PIXELFORMAT" and "DDS_HEADER_DXT10".
TEST(Dds, ASmallCubeByHand) {
  ImageSet cube(1, 6);
  for (int face = 0; face < 6; ++face) cube.at(0, face) = Image(1, 1, 1, static_cast<float>(1 << face));
  Bytes expected = {
      'D',  'D',  'S', ' ',              //
      124,  0,    0,   0,                // dwSize
      0x0f, 0x10, 0,   0,                // dwFlags: caps, height, width, pitch, pixel format
      1,    0,    0,   0,   1, 0, 0, 0,  // dwHeight, dwWidth
      4,    0,    0,   0,                // dwPitchOrLinearSize
      0,    0,    0,   0,   1, 0, 0, 0,  // dwDepth, dwMipMapCount
  };
  expected.resize(expected.size() + 44);  // dwReserved1
  const Bytes rest = {
      32, 0,    0, 0, 4, 0, 0, 0, 'D', 'X', '1', '0',                          // DDS_PIXELFORMAT: size, four letters
      0,  0,    0, 0, 0, 0, 0, 0, 0,   0,   0,   0,   0, 0, 0, 0, 0, 0, 0, 0,  // no bit count, no masks
      8,  0x10, 0, 0,                                                          // dwCaps: complex, texture
      0,  0xfe, 0, 0,                                                          // dwCaps2: cube with all faces
      0,  0,    0, 0, 0, 0, 0, 0, 0,   0,   0,   0,                            // dwCaps3, dwCaps4, dwReserved2
      26, 0,    0, 0,                                                          // DXGI_FORMAT_R11G11B10_FLOAT
      3,  0,    0, 0,                                                          // two-dimensional
      4,  0,    0, 0,                                                          // cube
      1,  0,    0, 0,                                                          // one cube
      3,  0,    0, 0,                                                          // opaque
  };
  expected.insert(expected.end(), rest.begin(), rest.end());
  // 2^n has the exponent 15 + n and no mantissa: at bits 6 (red), 17 (green) and 27 (blue).
  for (std::uint32_t n = 0; n < 6; ++n) {
    const std::uint32_t texel = (15 + n) << 6 | (15 + n) << 17 | (15 + n) << 27;
    for (int i = 0; i < 4; ++i) expected.push_back(static_cast<std::uint8_t>(texel >> 8 * i));
  }
  EXPECT_EQ(ddsBytes(cube, {.format = TexelFormat::b10g11r11}), expected);
}

TEST(Dds, TwoChannelsAreRedAndGreen) {
  const Bytes file = ddsBytes(ImageSet(Image(3, 1, 2, 2.0f)), {.format = TexelFormat::rg_half});
  ASSERT_EQ(file.size(), 148u + 3 * 4);
  EXPECT_EQ(littleU32(file.data() + 20), 12u) << "dwPitchOrLinearSize";
  EXPECT_EQ(littleU32(file.data() + 128), 34u) << "DXGI_FORMAT_R16G16_FLOAT";
  EXPECT_EQ(littleU32(file.data() + 144), 3u) << "opaque";
  EXPECT_EQ(Bytes(file.end() - 4, file.end()), (Bytes{0, 0x40, 0, 0x40}));
  const Bytes floats = ddsBytes(ImageSet(Image(3, 1, 2, 2.0f)), {.format = TexelFormat::rg_float32});
  EXPECT_EQ(littleU32(floats.data() + 128), 16u) << "DXGI_FORMAT_R32G32_FLOAT";
}

TEST(Dds, LevelsOfAFaceStandTogether) {
  ImageSet cube(2, 6);
  for (int level = 0; level < 2; ++level)
    for (int face = 0; face < 6; ++face)
      cube.at(level, face) = Image(2 - level, 2 - level, 4, static_cast<float>(10 * level + face));
  const Bytes file = ddsBytes(cube, {.format = TexelFormat::float32});
  ASSERT_EQ(file.size(), 148u + 6 * (4 + 1) * 16);
  EXPECT_EQ(littleU32(file.data() + 28), 2u) << "dwMipMapCount";
  EXPECT_EQ(littleU32(file.data() + 108), 0x401008u) << "dwCaps: complex, texture, mips";
  EXPECT_EQ(littleU32(file.data() + 144), 1u) << "straight alpha";
  for (std::size_t face = 0; face < 6; ++face) {
    float first = 0;
    float second = 0;
    std::memcpy(&first, file.data() + 148 + face * 80, 4);
    std::memcpy(&second, file.data() + 148 + face * 80 + 64, 4);
    EXPECT_EQ(first, static_cast<float>(face));
    EXPECT_EQ(second, static_cast<float>(10 + face));
  }
}

TEST(Dds, FormatsFromBeforeDx10AreRead) {
  const float dark = formula::linearFromSrgb1(51.0f / 255.0f);
  struct Old {
    const char* name;
    testing::OldDds header;
    Bytes texel;
    glm::vec4 light;
  };
  const Old kinds[] = {
      {"A8R8G8B8",
       {.flags = 0x41, .bits = 32, .masks = {0xff0000, 0xff00, 0xff, 0xff000000}},
       {255, 0, 51, 51},
       {dark, 0.0f, 1.0f, 0.2f}},
      {"X8R8G8B8, whose alpha mask means nothing",
       {.flags = 0x40, .bits = 32, .masks = {0xff0000, 0xff00, 0xff, 0xff000000}},
       {255, 0, 51, 51},
       {dark, 0.0f, 1.0f, 1.0f}},
      {"A8B8G8R8",
       {.flags = 0x41, .bits = 32, .masks = {0xff, 0xff00, 0xff0000, 0xff000000}},
       {51, 0, 255, 51},
       {dark, 0.0f, 1.0f, 0.2f}},
      {"R8G8B8",
       {.flags = 0x40, .bits = 24, .masks = {0xff0000, 0xff00, 0xff, 0}},
       {255, 0, 51},
       {dark, 0.0f, 1.0f, 1.0f}},
      {"R5G6B5", {.flags = 0x40, .bits = 16, .masks = {0xf800, 0x7e0, 0x1f, 0}}, {0xe0, 0xff}, {1, 1, 0, 1}},
      {"B5G6R5", {.flags = 0x40, .bits = 16, .masks = {0x1f, 0x7e0, 0xf800, 0}}, {0xe0, 0xff}, {0, 1, 1, 1}},
      {"A1R5G5B5",
       {.flags = 0x41, .bits = 16, .masks = {0x7c00, 0x3e0, 0x1f, 0x8000}},
       {0x06, 0x7c},
       {1, 0, formula::linearFromSrgb1(6.0f / 31.0f), 0}},
      {"X1R5G5B5",
       {.flags = 0x40, .bits = 16, .masks = {0x7c00, 0x3e0, 0x1f, 0}},
       {0x06, 0x7c},
       {1, 0, formula::linearFromSrgb1(6.0f / 31.0f), 1}},
      {"A4R4G4B4", {.flags = 0x41, .bits = 16, .masks = {0xf00, 0xf0, 0xf, 0xf000}}, {0x3f, 0x30}, {0, dark, 1, 0.2f}},
      {"R3G3B2", {.flags = 0x40, .bits = 8, .masks = {0xe0, 0x1c, 0x3, 0}}, {0xe3}, {1, 0, 1, 1}},
      {"A8L8", {.flags = 0x20001, .bits = 16, .masks = {0xff, 0, 0, 0xff00}}, {51, 102}, {dark, dark, dark, 0.4f}},
      {"L16", {.flags = 0x20000, .bits = 16, .masks = {0xffff, 0, 0, 0}}, {0x33, 0x33}, {0.2f, 0.2f, 0.2f, 1}},
      {"G16R16",
       {.flags = 0x40, .bits = 32, .masks = {0xffff, 0xffff0000, 0, 0}},
       {0x33, 0x33, 0xff, 0xff},
       {0.2f, 1, 0, 1}},
      {"L8", {.flags = 0x20000, .bits = 8, .masks = {0xff, 0, 0, 0}}, {51}, {dark, dark, dark, 1.0f}},
      {"A16B16G16R16F", {.flags = 4, .code = 113}, {0, 0x3c, 0, 0x40, 0, 0x44, 0, 0x38}, {1.0f, 2.0f, 4.0f, 0.5f}},
      {"A32B32G32R32F",
       {.flags = 4, .code = 116},
       {0, 0, 0x80, 0x3f, 0, 0, 0, 0x40, 0, 0, 0x80, 0x40, 0, 0, 0, 0x3f},
       {1.0f, 2.0f, 4.0f, 0.5f}},
      {"R16F", {.flags = 4, .code = 111}, {0, 0x40}, {2.0f, 2.0f, 2.0f, 1.0f}},
      {"G16R16F", {.flags = 4, .code = 112}, {0, 0x40, 0, 0x3c}, {2.0f, 1.0f, 0.0f, 1.0f}},
  };
  for (const Old& kind : kinds) {
    const auto read = decodeDds(oldDds(kind.header, kind.texel));
    ASSERT_TRUE(read) << kind.name << ": " << read.error().message;
    EXPECT_EQ(rgbaAt(read->images.at(0, 0), 0, 0), kind.light) << kind.name;
  }
  testing::OldDds cube = kinds[5].header;
  cube.caps2 = 0xfe00;
  EXPECT_EQ(decodeDds(oldDds(cube, Bytes(6 * 8)))->images.faces(), 6);
}

TEST(Dds, FormatsOfBitsAreRead) {
  struct InBits {
    std::uint8_t number;
    std::vector<std::uint8_t> texel;
    glm::vec4 light;
    const char* format;
  };
  for (const InBits& kind : {InBits{24, {0xff, 0x03, 0x00, 0x40}, {1, 0, 0, 1.0f / 3.0f}, "DDS, a2b10g10r10 unorm"},
                             InBits{85, {0xe0, 0xff}, {1, 1, 0, 1}, "DDS, r5g6b5 unorm"},
                             InBits{86, {0x1f, 0x80}, {0, 0, 1, 1}, "DDS, a1r5g5b5 unorm"},
                             InBits{115, {0x3f, 0x30}, {0, 0.2f, 1, 0.2f}, "DDS, a4r4g4b4 unorm"},
                             InBits{191, {0x3f, 0x30}, {0.2f, 0, 0.2f, 1}, "DDS, r4g4b4a4 unorm"}}) {
    Bytes file = ddsBytes(textureOf(1, 1, 1, 3, 1, 1));
    file.resize(148);
    file[128] = kind.number;
    file.insert(file.end(), kind.texel.begin(), kind.texel.end());
    const auto read = decodeDds(file);
    ASSERT_TRUE(read) << kind.format << ": " << read.error().message;
    EXPECT_EQ(rgbaAt(read->images.at(0, 0), 0, 0), kind.light) << kind.format;
    EXPECT_EQ(read->format, kind.format);
    EXPECT_THAT(read->oddities, ::testing::IsEmpty());
  }
}

TEST(Dds, WhatIsNotReadIsNamed) {
  const auto expectUnsupported = [](const Bytes& file, const char* what) {
    const auto result = decodeDds(file);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::unsupported);
    EXPECT_THAT(result.error().message, HasSubstr(what));
    EXPECT_THAT(result.error().message, HasSubstr("store it as R16G16B16A16_FLOAT"));
  };
  const std::uint32_t dxt5 = dds::fourLetters("DXT5");
  expectUnsupported(oldDds({.flags = 4, .code = dxt5}, Bytes(16)), "DXT5");
  for (const auto& masks : {std::array<std::uint32_t, 4>{0xf801, 0x7e0, 0x1e, 0}, {0x1f800, 0x7e0, 0x1f, 0}, {}})
    expectUnsupported(oldDds({.flags = 0x40, .bits = 16, .masks = masks}, Bytes(2)), "16 bits");
  expectUnsupported(oldDds({.flags = 4, .code = 113, .caps2 = 0x200000}, Bytes(8)), "three-dimensional");
  EXPECT_EQ(decodeDds(oldDds({.flags = 4, .code = 113, .caps2 = 0x0600}, Bytes(8))).error().message,
            "holds a cube with fewer than six faces (+X), whose light from the others is not known; store all six");
  EXPECT_THAT(decodeDds(oldDds({.flags = 4, .code = 113, .caps2 = 0x0200}, Bytes(5 * 8))).error().message,
              HasSubstr("fewer than six faces (none)"));
  Bytes file = ddsBytes(textureOf(1, 1, 1, 3, 2, 2));
  file[128] = 98;  // DXGI_FORMAT_BC7_UNORM
  expectUnsupported(file, "BC7 block compression");
  file[128] = 10;
  file[132] = 4;  // D3D10_RESOURCE_DIMENSION_TEXTURE3D
  expectUnsupported(file, "not two-dimensional");
}

TEST(Dds, LyingHeadersAreNamedWithTheirPlace) {
  const Bytes file = ddsBytes(textureOf(2, 6, 1, 3, 4, 4));
  const auto with = [&](std::size_t at, std::uint32_t number) {
    Bytes changed = file;
    for (std::size_t i = 0; i < 4; ++i) changed[at + i] = static_cast<std::uint8_t>(number >> 8 * i);
    const auto result = decodeDds(changed);
    return result ? "" : result.error().message;
  };
  EXPECT_THAT(with(4, 123), HasSubstr("bytes 4 and 76"));
  EXPECT_THAT(with(76, 31), HasSubstr("bytes 4 and 76"));
  EXPECT_THAT(with(12, 5), HasSubstr("square"));
  EXPECT_THAT(with(16, 0), HasSubstr("0x4"));
  EXPECT_THAT(decodeDds(Bytes(file.begin(), file.end() - 200)).error().message,
              HasSubstr("its texels have 960 bytes from byte 148 on"));
  EXPECT_THAT(with(140, 0xffffffffu), HasSubstr("layers"));
}

}  // namespace
}  // namespace mirrorball
