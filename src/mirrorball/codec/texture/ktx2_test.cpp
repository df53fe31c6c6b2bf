#include "mirrorball/codec/texture/ktx2.h"

#include <algorithm>
#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {
namespace {

using testing::bytesOfTexture;
using ::testing::HasSubstr;
using testing::textureOf;

Bytes ktx2File(const ImageSet& images, const TextureWriteOptions& options = {}) {
  return bytesOfTexture(writeKtx2, images, options);
}

void putU32(Bytes& bytes, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(number >> 8 * i);
}

Error errorOf(const Bytes& bytes) {
  const auto result = decodeKtx2(bytes);
  return result ? Error{ErrorCode::usage, ""} : result.error();
}

/// Grey 1 and 2 in level 0, ½ in level 1: 2 × 1 and 1 × 1 texels.
ImageSet twoLevels() {
  ImageSet images(2, 1);
  images.at(0, 0) = Image(2, 1, 1);
  images.at(0, 0).texel(0, 0)[0] = 1.0f;
  images.at(0, 0).texel(1, 0)[0] = 2.0f;
  images.at(1, 0) = Image(1, 1, 1, 0.5f);
  return images;
}

/// As SlimKTX2 wrote the environments of the glTF Sample Viewer: a descriptor without its length, or none.
TEST(Ktx2, WithoutADescriptorTheFormatsNumberCounts) {
  constexpr std::size_t kDescriptorSizeAt = 52;
  const Bytes whole = ktx2File(textureOf(2, 6, 1, 4, 4, 4), {.format = TexelFormat::float32});
  Bytes empty = whole;
  putU32(empty, littleU32(whole.data() + 48), 0);
  Bytes none = whole;
  putU32(none, kDescriptorSizeAt, 0);
  for (const Bytes& file : {empty, none}) {
    const auto read = decodeKtx2(file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(rgbaAt(read->images.at(1, 5), 1, 1), rgbaAt(decodeKtx2(whole)->images.at(1, 5), 1, 1));
    EXPECT_THAT(read->oddities, ::testing::ElementsAre("has no data format descriptor: read as its vkFormat says"));
  }
  EXPECT_TRUE(decodeKtx2(whole)->oddities.empty());
}

// Most writers put the largest level last, and a file that ends early has lost it.
TEST(Ktx2, LevelsAreThoseThatAreThereIfTheLargestIs) {
  const Bytes usual = bytesOfTexture(writeKtx2, textureOf(2, 1, 1, 4, 4, 4), {.format = TexelFormat::float32});
  constexpr std::size_t kLargest = 256, kSmallest = 64;
  EXPECT_THAT(decodeKtx2(Bytes(usual.begin(), usual.end() - 1)).error().message, HasSubstr("level 0 says it has"));
  // In the other order, the largest first.
  Bytes other(usual.begin(), usual.end() - kLargest - kSmallest);
  const std::size_t begin = other.size();
  other.insert(other.end(), usual.end() - kLargest, usual.end());
  other.insert(other.end(), usual.end() - kLargest - kSmallest, usual.end() - kLargest);
  for (const auto& [at, offset] : {std::pair<std::size_t, std::size_t>(80, begin), {104, begin + kLargest}}) {
    other[at] = static_cast<std::uint8_t>(offset);
    other[at + 1] = static_cast<std::uint8_t>(offset >> 8);
  }
  const auto whole = decodeKtx2(other);
  ASSERT_TRUE(whole) << whole.error().message;
  ASSERT_THAT(whole->oddities, ::testing::IsEmpty());
  const auto cut = decodeKtx2(Bytes(other.begin(), other.end() - 1));
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_EQ(cut->images.levels(), 1);
  EXPECT_EQ(rgbaAt(cut->images.at(0, 0), 3, 3), rgbaAt(decodeKtx2(usual)->images.at(0, 0), 3, 3));
  EXPECT_THAT(cut->oddities, ::testing::ElementsAre("counts 2 mip levels, and has texels for 1: read so"));
}

TEST(Ktx2, ASwizzleIsRemarked) {
  Bytes file = ktx2File(twoLevels());
  // In place of KTXwriter, whose key and value are as long: a key of 10 letters with its zero behind.
  const std::string writer("KTXwriter\0mirrorball\0", 21);
  const std::string swizzle("KTXswizzle\0bgra\0\0\0\0\0", 21);
  const auto at = std::search(file.begin(), file.end(), writer.begin(), writer.end());
  ASSERT_NE(at, file.end());
  std::copy(swizzle.begin(), swizzle.end(), at);
  EXPECT_THAT(decodeKtx2(file)->oddities,
              ::testing::ElementsAre("says KTXswizzle=bgra: its channels are taken as they are stored"));
}

/// Every byte of a small file, from the KTX 2.0 specification ("File Structure") and the Khronos Data Format
/// Specification ("Khronos Basic Data Format Descriptor Block").
TEST(Ktx2, ASmallFileByHand) {
  const Bytes expected = {
      0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n',  //
      97, 0, 0, 0,                                                       // vkFormat = VK_FORMAT_R16G16B16A16_SFLOAT
      2, 0, 0, 0,                                                        // typeSize: halves
      2, 0, 0, 0,                                                        // pixelWidth
      1, 0, 0, 0,                                                        // pixelHeight
      0, 0, 0, 0,                                                        // pixelDepth
      0, 0, 0, 0,                                                        // layerCount: no array
      1, 0, 0, 0,                                                        // faceCount
      2, 0, 0, 0,                                                        // levelCount
      0, 0, 0, 0,                                                        // supercompressionScheme
      128, 0, 0, 0,                                                      // dfdByteOffset = 80 + 2 · 24
      92, 0, 0, 0,                                                       // dfdByteLength
      220, 0, 0, 0,                                                      // kvdByteOffset = 128 + 92
      52, 0, 0, 0,                                                       // kvdByteLength
      0, 0, 0, 0, 0, 0, 0, 0,                                            // sgdByteOffset
      0, 0, 0, 0, 0, 0, 0, 0,                                            // sgdByteLength
      // Level index: offset, length, length unpacked. The smallest level comes first in the file.
      24, 1, 0, 0, 0, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0, 16, 0, 0, 0, 0, 0, 0, 0,  // level 0 at 280
      16, 1, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 0, 0,    // level 1 at 272, a multiple of 8
      // Data format descriptor.
      92, 0, 0, 0,             // dfdTotalSize
      0, 0, 0, 0,              // vendor Khronos, type basic
      2, 0, 88, 0,             // version 1.3, block size 24 + 4 · 16
      1, 1, 1, 0,              // RGBSDA, BT.709, linear, straight alpha
      0, 0, 0, 0,              // texel block 1 × 1 × 1 × 1
      8, 0, 0, 0, 0, 0, 0, 0,  // bytesPlane0
      // Per sample: bit offset, length − 1, float | signed | channel; position; −1.0f; 1.0f
      0, 0, 15, 0xc0, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f,   // red
      16, 0, 15, 0xc1, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f,  // green
      32, 0, 15, 0xc2, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f,  // blue
      48, 0, 15, 0xcf, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f,  // alpha
      // Key/value data: 14 + 1 + 2 + 1 bytes and 2 of padding; 9 + 1 + 10 + 1 bytes and 3 of padding.
      18, 0, 0, 0, 'K', 'T', 'X', 'o', 'r', 'i', 'e', 'n', 't', 'a', 't', 'i', 'o', 'n', 0, 'r', 'd', 0, 0, 0,  //
      21, 0, 0, 0, 'K', 'T', 'X', 'w', 'r', 'i', 't', 'e', 'r', 0, 'm', 'i', 'r', 'r', 'o', 'r', 'b', 'a', 'l', 'l', 0,
      0, 0, 0,  //
      // Level 1: ½ is 3800, alpha 1 is 3c00.
      0, 0x38, 0, 0x38, 0, 0x38, 0, 0x3c,  //
      // Level 0: 1 is 3c00, 2 is 4000.
      0, 0x3c, 0, 0x3c, 0, 0x3c, 0, 0x3c, 0, 0x40, 0, 0x40, 0, 0x40, 0, 0x3c};
  EXPECT_EQ(ktx2File(twoLevels()), expected);
}

TEST(Ktx2, DescriptorsOfThePackedFormats) {
  const ImageSet images = textureOf(1, 1, 1, 3, 1, 1);
  const auto descriptor = [&](TexelFormat format) {
    const Bytes file = ktx2File(images, {.format = format});
    const std::size_t at = littleU32(file.data() + 48);
    return Bytes(file.begin() + static_cast<std::ptrdiff_t>(at + 28),
                 file.begin() + static_cast<std::ptrdiff_t>(at + littleU32(file.data() + 52)));
  };
  // Unsigned floats (0x80) of 11, 11 and 10 bits, from 0 to 1.0f.
  EXPECT_EQ(descriptor(TexelFormat::b10g11r11), (Bytes{0,  0, 10, 0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f,  //
                                                       11, 0, 10, 0x81, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f,  //
                                                       22, 0, 9,  0x82, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x80, 0x3f}));
  // Mantissas of 9 bits up to 8448 = 0x2100, each followed by the exponent (0x20) at bit 27 with bias 15, at most 31.
  EXPECT_EQ(descriptor(TexelFormat::e5b9g9r9), (Bytes{0,  0, 8, 0x00, 0, 0, 0, 0, 0,  0, 0, 0, 0,  0x21, 0, 0,  //
                                                      27, 0, 4, 0x20, 0, 0, 0, 0, 15, 0, 0, 0, 31, 0,    0, 0,  //
                                                      9,  0, 8, 0x01, 0, 0, 0, 0, 0,  0, 0, 0, 0,  0x21, 0, 0,  //
                                                      27, 0, 4, 0x21, 0, 0, 0, 0, 15, 0, 0, 0, 31, 0,    0, 0,  //
                                                      18, 0, 8, 0x02, 0, 0, 0, 0, 0,  0, 0, 0, 0,  0x21, 0, 0,  //
                                                      27, 0, 4, 0x22, 0, 0, 0, 0, 15, 0, 0, 0, 31, 0,    0, 0}));
}

TEST(Ktx2, TwoChannelsAreRedAndGreen) {
  const Bytes file = ktx2File(ImageSet(Image(1, 1, 2, 2.0f)), {.format = TexelFormat::rg_half});
  EXPECT_EQ(littleU32(file.data() + 12), 83u) << "VK_FORMAT_R16G16_SFLOAT";
  EXPECT_EQ(littleU32(file.data() + 16), 2u) << "typeSize";
  const std::size_t at = littleU32(file.data() + 48);
  EXPECT_EQ(littleU32(file.data() + at), 4u + 24 + 2 * 16) << "dfdTotalSize";
  EXPECT_EQ(file[at + 20], 4) << "bytesPlane0";
  EXPECT_EQ(
      Bytes(file.begin() + static_cast<std::ptrdiff_t>(at + 28), file.begin() + static_cast<std::ptrdiff_t>(at + 60)),
      (Bytes{0,  0, 15, 0xc0, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f,  //
             16, 0, 15, 0xc1, 0, 0, 0, 0, 0, 0, 0x80, 0xbf, 0, 0, 0x80, 0x3f}));
  EXPECT_EQ(Bytes(file.end() - 4, file.end()), (Bytes{0, 0x40, 0, 0x40}));
  const Bytes floats = ktx2File(ImageSet(Image(1, 1, 2, 2.0f)), {.format = TexelFormat::rg_float32});
  EXPECT_EQ(littleU32(floats.data() + 12), 103u) << "VK_FORMAT_R32G32_SFLOAT";
}

TEST(Ktx2, LevelsStandAtMultiplesOfTheirTexel) {
  for (const TexelFormat format : {TexelFormat::half, TexelFormat::float32, TexelFormat::b10g11r11,
                                   TexelFormat::e5b9g9r9, TexelFormat::rg_half, TexelFormat::rg_float32}) {
    // The metadata's length moves the levels' beginning by every remainder.
    for (int extra = 0; extra < 16; ++extra) {
      const Bytes file =
          ktx2File(textureOf(3, 6, 2, 3, 5, 5),
                   {.format = format, .metadata = {{"mirrorball:layout", std::string(std::size_t(extra), 'x')}}});
      const std::uint64_t texel_size = file[std::size_t{littleU32(file.data() + 48)} + 20];
      for (std::size_t level = 0; level < 3; ++level)
        EXPECT_EQ(littleU64(file.data() + 80 + 24 * level) % texel_size, 0u) << extra;
    }
  }
}

TEST(Ktx2, CubeArraysCountLayersAndFaces) {
  const Bytes file = ktx2File(textureOf(1, 6, 3, 3, 2, 2));
  EXPECT_EQ(littleU32(file.data() + 32), 3u);
  EXPECT_EQ(littleU32(file.data() + 36), 6u);
}

/// The same texels under another VkFormat: a file whose one level is known.
TEST(Ktx2, OtherFormatsAreRead) {
  Bytes file = ktx2File(textureOf(1, 1, 1, 3, 2, 1), {.format = TexelFormat::e5b9g9r9});
  std::copy_n(Bytes{255, 0, 51, 102, 0, 255, 51, 153}.begin(), 8, file.end() - 8);
  putU32(file, 12, 44);  // VK_FORMAT_B8G8R8A8_UNORM
  const auto unorm = decodeKtx2(file);
  ASSERT_TRUE(unorm) << unorm.error().message;
  EXPECT_EQ(rgbaAt(unorm->images.at(0, 0), 0, 0), glm::vec4(0.2f, 0.0f, 1.0f, 0.4f));
  putU32(file, 12, 43);  // VK_FORMAT_R8G8B8A8_SRGB
  const auto srgb = decodeKtx2(file);
  ASSERT_TRUE(srgb);
  EXPECT_EQ(rgbaAt(srgb->images.at(0, 0), 1, 0).w, 0.6f);
  EXPECT_LT(rgbaAt(srgb->images.at(0, 0), 1, 0).z, 0.04f);
  putU32(file, 12, 100);  // VK_FORMAT_R32_SFLOAT
  EXPECT_EQ(decodeKtx2(file)->images.at(0, 0).channels(), 1);
  // The descriptor's transfer function says sRGB, whatever the format's name.
  putU32(file, 12, 37);  // VK_FORMAT_R8G8B8A8_UNORM
  file[std::size_t{littleU32(file.data() + 48)} + 14] = 2;
  EXPECT_EQ(decodeKtx2(file)->format, "KTX2, r8g8b8a8 srgb");
}

TEST(Ktx2, OrientationTurnsPicturesButNotCubes) {
  const ImageSet picture = textureOf(1, 1, 1, 3, 3, 2);
  Bytes file = ktx2File(picture);
  constexpr std::string_view kRightDown("rd\0", 3);
  const auto orientation = static_cast<std::size_t>(
      std::search(file.begin(), file.end(), kRightDown.begin(), kRightDown.end()) - file.begin());
  file[orientation] = 'l';
  file[orientation + 1] = 'u';
  const auto turned = decodeKtx2(file);
  ASSERT_TRUE(turned);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) EXPECT_EQ(rgbAt(turned->images.at(0, 0), x, y), rgbAt(picture.at(0, 0), 2 - x, 1 - y));

  const ImageSet cube = textureOf(1, 6, 1, 3, 2, 2);
  Bytes cube_file = ktx2File(cube);
  cube_file[orientation + 1] = 'u';
  EXPECT_EQ(rgbAt(decodeKtx2(cube_file)->images.at(0, 4), 0, 0), rgbAt(cube.at(0, 4), 0, 0));
}

TEST(Ktx2, StatedPrimariesAreConverted) {
  Bytes file = ktx2File(ImageSet(Image(1, 1, 3, 1.0f)));
  std::uint8_t& primaries = file[std::size_t{littleU32(file.data() + 48)} + 13];
  primaries = 4;  // BT.2020: white stays white, to the precision of the matrix
  const glm::vec3 white = rgbAt(decodeKtx2(file)->images.at(0, 0), 0, 0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0f, 1e-5f);
  // Its red lies outside Rec.709: a half of 1 in red alone.
  std::fill(file.end() - 6, file.end() - 2, std::uint8_t{0});
  const glm::vec3 red = rgbAt(decodeKtx2(file)->images.at(0, 0), 0, 0);
  EXPECT_NEAR(red.x, 1.6605f, 1e-4f);  // ITU-R BT.2087, the inverse of its matrix M2
  EXPECT_NEAR(red.y, -0.1246f, 1e-4f);
  EXPECT_NEAR(red.z, -0.0182f, 1e-4f);
}

TEST(Ktx2, PrimariesAreStatedByTheNumbersOfKhronos) {
  const std::array<int, 4> numbers{1, 10, 4, 7};  // KHR_DF_PRIMARIES_BT709, DISPLAYP3, BT2020, ACESCC
  for (const TexelFormat format : {TexelFormat::half, TexelFormat::float32, TexelFormat::bc6h})
    for (const OutputPrimaries primaries :
         {OutputPrimaries::rec709, OutputPrimaries::p3, OutputPrimaries::rec2020, OutputPrimaries::acescg}) {
      Image light(4, 4, 3, 0.25f);
      for (int i = 0; i < 16; ++i) light.texel(i % 4, i / 4)[0] = 0.75f;
      Image image = light;
      convertFromRec709(image, primaries);
      const Bytes file = ktx2File(ImageSet(image), {.format = format, .primaries = primaries});
      EXPECT_EQ(file[std::size_t{littleU32(file.data() + 48)} + 13], numbers[static_cast<std::size_t>(primaries)]);
      const glm::vec3 back = rgbAt(decodeKtx2(file)->images.at(0, 0), 2, 1);
      const float tolerance = format == TexelFormat::float32 ? 1e-6f : format == TexelFormat::half ? 1e-3f : 4e-3f;
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgbAt(light, 2, 1)[c], tolerance);
    }
}

TEST(Ktx2, WhatIsNotReadIsNamed) {
  const Bytes file = ktx2File(textureOf(1, 1, 1, 3, 4, 4));
  const auto with = [&](std::size_t at, std::uint32_t number) {
    Bytes changed = file;
    putU32(changed, at, number);
    return errorOf(changed);
  };
  const auto expectUnsupported = [](const Error& error, const char* what) {
    EXPECT_EQ(error.code, ErrorCode::unsupported);
    EXPECT_THAT(error.message, HasSubstr(what));
    EXPECT_THAT(error.message, HasSubstr("store it as r16g16b16a16 sfloat"));
  };
  expectUnsupported(with(12, 145), "BC7 block compression");
  expectUnsupported(with(12, 157), "ASTC block compression");
  expectUnsupported(with(12, 64), "VkFormat 64");
  expectUnsupported(with(44, 1), "Basis Universal");
  expectUnsupported(with(44, 3), "supercompression scheme 3");
  expectUnsupported(with(28, 2), "three-dimensional");
  expectUnsupported(with(24, 0), "one-dimensional");
  Bytes uastc = file;
  putU32(uastc, 12, 0);
  uastc[std::size_t{littleU32(file.data() + 48)} + 12] = 166;
  expectUnsupported(errorOf(uastc), "Basis Universal");
}

TEST(Ktx2, LyingHeadersAreNamedWithTheirPlace) {
  const Bytes file = ktx2File(textureOf(2, 1, 1, 3, 4, 4));
  const auto with = [&](std::size_t at, std::uint32_t number) {
    Bytes changed = file;
    putU32(changed, at, number);
    const Error error = errorOf(changed);
    EXPECT_EQ(error.message.find('\n'), std::string::npos);
    return error.message;
  };
  EXPECT_THAT(with(20, 0), HasSubstr("0x4"));
  EXPECT_THAT(with(20, 0x80000000u), HasSubstr("2147483648x4"));
  EXPECT_THAT(with(36, 7), HasSubstr("7 faces"));
  EXPECT_THAT(with(36, 6), HasSubstr("bytes of texels"));
  EXPECT_THAT(with(40, 4), HasSubstr("1 to 3"));
  EXPECT_THAT(with(32, 0xffffffffu), HasSubstr("layers"));
  EXPECT_THAT(with(32, 5), HasSubstr("level 0 (byte 80 of the file) says it has 128 bytes of texels"));
  EXPECT_THAT(with(52, 0xffffffffu),
              HasSubstr("the data format descriptor says it has 4294967295 bytes from byte 128"));
  EXPECT_THAT(with(48, 0), HasSubstr("overlaps the header"));
  EXPECT_THAT(with(56, 130), HasSubstr("overlaps the data format descriptor"));
  EXPECT_THAT(with(72, 300), HasSubstr("the supercompression global data"));
  EXPECT_THAT(with(80, littleU32(file.data() + 104)), HasSubstr("overlaps"));
  EXPECT_THAT(with(84, 0xffffffffu), HasSubstr("level 0 says it has 128 bytes from byte 18446744"));
  EXPECT_THAT(with(littleU32(file.data() + 56), 0xfffffff0u), HasSubstr("the key/value entry at byte"));
  EXPECT_THAT(with(128, 93), HasSubstr("the data format descriptor at byte 128"));
}

// Compressing takes minutes at high levels.
TEST(Zstandard, TellsHowFarItIsAndCanBeStopped) {
  MIRRORBALL_NEEDS(checkZstandard());
  Bytes bytes(std::size_t{20} << 20);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i >> 7);
  std::vector<std::size_t> steps;
  const auto packed = packZstandard(bytes, 1, [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, bytes.size());
    steps.push_back(done);
    return true;
  });
  ASSERT_TRUE(packed) << packed.error().message;
  EXPECT_GE(steps.size(), 20u);
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  EXPECT_EQ(steps.back(), bytes.size());
  Bytes unpacked(bytes.size());
  ASSERT_TRUE(unpackZstandard(*packed, unpacked));
  EXPECT_TRUE(unpacked == bytes);
  const auto stopped = packZstandard(bytes, 1, [](std::size_t done, std::size_t) { return done < (5u << 20); });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST(Zstandard, NothingIsPackedToo) {
  MIRRORBALL_NEEDS(checkZstandard());
  const auto packed = packZstandard({}, 3);
  ASSERT_TRUE(packed);
  EXPECT_TRUE(unpackZstandard(*packed, {}));
}

TEST(Ktx2, UnsoundZstandardIsNamed) {
  MIRRORBALL_NEEDS(checkZstandard());
  const Bytes file = ktx2File(textureOf(1, 1, 1, 3, 16, 16), {.zstandard_level = 3});
  Bytes damaged = file;
  damaged[littleU32(file.data() + 80)] ^= 0xff;
  EXPECT_THAT(errorOf(damaged).message, HasSubstr("level 0 at byte " + std::to_string(littleU32(file.data() + 80)) +
                                                  " is not sound Zstandard data"));
  // Twice as many layers of texels as the data unpacks to.
  Bytes lying = file;
  putU32(lying, 32, 2);
  putU32(lying, 96, 2 * littleU32(file.data() + 96));
  EXPECT_THAT(errorOf(lying).message, HasSubstr("unpacks to 2048 bytes instead of 4096"));
  // Nothing at all, at a place that is nowhere (found by the fuzzer).
  Bytes empty = file;
  putU32(empty, 84, 0xffffffffu);
  putU32(empty, 88, 0);
  EXPECT_THAT(errorOf(empty).message, HasSubstr("level 0 says it has 0 bytes from byte 18446744"));
  // More than any Zstandard data of its length unpacks to: refused before the memory is taken.
  Bytes bomb = file;
  putU32(bomb, 20, 1u << 15);
  putU32(bomb, 24, 1u << 15);
  putU32(bomb, 96, 0);
  putU32(bomb, 100, 2);
  EXPECT_THAT(errorOf(bomb).message, HasSubstr("too few for 8589934592"));
}

}  // namespace
}  // namespace mirrorball
