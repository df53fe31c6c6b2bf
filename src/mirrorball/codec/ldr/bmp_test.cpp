#include "mirrorball/codec/ldr/bmp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/picture_testing.h"

namespace mirrorball {
namespace {

using testing::bmpFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<int> codesOfBmp(const Bytes& bytes) {
  const auto texture = decodeTexture(bytes);
  EXPECT_TRUE(texture) << texture.error().message;
  return texture ? std::vector<int>(texture->samples().begin(), texture->samples().end()) : std::vector<int>();
}

/// The red codes of a palette's picture whose colours are their own numbers.
std::vector<int> indices(testing::BmpForm form, const Bytes& texels) {
  for (std::uint32_t i = 0; i < (1u << form.bits); ++i) form.palette.push_back(i << 16);
  std::vector<int> reds;
  const std::vector<int> all = codesOfBmp(bmpFile(form, texels));
  for (std::size_t i = 0; i < all.size(); i += 4) reds.push_back(all[i]);
  return reds;
}

Error refusedBmp(const Bytes& bytes) {
  const auto result = decodeBmp(bytes);
  EXPECT_FALSE(result);
  return result ? Error() : result.error();
}

TEST(Bmp, RowsRunUpUnlessTheHeightIsNegative) {
  const Bytes texels{3, 2, 1, 0, 6, 5, 4, 0};  // each row padded to four bytes
  EXPECT_THAT(codesOfBmp(bmpFile({.width = 1, .height = 2}, texels)), ElementsAre(4, 5, 6, 255, 1, 2, 3, 255));
  EXPECT_THAT(codesOfBmp(bmpFile({.width = 1, .height = -2}, texels)), ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
  const auto image = decodeImage(bmpFile({.width = 1, .height = 2}, texels));
  EXPECT_EQ(image->format, "BMP, 24 bit");
  EXPECT_EQ(image->color, "sRGB");
  EXPECT_EQ(image->image.channels(), 3);
}

TEST(Bmp, PalettesOfEveryDepth) {
  EXPECT_THAT(indices({.width = 9, .height = 1, .bits = 1}, {0xa5, 0x80, 0, 0}),
              ElementsAre(1, 0, 1, 0, 0, 1, 0, 1, 1));
  EXPECT_THAT(indices({.width = 4, .height = 1, .bits = 2}, {0x1b, 0, 0, 0}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(indices({.width = 3, .height = 1, .bits = 4}, {0x1f, 0x80, 0, 0}), ElementsAre(1, 15, 8));
  EXPECT_THAT(indices({.width = 2, .height = 1, .bits = 8}, {200, 3, 0, 0}), ElementsAre(200, 3));
  // OS/2's first version has colours of three bytes.
  EXPECT_THAT(codesOfBmp(bmpFile({.header = 12, .width = 1, .height = 1, .bits = 1, .palette = {0x112233, 0x445566}},
                                 {0x80, 0, 0, 0})),
              ElementsAre(0x44, 0x55, 0x66, 255));
  EXPECT_THAT(refusedBmp(bmpFile({.width = 2, .height = 1, .bits = 8, .palette = {0, 1}}, {1, 2, 0, 0})).message,
              HasSubstr("texel (1, 0) has the colour 2 of a palette of 2"));
}

TEST(Bmp, MasksOfAnyBits) {
  // 16 bits are 5-5-5 without masks.
  EXPECT_THAT(codesOfBmp(bmpFile({.width = 1, .height = 1, .bits = 16}, {0x30, 0x7c, 0, 0})),
              ElementsAre(255, 8, 132, 255));
  EXPECT_THAT(
      codesOfBmp(bmpFile({.width = 1, .height = 1, .bits = 16, .compression = 3, .masks = {0xf800, 0x7e0, 0x1f}},
                         {0xe0, 0x07, 0, 0})),
      ElementsAre(0, 255, 0, 255));
  // Ten bits a colour and two of alpha.
  EXPECT_THAT(codesOfBmp(bmpFile({.header = 56,
                                  .width = 1,
                                  .height = 1,
                                  .bits = 32,
                                  .compression = 3,
                                  .masks = {0x3ff, 0xffc00, 0x3ff00000, 0xc0000000}},
                                 {0xff, 0x03, 0x00, 0x80})),
              ElementsAre(255, 0, 0, 170));
}

TEST(Bmp, OnlyAMaskMakesAlpha) {
  EXPECT_THAT(codesOfBmp(bmpFile({.width = 1, .height = 1, .bits = 32}, {3, 2, 1, 9})), ElementsAre(1, 2, 3, 255));
  const testing::BmpForm form{.header = 124,
                              .width = 1,
                              .height = 1,
                              .bits = 32,
                              .compression = 3,
                              .masks = {0xff0000, 0xff00, 0xff, 0xff000000}};
  EXPECT_THAT(codesOfBmp(bmpFile(form, {3, 2, 1, 9})), ElementsAre(1, 2, 3, 9));
  EXPECT_EQ(decodeImage(bmpFile(form, {3, 2, 1, 9}))->image.channels(), 4);
}

TEST(Bmp, RunsLiteralsAndSkips) {
  const testing::BmpForm rle8{.width = 4, .height = -2, .bits = 8, .compression = 1};
  EXPECT_THAT(indices(rle8, {2, 7, 0, 0, 0, 3, 1, 2, 3, 0, 0, 1}), ElementsAre(7, 7, 0, 0, 1, 2, 3, 0));
  EXPECT_THAT(indices(rle8, {0, 2, 1, 1, 1, 9, 0, 1}), ElementsAre(0, 0, 0, 0, 0, 9, 0, 0));
  // What would lie beyond a row's end is left out, and the code for the end may be.
  EXPECT_THAT(indices(rle8, {200, 1, 0, 0, 4, 2}), ElementsAre(1, 1, 1, 1, 2, 2, 2, 2));
  const testing::BmpForm rle4{.width = 5, .height = -1, .bits = 4, .compression = 2};
  EXPECT_THAT(indices(rle4, {3, 0x12, 0, 2, 0, 0, 0, 1}), ElementsAre(1, 2, 1, 0, 0));
  EXPECT_THAT(indices(rle4, {0, 5, 0x12, 0x34, 0x50, 0, 0, 1}), ElementsAre(1, 2, 3, 4, 5));
  testing::BmpForm cut = rle8;
  cut.palette = {0, 1, 2};
  EXPECT_THAT(refusedBmp(bmpFile(cut, {2, 1, 0, 3, 1})).message, HasSubstr("before the end of its first row"));
  EXPECT_EQ(decodeImage(bmpFile(cut, {2, 1, 0, 1}))->format, "BMP, 8 bit palette, RLE");
}

TEST(Bmp, TexelsThatBeginBeforeThePaletteLeaveItNoRoom) {
  for (const std::uint32_t colors : {0u, 1u}) {
    Bytes file = bmpFile({.width = 1, .height = 1, .bits = 8, .palette = {7}}, {0, 0, 0, 0});
    file[10] = 20;  // where the texels begin
    file[46] = static_cast<std::uint8_t>(colors);
    EXPECT_EQ(refusedBmp(file).code, ErrorCode::bad_file);
  }
}

TEST(Bmp, AProfileIsNamedAndOneOfAMatrixConverted) {
  testing::BmpForm form{.header = 124, .width = 1, .height = 1, .profile = testing::iccProfile("Display P3")};
  EXPECT_EQ(decodeImage(bmpFile(form, {3, 2, 1, 0}))->color,
            "sRGB assumed: its ICC profile (Display P3) is not applied");
  form.profile = testing::iccDisplayP3();
  const auto green = decodeImage(bmpFile(form, {0, 255, 0, 0}));
  EXPECT_EQ(green->color, "sRGB, primaries of the file (Display P3): converted");
  EXPECT_NEAR(green->image.samples()[0], -0.2249f, 1e-3f);  // the inverse of P3's matrix from sRGB, CSS Color 4
}

TEST(Bmp, WhatCannotBeReadIsNamed) {
  EXPECT_EQ(refusedBmp(bmpFile({.bits = 24, .compression = 5}, Bytes(24))).code, ErrorCode::unsupported);
  EXPECT_EQ(refusedBmp(bmpFile({.bits = 64}, Bytes(48))).code, ErrorCode::unsupported);
  EXPECT_EQ(refusedBmp(bmpFile({.bits = 24, .compression = 1}, Bytes(24))).code, ErrorCode::unsupported);
  EXPECT_EQ(refusedBmp(bmpFile({.header = 13}, Bytes(24))).code, ErrorCode::bad_file);
  EXPECT_EQ(refusedBmp(bmpFile({.width = -3}, Bytes(24))).code, ErrorCode::bad_file);
  EXPECT_FALSE(isBmp(testing::bytesOf("BMX is no bitmap but a text")));
}

TEST(Bmp, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  EXPECT_THAT(refusedBmp(bmpFile({.width = 5000, .height = 5000}, Bytes(24))).message, HasSubstr("cannot hold"));
  EXPECT_THAT(
      refusedBmp(bmpFile({.width = 2000, .height = 2000, .bits = 8, .compression = 1, .palette = {0}}, Bytes(24)))
          .message,
      HasSubstr("cannot hold"));
  EXPECT_EQ(refusedBmp(bmpFile({.width = 0x7fffffff, .height = -0x7fffffff - 1}, Bytes(24))).code,
            ErrorCode::too_large);
}

}  // namespace
}  // namespace mirrorball
