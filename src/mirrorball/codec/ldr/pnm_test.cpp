#include "mirrorball/codec/ldr/pnm.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<int> codesOfPnm(const std::string& file) {
  const auto texture = decodeTexture(bytesOf(file));
  EXPECT_TRUE(texture) << texture.error().message;
  return texture ? std::vector<int>(texture->samples().begin(), texture->samples().end()) : std::vector<int>();
}

DecodedImage decodedPnm(const std::string& file) {
  auto image = decodeImage(bytesOf(file));
  EXPECT_TRUE(image) << image.error().message;
  return image ? std::move(*image) : DecodedImage{};
}

Error refusedPnm(const std::string& file) {
  const auto result = decodePnm(bytesOf(file));
  EXPECT_FALSE(result) << file;
  if (result) return {};
  return result.error();
}

TEST(Pnm, InABitmapOneIsBlack) {
  EXPECT_THAT(codesOfPnm("P1\n# a comment\n3 1\n1 01"), ElementsAre(0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 255));
  EXPECT_THAT(codesOfPnm("P4 2 2\n\x40\x80"), ElementsAre(255, 255, 255, 255, 0, 0, 0, 255,  //
                                                          0, 0, 0, 255, 255, 255, 255, 255));
  EXPECT_EQ(decodedPnm("P4 2 2\n\x40\x80").format, "PBM");
  EXPECT_EQ(decodedPnm("P4 2 2\n\x40\x80").image.channels(), 1);
}

TEST(Pnm, GreyAndColorsAsTextAndAsBytes) {
  EXPECT_THAT(codesOfPnm("P2 2 1 15 # greatest\n0 # zero\n 15"), ElementsAre(0, 0, 0, 255, 255, 255, 255, 255));
  EXPECT_THAT(codesOfPnm("P3\n1\n1\n255\n1 2\n3\n"), ElementsAre(1, 2, 3, 255));
  EXPECT_THAT(codesOfPnm("P5 1 1 255\nA"), ElementsAre(65, 65, 65, 255));
  EXPECT_THAT(codesOfPnm("P6 1 1 255\n\n\r "), ElementsAre(10, 13, 32, 255));  // one blank ends the header
  EXPECT_EQ(decodedPnm("P6 1 1 255\nABC").format, "PPM, 0 to 255");
  EXPECT_EQ(decodedPnm("P3 1 1 255 1 2 3").format, "PPM, text, 0 to 255");
  EXPECT_EQ(decodedPnm("P6 1 1 255\nABC").color, "sRGB");
}

TEST(Pnm, SixteenBitsComeHighByteFirstAndKeepTheirPrecision) {
  const float light = decodedPnm("P5 1 1 65535\n\x12\x34").image.samples()[0];
  const std::uint16_t code = 0x1234;
  EXPECT_EQ(light, linearFromSamples16({&code, 1}, 1, 1, 1).samples()[0]);
  // 500 of 1000 is a half: 32768 of 65535.
  const std::uint16_t half = 32768;
  EXPECT_EQ(decodedPnm("P2 1 1 1000 500").image.samples()[0], linearFromSamples16({&half, 1}, 1, 1, 1).samples()[0]);
}

// Windows programs end lines with CR LF. Of a file of just the right size the LF is a sample.
TEST(Pnm, TheHeaderMayEndWithCrLf) {
  const std::string remark = "its header ends with CR LF: the samples begin behind both";
  EXPECT_THAT(codesOfPnm("P6\r\n1 1\r\n255\r\nABC"), ElementsAre(65, 66, 67, 255));
  EXPECT_THAT(decodedPnm("P6\r\n1 1\r\n255\r\nABC").oddities, ElementsAre(remark));
  EXPECT_THAT(codesOfPnm("P4 2 2\r\n\x40\x80").front(), 255);
  EXPECT_THAT(codesOfPnm("P7\r\nWIDTH 1\r\nHEIGHT 1\r\nDEPTH 1\r\nMAXVAL 255\r\nENDHDR\r\nA"),
              ElementsAre(65, 65, 65, 255));
  EXPECT_THAT(codesOfPnm("P6 1 1 255\r\nBC"), ElementsAre(10, 66, 67, 255));
  EXPECT_THAT(decodedPnm("P6 1 1 255\r\nBC").oddities, IsEmpty());
  EXPECT_THAT(codesOfPnm("P2\r\n1 1\r\n255\r\n7\r\n"), ElementsAre(7, 7, 7, 255));
  EXPECT_THAT(decodedPnm("P2\r\n1 1\r\n255\r\n7\r\n").oddities, IsEmpty());
}

TEST(Pnm, PamHasAlpha) {
  EXPECT_THAT(codesOfPnm("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\nABCD"),
              ElementsAre(65, 66, 67, 68));
  EXPECT_THAT(codesOfPnm("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 2\nMAXVAL 255\n# grey\nTUPLTYPE GRAYSCALE_ALPHA\nENDHDR\nAD"),
              ElementsAre(65, 65, 65, 68));
  EXPECT_THAT(codesOfPnm("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 1\nTUPLTYPE BLACKANDWHITE\nENDHDR\n\x01"),
              ElementsAre(255, 255, 255, 255));
  EXPECT_EQ(refusedPnm("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE CMYK\nENDHDR\nABCD").code,
            ErrorCode::unsupported);
  EXPECT_EQ(refusedPnm("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 5\nMAXVAL 255\nENDHDR\nABCDE").code, ErrorCode::unsupported);
}

TEST(Pnm, WhatIsWrongIsNamedWithItsPlace) {
  EXPECT_THAT(refusedPnm("P5 x 1 255\nA").message, HasSubstr("at byte 4 the width should be a number"));
  EXPECT_THAT(refusedPnm("P5 1").message,
              HasSubstr("the height should be a number up to 2147483647, and the file ends"));
  EXPECT_THAT(refusedPnm("P2 2 1 15 1 16").message, HasSubstr("a sample in row 0 is 16, above"));
  EXPECT_THAT(refusedPnm("P1 2 1 1 2").message, HasSubstr("0 or 1"));
  EXPECT_EQ(refusedPnm("P5 1 1 0\nA").code, ErrorCode::bad_file);
  EXPECT_EQ(refusedPnm("P5 1 1 65536\nAA").code, ErrorCode::bad_file);
  EXPECT_EQ(refusedPnm("P5 0 1 255\nA").code, ErrorCode::bad_file);
  EXPECT_THAT(refusedPnm("P7\nWIDTH 1\nLENGTH 1\n").message, HasSubstr("LENGTH"));
}

TEST(Pnm, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  EXPECT_THAT(refusedPnm("P6 5000 5000 255\nABC").message, HasSubstr("cannot hold"));
  EXPECT_THAT(refusedPnm("P3 5000 5000 255\n1 2 3").message, HasSubstr("cannot hold"));
  EXPECT_EQ(refusedPnm("P6 2147483647 2147483647 255\nABC").code, ErrorCode::too_large);
}

/// The bytes of floats in one order.
std::string floatBytes(std::initializer_list<float> floats, bool big_endian) {
  std::string bytes;
  for (const float value : floats)
    for (int i = 0; i < 4; ++i)
      bytes += static_cast<char>(bitCast<std::uint32_t>(value) >> 8 * (big_endian ? 3 - i : i));
  return bytes;
}

TEST(Pfm, RowsRunUpInEitherByteOrder) {
  for (const bool big_endian : {false, true}) {
    const std::string file = std::string("PF\n1 2\n") + (big_endian ? "1.0" : "-1.0") + "\n" +
                             floatBytes({1, 2, 3, 0.25f, 1e6f, -5}, big_endian);
    const auto image = decodePfm(bytesOf(file));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_THAT(image->image.samples(), ElementsAre(0.25f, 1e6f, -5.0f, 1.0f, 2.0f, 3.0f));
    EXPECT_EQ(image->format, big_endian ? "PFM, big-endian" : "PFM, little-endian");
    EXPECT_EQ(image->color, "linear, Rec.709");
  }
}

TEST(Pfm, TheScaleIsTheSamplesUnit) {
  const auto image = decodePfm(bytesOf("Pf 2 1 -2.5 " + floatBytes({1, 4}, false)));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->image.samples(), ElementsAre(2.5f, 10.0f));
  EXPECT_EQ(image->format, "PFM, little-endian, scaled by 2.5");
  EXPECT_FALSE(decodePfm(bytesOf("Pf 2 1 0 " + floatBytes({1, 4}, false))));
}

Result<DecodedImage> pfm(const std::string& file) { return decodePfm(bytesOf(file)); }

TEST(Pfm, TheHeaderMayEndWithCrLf) {
  const std::string samples = floatBytes({1, 2, 3, 0.25f, 1e6f, -5}, false);
  const auto image = pfm("PF\r\n1 2\r\n-1.0\r\n" + samples);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->image.samples(), ElementsAre(0.25f, 1e6f, -5.0f, 1.0f, 2.0f, 3.0f));
  EXPECT_THAT(image->oddities, ElementsAre("its header ends with CR LF: the samples begin behind both"));
  // The LF is the first byte of the sample 0x3f80000a.
  const auto exact = pfm(std::string("Pf 1 1 -1\r\n") + '\0' + "\x80\x3f");
  ASSERT_TRUE(exact) << exact.error().message;
  EXPECT_EQ(exact->image.samples()[0], bitCast<float>(0x3f80000au));
  EXPECT_THAT(exact->oddities, IsEmpty());
}

TEST(Pfm, TheScaleMayHaveADecimalComma) {
  const auto image = pfm("Pf 2 1 -2,500000\n" + floatBytes({1, 4}, false));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->image.samples(), ElementsAre(2.5f, 10.0f));
  EXPECT_THAT(image->oddities, ElementsAre("its scale has a decimal comma: read as a point"));
  EXPECT_FALSE(pfm("Pf 2 1 -1,0.0\n" + floatBytes({1, 4}, false)));
}

TEST(Pfm, AHeaderWithCrLfIsOneInAFileThatEndsEarlyToo) {
  const std::string file = "PF\r\n1 3\r\n-1.0\r\n" + floatBytes({1, 2, 3, 4, 5, 6, 7, 8, 9}, false);
  for (const std::size_t missing : {1, 5, 12}) {
    const auto image = pfm(file.substr(0, file.size() - missing));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_THAT(image->image.samples(), ElementsAre(0.0f, 0.0f, 0.0f, 4.0f, 5.0f, 6.0f, 1.0f, 2.0f, 3.0f)) << missing;
    EXPECT_EQ(image->oddities.size(), 2u);
  }
}

TEST(Pfm, OfFourChannelsHasAlphaWithoutTheSamplesUnit) {
  const auto image = pfm("PF4\n2 1\n-2.0\n" + floatBytes({1, 2, 3, 0.5f, 5, 6, 7, 1}, false));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->image.samples(), ElementsAre(2.0f, 4.0f, 6.0f, 0.5f, 10.0f, 12.0f, 14.0f, 1.0f));
  EXPECT_EQ(image->format, "PFM with alpha, little-endian, scaled by 2");
  EXPECT_FALSE(isPfm(bytesOf("PF5\n2 1\n-1.0\n")));
  EXPECT_FALSE(isPfm(bytesOf("Pf4\n2 1\n-1.0\n")));
}

TEST(Pfm, ATruncatedRowAloneIsAnError) {
  const std::string file = "Pf 2 1 -1\n" + floatBytes({1, 4}, false);
  for (std::size_t length = 3; length < file.size(); ++length)
    EXPECT_FALSE(decodePfm(bytesOf(file.substr(0, length)))) << length;
  EXPECT_THAT(decodePfm(bytesOf("PF 8000 8000 -1\nabcd")).error().message, HasSubstr("cannot hold"));
}

}  // namespace
}  // namespace mirrorball
