#include "mirrorball/codec/hdr/hdr.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/codec/image_file_testing.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::ElementsAre;
using testing::gradient;
using ::testing::HasSubstr;

/// A picture file of a header and texel bytes.
Bytes file(const std::string& variables, const std::string& resolution, std::initializer_list<int> texels) {
  Bytes bytes = bytesOf("#?RADIANCE\n" + variables + "\n" + resolution + "\n");
  for (const int byte : texels) bytes.push_back(static_cast<std::uint8_t>(byte));
  return bytes;
}

/// The red channel as the mantissas that stand in the file, if their exponent is 136.
std::vector<int> reds(const Image& image) {
  std::vector<int> found;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) found.push_back(static_cast<int>(image.texel(x, y)[0]));
  return found;
}

Image decoded(const Bytes& bytes) {
  auto result = decodeHdr(bytes);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return Image(1, 1, 3);
  }
  return std::move(result->image);
}

Error decodingError(const Bytes& bytes) {
  const auto result = decodeHdr(bytes);
  if (result) {
    ADD_FAILURE() << "was read";
    return {};
  }
  return result.error();
}

Image oneTexel(glm::vec3 light) {
  Image image(1, 1, 3);
  for (int c = 0; c < 3; ++c) image.texel(0, 0)[c] = light[c];
  return image;
}

glm::vec3 roundTrip(glm::vec3 light) { return rgbAt(decoded(encodeHdr(oneTexel(light), {})), 0, 0); }

class HdrSize : public ::testing::TestWithParam<glm::ivec2> {};

TEST_P(HdrSize, RoundTripIsWithinHalfAMantissaStep) {
  const Image image = gradient(GetParam().x, GetParam().y, 3);
  const Image back = decoded(encodeHdr(image, {}));
  ASSERT_EQ(back.width(), image.width());
  ASSERT_EQ(back.height(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3 light = rgbAt(image, x, y);
      // The brightest mantissa is at least 128, so half a step is at most 1/256 of it.
      const float step = std::max({light.x, light.y, light.z}) / 256.0f;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(back.texel(x, y)[c], light[c], step) << x << ", " << y;
    }
}

// 7 and 32768 are just outside what run lengths are defined for, 8 and 32767 just inside.
INSTANTIATE_TEST_SUITE_P(Sizes, HdrSize,
                         ::testing::Values(glm::ivec2{1, 1}, glm::ivec2{7, 3}, glm::ivec2{8, 5}, glm::ivec2{300, 40},
                                           glm::ivec2{32767, 2}, glm::ivec2{32768, 2}));

TEST(Hdr, WhiteAndPowersOfTwoAreExact) {
  for (const float light : {1.0f, 0.5f, 2.0f, 1024.0f, 0x1p-100f, 0x1p+100f})
    EXPECT_EQ(roundTrip(glm::vec3(light)), glm::vec3(light));
  EXPECT_EQ(roundTrip({1.0f, 0.25f, 0.0f}), glm::vec3(1.0f, 0.25f, 0.0f));
}

TEST(Hdr, MantissasAreRounded) {
  EXPECT_EQ(roundTrip({129.6f / 128.0f, 0, 0}).x, 130.0f / 128.0f);
  EXPECT_EQ(roundTrip({129.4f / 128.0f, 0, 0}).x, 129.0f / 128.0f);
  EXPECT_EQ(roundTrip({255.7f / 256.0f, 0, 0}).x, 1.0f) << "rounding carries into the exponent";
}

TEST(Hdr, WhatHasNoCodeIsClipped) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kBrightest = 0x1.fep+126f;
  EXPECT_EQ(roundTrip({-1.0f, 1.0f, std::nanf("")}), glm::vec3(0.0f, 1.0f, 0.0f));
  EXPECT_EQ(roundTrip(glm::vec3(kInfinity)), glm::vec3(kBrightest));
  EXPECT_EQ(roundTrip(glm::vec3(std::numeric_limits<float>::max())), glm::vec3(kBrightest));
  EXPECT_EQ(roundTrip(glm::vec3(std::numeric_limits<float>::denorm_min())), glm::vec3(0.0f));
}

TEST(Hdr, GreyIsWrittenToAllComponentsAndAlphaDropped) {
  EXPECT_EQ(rgbAt(decoded(encodeHdr(Image(1, 1, 1, 0.5f), {})), 0, 0), glm::vec3(0.5f));
  EXPECT_EQ(decoded(encodeHdr(Image(2, 2, 4, 0.5f), {})).channels(), 3);
}

TEST(Hdr, RunsAreWrittenShorterThanTheirTexels) {
  const Bytes bytes = encodeHdr(Image(1000, 1, 3, 1.0f), {});
  // The header, the line's marker, and for each component 8 runs of 2 bytes.
  EXPECT_EQ(bytes.size(), std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1000\n").size() + 4 + 4 * 8 * 2);
}

TEST(Hdr, NewRunLengthsByHand) {
  const auto result = decodeHdr(file("", "-Y 1 +X 8", {2,       2,   0, 8,               // marker and length
                                                       128 + 3, 9,   5, 1,  2, 3, 4, 5,  // R: 9 9 9, then five literals
                                                       128 + 8, 0,                       // G
                                                       128 + 8, 0,                       // B
                                                       128 + 7, 136, 1, 137}));  // E: the last is twice as bright
  ASSERT_TRUE(result);
  EXPECT_THAT(reds(result->image), ElementsAre(9, 9, 9, 1, 2, 3, 4, 10));
  EXPECT_EQ(result->format, "Radiance HDR, RLE");
}

TEST(Hdr, OldRunLengthsByHand) {
  const auto result = decodeHdr(file("", "-Y 2 +X 4", {7, 0, 0, 136, 1, 1, 1, 3,  // one texel, three times more
                                                       5, 0, 0, 136, 6, 0, 0, 136, 1, 1, 1, 2}));
  ASSERT_TRUE(result);
  EXPECT_THAT(reds(result->image), ElementsAre(7, 7, 7, 7, 5, 6, 6, 6));
  EXPECT_EQ(result->format, "Radiance HDR, old RLE");
}

TEST(Hdr, OldRunsInARowCountInDigitsOf256) {
  // 1 + 3 + 2 · 256 texels, then one more.
  const Image image = decoded(file("", "-Y 1 +X 517", {7, 0, 0, 136, 1, 1, 1, 3, 1, 1, 1, 2, 8, 0, 0, 136}));
  EXPECT_EQ(image.texel(515, 0)[0], 7.0f);
  EXPECT_EQ(image.texel(516, 0)[0], 8.0f);
}

TEST(Hdr, FlatTexels) {
  const auto result = decodeHdr(file("", "-Y 1 +X 2", {3, 6, 9, 136, 1, 2, 3, 0}));
  ASSERT_TRUE(result);
  EXPECT_EQ(rgbAt(result->image, 0, 0), glm::vec3(3, 6, 9));
  EXPECT_EQ(rgbAt(result->image, 1, 0), glm::vec3(0)) << "exponent 0 is black";
  EXPECT_EQ(result->format, "Radiance HDR, flat");
}

struct Orientation {
  const char* resolution;
  std::vector<int> rows;
};

class HdrOrientation : public ::testing::TestWithParam<Orientation> {};

TEST_P(HdrOrientation, TexelsGoWhereTheLineSays) {
  const Image image = decoded(file("", GetParam().resolution, {1, 0, 0, 136, 2, 0, 0, 136, 3, 0, 0, 136,  //
                                                               4, 0, 0, 136, 5, 0, 0, 136, 6, 0, 0, 136}));
  ASSERT_EQ(image.width(), 3);
  EXPECT_EQ(reds(image), GetParam().rows);
}

INSTANTIATE_TEST_SUITE_P(
    AllEight, HdrOrientation,
    ::testing::Values(Orientation{"-Y 2 +X 3", {1, 2, 3, 4, 5, 6}}, Orientation{"-Y 2 -X 3", {3, 2, 1, 6, 5, 4}},
                      Orientation{"+Y 2 +X 3", {4, 5, 6, 1, 2, 3}}, Orientation{"+Y 2 -X 3", {6, 5, 4, 3, 2, 1}},
                      Orientation{"+X 3 -Y 2", {1, 3, 5, 2, 4, 6}}, Orientation{"+X 3 +Y 2", {2, 4, 6, 1, 3, 5}},
                      Orientation{"-X 3 -Y 2", {5, 3, 1, 6, 4, 2}}, Orientation{"-X 3 +Y 2", {6, 4, 2, 5, 3, 1}}));

TEST(Hdr, ColumnsMayBeRunLengthCodedToo) {
  const std::initializer_list<int> texels = {2, 2, 0, 8, 136, 1, 136, 0, 136, 0, 136, 136,
                                             2, 2, 0, 8, 136, 2, 136, 0, 136, 0, 136, 136};
  const Image image = decoded(file("", "+X 2 -Y 8", texels));
  EXPECT_EQ(image.height(), 8);
  EXPECT_EQ(image.texel(0, 7)[0], 1.0f);
  EXPECT_EQ(image.texel(1, 0)[0], 2.0f);
}

TEST(Hdr, ExposureIsDividedOut) {
  const Image image = decoded(file("EXPOSURE=2\nEXPOSURE= 4.0\nCOLORCORR=1 0.5 2\n", "-Y 1 +X 1", {64, 64, 64, 136}));
  EXPECT_EQ(rgbAt(image, 0, 0), glm::vec3(8, 16, 4));
}

// Textures of normals and roughness come out of programs that state the exposure of a picture.
TEST(Hdr, ExposureIsNotDividedOutOfNumbers) {
  const std::string format = "FORMAT=32-bit_rle_rgbe\n";
  const Bytes one = file(format + "EXPOSURE=2\nEXPOSURE=4\n", "-Y 1 +X 1", {64, 128, 32, 128});
  const auto numbers = decodeHdr(one, {.as = ReadAs::numbers});
  ASSERT_TRUE(numbers) << numbers.error().message;
  EXPECT_EQ(rgbAt(numbers->image, 0, 0), glm::vec3(0.25f, 0.5f, 0.125f));
  EXPECT_THAT(numbers->oddities, ElementsAre("states an exposure (8), which is not divided out of numbers: they are "
                                             "read as they are stored"));
  EXPECT_FALSE(numbers->is_converted);
  EXPECT_TRUE(decodeHdr(one)->is_converted) << "a material that reads numbers in the same picture decodes it anew";
  const auto three =
      decodeHdr(file(format + "COLORCORR=1 0.5 2\n", "-Y 1 +X 1", {64, 128, 32, 128}), {.as = ReadAs::numbers});
  EXPECT_EQ(rgbAt(three->image, 0, 0), glm::vec3(0.25f, 0.5f, 0.125f));
  EXPECT_THAT(three->oddities, ElementsAre(HasSubstr("states an exposure (1, 0.5, 2)")));
  const Bytes plain = file(format + "EXPOSURE=1\n", "-Y 1 +X 1", {64, 128, 32, 128});
  EXPECT_THAT(decodeHdr(plain, {.as = ReadAs::numbers})->oddities, ::testing::IsEmpty());
  EXPECT_FALSE(decodeHdr(plain)->is_converted);
}

TEST(Hdr, SeveralCorrectionsMultiply) {
  const Image image =
      decoded(file("COLORCORR=2 1 0.5\nEXPOSURE=0.5\nCOLORCORR= 2 4  1\n", "-Y 1 +X 1", {64, 64, 64, 136}));
  EXPECT_EQ(rgbAt(image, 0, 0), glm::vec3(32, 32, 256));
}

TEST(Hdr, XyzBecomesRec709) {
  // D65's XYZ is (0.9505, 1, 1.0888). These are the nearest mantissas over 128; their steps of 0.4
  // % come out up to 3.2 times as large.
  const auto result = decodeHdr(file("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", {122, 128, 139, 129}));
  ASSERT_TRUE(result);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(result->image.samples()[std::size_t(c)], 1.0f, 0.0125f);
  EXPECT_EQ(result->format, "Radiance HDR, XYZE, flat");
  EXPECT_EQ(result->color, "CIE XYZ: converted");
}

TEST(Hdr, PrimariesAreConvertedUnlessTheyAreNone) {
  const auto red = [](const std::string& primaries) {
    return rgbAt(decoded(file("PRIMARIES=" + primaries + "\n", "-Y 1 +X 1", {128, 0, 0, 129})), 0, 0);
  };
  EXPECT_EQ(red("0 0 0 0 0 0 0 0"), glm::vec3(1, 0, 0));
  EXPECT_EQ(red("0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290"), glm::vec3(1, 0, 0));
  EXPECT_NEAR(red("0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290").x, 1.6605f, 1e-3f);
}

TEST(Hdr, PrimariesOtherThanRec709AreStated) {
  const auto text = [](OutputPrimaries primaries) {
    const Bytes bytes = encodeHdr(Image(1, 1, 3, 1.0f), {}, primaries);
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_THAT(text(OutputPrimaries::acescg),
              HasSubstr("\nPRIMARIES=0.713 0.293 0.165 0.83 0.128 0.044 0.32168 0.33767\nFORMAT="));
  EXPECT_THAT(text(OutputPrimaries::rec709), ::testing::Not(HasSubstr("PRIMARIES")));
}

TEST(Hdr, LightOfOtherPrimariesComesBackToAMantissasDigits) {
  const std::array<const char*, 3> names{"Display P3", "Rec.2020", "ACES AP1"};
  for (const OutputPrimaries primaries : {OutputPrimaries::p3, OutputPrimaries::rec2020, OutputPrimaries::acescg}) {
    const glm::vec3 light(1e5f, 2.5e4f, 5e4f);
    Image image = oneTexel(light);
    convertFromRec709(image, primaries);
    const auto back = decodeHdr(encodeHdr(image, {}, primaries));
    ASSERT_TRUE(back);
    // Half a step of 8 bits, and what the way back makes of it.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgbAt(back->image, 0, 0)[c], light[c], 1.7f * 1e5f / 256.0f);
    EXPECT_THAT(back->color, HasSubstr(names[static_cast<std::size_t>(primaries) - 1]));
  }
}

// Each program that touches a picture adds its lines; the last PRIMARIES tell what stands there now.
TEST(Hdr, OfSeveralPrimariesTheLastCount) {
  const auto result =
      decodeHdr(file("PRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329\nEXPOSURE=2\n"
                     "PRIMARIES=0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290\n",
                     "-Y 1 +X 1", {128, 0, 0, 130}));
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->image.samples()[0], 1.6605f, 1e-3f);
  EXPECT_EQ(result->color, "linear, primaries of the file (Rec.2020): converted");
}

// Run lengths, orientation and colour meet in one file.
TEST(Hdr, EveryRunLengthFormMayHaveExposureAndXyz) {
  const std::string variables = "FORMAT=32-bit_rle_xyze\nEXPOSURE=4\n";
  const Image flat = decoded(file(variables, "-Y 1 +X 8", {9, 8, 7, 138, 9, 8, 7, 138, 9, 8, 7, 138, 9, 8, 7, 138,
                                                           9, 8, 7, 138, 9, 8, 7, 138, 9, 8, 7, 138, 9, 8, 7, 138}));
  const Image old_rle = decoded(file(variables, "-Y 1 -X 8", {9, 8, 7, 138, 1, 1, 1, 7}));
  const Image new_rle =
      decoded(file(variables, "+Y 1 -X 8", {2, 2, 0, 8, 128 + 8, 9, 128 + 8, 8, 128 + 8, 7, 128 + 8, 138}));
  EXPECT_THAT(old_rle.samples(), ::testing::ElementsAreArray(flat.samples()));
  EXPECT_THAT(new_rle.samples(), ::testing::ElementsAreArray(flat.samples()));
  const glm::vec3 expected = formula::rec709FromXyz(glm::vec3(9, 8, 7));  // · 2^(138 − 136) / 4
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(flat.texel(7, 0)[c], expected[c], 1e-5f);
}

TEST(Hdr, HeaderMayHaveCommentsUnknownLinesAndCarriageReturns) {
  Bytes bytes = bytesOf(
      "#?RGBE\r\n# Made by hand\r\n# mirrorball:projection=sphere\r\n\tpfilt -x 3\r\nGAMMA=1\r\n"
      "FORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n");
  bytes.insert(bytes.end(), {9, 0, 0, 136});
  const auto result = decodeHdr(bytes);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->image.samples()[0], 9.0f);
  EXPECT_EQ(result->metadata, (Metadata{{"mirrorball:projection", "sphere"}}));
}

TEST(Hdr, MetadataComesBack) {
  const Metadata metadata{{"mirrorball:projection", "cube"}, {"mirrorball:layout", "hcross"}};
  EXPECT_EQ(decodeHdr(encodeHdr(Image(1, 1, 3), metadata))->metadata, metadata);
}

TEST(Hdr, HeaderErrorsNameTheLine) {
  EXPECT_EQ(decodingError(file("FORMAT=32-bit_rle_spec\n", "-Y 1 +X 1", {})).code, ErrorCode::unsupported);
  EXPECT_THAT(decodingError(file("A=1\nFORMAT=raw\n", "-Y 1 +X 1", {})).message, HasSubstr("line 3"));
  EXPECT_THAT(decodingError(file("PRIMARIES=1 2\n", "-Y 1 +X 1", {})).message, HasSubstr("8 numbers behind"));
  for (const char* resolution :
       {"Y 1 +X 1", "-Y 1", "-Y 1 +Y 1", "-Y one +X 1", "-Y 1.5 +X 1", "-Y 1e300 +X 1", "-Z 1 +X 1", "-Y 1 +X 1 1"})
    EXPECT_THAT(decodingError(file("", resolution, {1, 1, 1, 1})).message, HasSubstr("line 3 should be the resolution"))
        << resolution;
}

TEST(Hdr, WhatTheHeaderSaysIsQuoted) {
  const auto image = decodeHdr(file("FORMAT=\x1b[2J\x9b" + std::string(100'000, 'x') + "\n", "-Y 1 +X 1", {}));
  ASSERT_FALSE(image);
  EXPECT_THAT(image.error().message, HasSubstr("'?[2J?xxx"));
  EXPECT_THAT(image.error().message, HasSubstr("bytes more)'"));
  EXPECT_LT(image.error().message.size(), 300u);
}

TEST(Hdr, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  EXPECT_EQ(decodingError(file("", "-Y 0 +X 1", {1, 1, 1, 1})).code, ErrorCode::bad_file);
  EXPECT_EQ(decodingError(file("", "-Y 1 +X -1", {1, 1, 1, 1})).code, ErrorCode::bad_file);
  EXPECT_EQ(decodingError(file("", "-Y 2147483648 +X 1", {1, 1, 1, 1})).code, ErrorCode::too_large);
  EXPECT_EQ(decodingError(file("", "-Y 2147483648 +X 2147483648", {1, 1, 1, 1})).code, ErrorCode::too_large);
  EXPECT_THAT(decodingError(file("", "-Y 32768 +X 32768", {1, 1, 1, 1})).message, HasSubstr("truncated"));
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 1073741824", {9, 1, 1, 1, 1, 1, 1, 255})).message,
              HasSubstr("truncated"));
}

TEST(Hdr, WrongScanLinesAreNamed) {
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 8", {2, 2, 0, 9, 0, 0, 0, 0})).message,
              HasSubstr("length is not the image's"));
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 8", {2, 2, 0, 8, 0, 0, 0, 0})).message, HasSubstr("run of no bytes"));
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 8", {2, 2, 0, 8, 128 + 9, 0, 0, 0})).message,
              HasSubstr("longer than its scan line"));
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 2", {5, 5, 5, 136, 1, 1, 1, 2})).message,
              HasSubstr("longer than its scan line"));
  EXPECT_THAT(decodingError(file("", "-Y 1 +X 2", {1, 1, 1, 1, 5, 5, 5, 136})).message,
              HasSubstr("begins with a repetition"));
  EXPECT_THAT(decodingError(file("", "-Y 2 +X 3", {5, 5, 5, 136, 5, 5, 5, 136})).message,
              HasSubstr("end of its first row"));
}

// Behind it the bytes pass for flat texels.
TEST(Hdr, ADamagedScanLineIsNotAnEarlyEnd) {
  Bytes damaged = file("", "-Y 4 +X 8", {2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 130});
  damaged.resize(damaged.size() + 40, 5);
  EXPECT_THAT(decodingError(damaged).message, HasSubstr("truncated or damaged before (scan line 2 of 4)"));
}

TEST(Hdr, RealFile) {
  const auto path = testing::sharedData("lightroom_14b.hdr");
  if (!path) GTEST_SKIP() << "no shared data: set MIRRORBALL_DATA";
  const auto result = readImage(*path);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->image.width(), 2048);
  EXPECT_EQ(result->image.height(), 1024);
  EXPECT_EQ(result->format, "Radiance HDR, RLE");
  // As a decoder of ten lines of Python reads it.
  EXPECT_EQ(result->image.texel(0, 0)[0], 1.109375f);
  EXPECT_EQ(result->image.texel(500, 300)[1], 4.40625f);
  EXPECT_EQ(result->image.texel(2047, 1023)[2], 0.41015625f);
  double sum = 0;
  for (std::size_t i = 1; i < result->image.samples().size(); i += 3)
    sum += static_cast<double>(result->image.samples()[i]);
  EXPECT_NEAR(sum / (2048 * 1024), 0.7116047065865132, 1e-12);
}

}  // namespace
}  // namespace mirrorball
