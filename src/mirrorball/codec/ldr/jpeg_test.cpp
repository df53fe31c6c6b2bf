#include "mirrorball/codec/ldr/jpeg.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/ldr/jpeg_testing.h"
#include "mirrorball/codec/written_format_testing.h"
#include "mirrorball/image/upright.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Smooth, as photographs are at the scale of a block.
Image8 photograph(int width, int height, int channels) {
  Image8 picture(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        picture.texel(x, y)[c] = static_cast<std::uint8_t>(128.0 + 100.0 * std::sin(0.05 * x + 0.08 * y + c));
  return picture;
}

Bytes encoded(const Image8& picture, const Metadata& metadata = {}) {
  auto result = encodeJpeg(picture, metadata);
  EXPECT_TRUE(result);
  return result ? std::move(*result) : Bytes();
}

/// A small grey picture as this program does not write it.
Bytes foreignFile(const testing::JpegForm& form) { return testing::jpegFile(Image8(20, 20, form.channels, 100), form); }

/// Where the frame header's marker stands (SOF0: baseline).
std::size_t frameHeader(const Bytes& bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); ++i)
    if (bytes[i] == 0xff && bytes[i + 1] == 0xc0) return i;
  ADD_FAILURE() << "no frame header";
  return 0;
}

class JpegSize : public ::testing::TestWithParam<std::tuple<glm::ivec2, int>> {};

TEST_P(JpegSize, ComesBackWithinItsQuality) {
  const auto [size, channels] = GetParam();
  const Image8 picture = photograph(size.x, size.y, channels);
  const auto back = decodeTexture(encoded(picture));
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->width(), size.x);
  ASSERT_EQ(back->height(), size.y);
  double sum = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      for (int c = 0; c < 3; ++c)
        sum += std::pow(back->texel(x, y)[c] - picture.texel(x, y)[channels == 1 ? 0 : c], 2.0);
  // 40 dB, what quality 95 keeps of smooth pictures: an RMS of 2.55 codes.
  EXPECT_LT(std::sqrt(sum / (3.0 * size.x * size.y)), 2.55);
  EXPECT_EQ(back->samples()[3], 255);
}

INSTANTIATE_TEST_SUITE_P(SizesAndChannels, JpegSize,
                         ::testing::Combine(::testing::Values(glm::ivec2{1, 1}, glm::ivec2{7, 3}, glm::ivec2{120, 70}),
                                            ::testing::Values(1, 3, 4)));

TEST(Jpeg, LightIsLinearAndGreyHasOneChannel) {
  const auto grey = decodeJpeg(encoded(Image8(9, 9, 1, 128)));
  ASSERT_TRUE(grey);
  EXPECT_EQ(grey->image.channels(), 1);
  EXPECT_EQ(srgb8FromLinear(grey->image.samples()[0]), 128);
  EXPECT_EQ(grey->format, "JPEG, 8 bit");
  EXPECT_EQ(grey->color, "sRGB, grey");
  EXPECT_EQ(decodeJpeg(encoded(Image8(9, 9, 3, 128)))->image.channels(), 3);
}

TEST(Jpeg, ChromaIsNotSubsampled) {
  const Bytes bytes = encoded(photograph(16, 16, 3));
  // Marker, length, precision, height, width, then for each component: number, sampling, table.
  const std::size_t components = frameHeader(bytes) + 2 + 2 + 1 + 2 + 2 + 1;
  for (std::size_t component = 0; component < 3; ++component) EXPECT_EQ(bytes[components + 3 * component + 1], 0x11);
}

TEST(Jpeg, MetadataComesBack) {
  const Metadata metadata{{"mirrorball:projection", "sphere"}, {"envmap", "latlong"}};
  EXPECT_EQ(decodeJpeg(encoded(Image8(2, 2, 3), metadata))->metadata, metadata);
}

TEST(Jpeg, AProfileOfAMatrixIsConverted) {
  Image8 orange(8, 8, 3, 128);
  for (int i = 0; i < 64; ++i) orange.texel(i % 8, i / 8)[0] = 255;
  const Bytes plain = encoded(orange);
  const glm::vec3 codes = rgbAt(decodeJpeg(plain)->image, 4, 4);
  const auto p3 = decodeJpeg(testing::jpegWithProfile(plain, testing::iccDisplayP3()));
  ASSERT_TRUE(p3) << p3.error().message;
  EXPECT_EQ(p3->color, "sRGB, primaries of the file (Display P3): converted");
  const glm::vec3 expected = *rec709FromPrimaries(kDisplayP3) * codes;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgbAt(p3->image, 4, 4)[c], expected[c], 1e-3f);
  EXPECT_EQ(decodeTexture(testing::jpegWithProfile(plain, testing::iccDisplayP3()))->samples()[0],
            decodeTexture(plain)->samples()[0])
      << "textures are left as they stand";
}

TEST(Jpeg, AProfileOfANameAloneIsNotApplied) {
  const Bytes plain = encoded(Image8(9, 9, 3, 128));
  const auto adobe = decodeJpeg(testing::jpegWithProfile(plain, testing::iccProfile("Adobe RGB (1998)")));
  ASSERT_TRUE(adobe) << adobe.error().message;
  EXPECT_EQ(adobe->color, "sRGB assumed: its ICC profile (Adobe RGB (1998)) is not applied");
  EXPECT_EQ(srgb8FromLinear(adobe->image.samples()[0]), 128);
  EXPECT_EQ(decodeJpeg(testing::jpegWithProfile(plain, testing::iccProfile("sRGB IEC61966-2.1")))->color, "sRGB");
  // Bytes of a profile are no comment.
  EXPECT_TRUE(decodeJpeg(testing::jpegWithProfile(plain, bytesOf("envmap=cube")))->metadata.empty());
}

TEST(Jpeg, IsUprightAsItsExifSays) {
  const Image8 source = photograph(24, 16, 3);
  const Bytes plain = encoded(source);
  const Image8 stored = *decodeTexture(plain);
  for (int orientation = 2; orientation <= 8; ++orientation) {
    const auto turned = decodeImage(testing::withExif(plain, {.orientation = orientation}));
    ASSERT_TRUE(turned) << turned.error().message;
    EXPECT_THAT(turned->oddities, ::testing::ElementsAre("turned upright, as its EXIF says (orientation " +
                                                         std::to_string(orientation) + ")"));
    const Image8 expected = upright(Image8(stored), orientation);
    ASSERT_EQ(turned->image.width(), expected.width());
    EXPECT_EQ(srgb8FromLinear(turned->image.texel(5, 9)[1]), expected.texel(5, 9)[1]);
    EXPECT_THAT(decodeTexture(testing::withExif(plain, {.orientation = orientation}))->samples(),
                ::testing::ElementsAreArray(expected.samples()));
  }
}

TEST(Jpeg, ProgressiveIsRead) { EXPECT_TRUE(decodeJpeg(foreignFile({.progressive = true}))); }

// Such a file takes hours for a few megabytes (of a large image; here it is small).
TEST(Jpeg, AFileOfEndlessScansIsRefused) {
  // The mean of each block, then all other frequencies: a scan that may come again and again.
  const Bytes bytes =
      foreignFile({.channels = 1, .progressive = true, .scans = {{1, {0}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 0}}});
  constexpr std::array<std::uint8_t, 2> kStartOfScan{0xff, 0xda};
  const auto scan = std::find_end(bytes.begin(), bytes.end(), kStartOfScan.begin(), kStartOfScan.end());
  const auto end = bytes.end() - 2;  // of the last scan: the end marker follows
  Bytes again(bytes.begin(), end);
  for (int i = 0; i < 600; ++i) again.insert(again.end(), scan, end);
  again.insert(again.end(), end, bytes.end());
  ASSERT_TRUE(decodeJpeg(bytes));
  const auto refused = decodeJpeg(again);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_file);
  EXPECT_THAT(refused.error().message, StartsWith("is a damaged JPEG, at byte "));
  EXPECT_THAT(refused.error().message, HasSubstr("more than 500 scans"));
}

TEST(Jpeg, WhatCannotBeReadIsNamed) {
  Bytes twelve_bits = encoded(photograph(16, 16, 3));
  twelve_bits[frameHeader(twelve_bits) + 4] = 12;
  EXPECT_EQ(decodeJpeg(twelve_bits).error().code, ErrorCode::unsupported);
  EXPECT_THAT(decodeJpeg(twelve_bits).error().message, StartsWith("is a JPEG of 12 bits a sample, and those of 8"));

  Bytes lossless = encoded(photograph(16, 16, 3));
  lossless[frameHeader(lossless) + 1] = 0xc3;
  EXPECT_EQ(decodeJpeg(lossless).error().code, ErrorCode::unsupported);
  EXPECT_THAT(decodeJpeg(lossless).error().message, StartsWith("is a lossless JPEG; save it as"));
}

/// One colour of four inks, as the file stores them.
Image8 inks(std::uint8_t cyan, std::uint8_t magenta, std::uint8_t yellow, std::uint8_t black) {
  Image8 picture(16, 16, 4);
  const std::array<std::uint8_t, 4> codes{cyan, magenta, yellow, black};
  for (std::size_t i = 0; i < picture.samples().size(); ++i) picture.samples()[i] = codes[i % 4];
  return picture;
}

// Adobe's programs store what the inks let through: 255 is none of them. Browsers take every file so.
TEST(Jpeg, InksAreMixed) {
  struct InkCase {
    testing::JpegForm form;
    Image8 stored;
    const char* remark;
  };
  const char* const adobe = "is in inks (CMYK): mixed to RGB by their product, without a profile of them";
  for (const InkCase& c :
       {InkCase{{.channels = 4}, inks(255, 200, 100, 128), adobe},
        InkCase{{.channels = 4, .stored = JCS_YCCK}, inks(255, 200, 100, 128), adobe},
        InkCase{{.channels = 4, .has_adobe_marker = false},
                inks(255, 200, 100, 128),
                "is in inks (CMYK): mixed to RGB by their product, without a profile of them; 255 is taken as no ink, "
                "though Adobe's marker is missing"}}) {
    SCOPED_TRACE(c.remark);
    const Bytes bytes = testing::jpegFile(c.stored, c.form);
    const auto codes = decodeCodes(bytes);
    ASSERT_TRUE(codes) << codes.error().message;
    EXPECT_THAT(codes->oddities, ::testing::ElementsAre(c.remark));
    // The products with 128 of 255; JPEG itself is off by a code or two.
    const std::array<int, 4> expected{128, 100, 50, 255};
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(codes->codes.texel(5, 9)[channel], expected[std::size_t(channel)], 2);
    const auto light = decodeImage(bytes);
    EXPECT_EQ(light->image.channels(), 3);
    EXPECT_EQ(light->format, "JPEG, 8 bit, CMYK");
    EXPECT_NEAR(srgb8FromLinear(light->image.texel(5, 9)[1]), 100, 2);
  }
}

// A profile of inks says nothing of the colours that are made of them here.
TEST(Jpeg, TheProfileOfInksIsNamedAndNotApplied) {
  const Bytes plain = testing::jpegFile(inks(255, 200, 100, 128), {.channels = 4});
  const auto codes = decodeCodes(testing::jpegWithProfile(plain, testing::iccDisplayP3()));
  ASSERT_TRUE(codes) << codes.error().message;
  EXPECT_THAT(codes->oddities, ::testing::ElementsAre("is in inks (CMYK): mixed to RGB by their product, without their "
                                                      "profile (Display P3)"));
  EXPECT_EQ(codes->codes.samples()[0], decodeTexture(plain)->samples()[0]);
}

/// The same picture, its height in a DNL segment before the end marker.
Bytes withHeightAtEnd(Bytes jpeg) {
  const std::size_t height = frameHeader(jpeg) + 5;
  const Bytes segment = jpegSegment(0xdc, std::span<const std::uint8_t>(jpeg).subspan(height, 2));
  jpeg[height] = jpeg[height + 1] = 0;
  jpeg.insert(jpeg.end() - 2, segment.begin(), segment.end());
  return jpeg;
}

TEST(Jpeg, TheHeightMayStandBehindTheScan) {
  const Bytes plain = encoded(photograph(24, 40, 3));
  const Bytes late = withHeightAtEnd(plain);
  const auto codes = decodeCodes(late);
  ASSERT_TRUE(codes) << codes.error().message;
  EXPECT_THAT(codes->oddities, ::testing::IsEmpty());
  EXPECT_THAT(codes->codes.samples(), ::testing::ElementsAreArray(decodeTexture(plain)->samples()));
  const auto cut = decodeCodes(Bytes(late.begin(), late.end() - 8));
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().message, StartsWith("leaves its height to a DNL segment, which is not there"));
}

TEST(Jpeg, MayBeginBehindOtherBytes) {
  const Bytes plain = testing::withExif(encoded(photograph(24, 16, 3)), {.orientation = 6});
  const Image8 expected = *decodeTexture(plain);
  for (const std::string& before : {std::string("\n"), std::string("\r\n\r\n"), std::string("\xef\xbb\xbf"),
                                    std::string("--frame\r\nContent-Type: image/jpeg\r\n\r\n"), std::string(64, 'x')}) {
    Bytes late = bytesOf(before);
    late.insert(late.end(), plain.begin(), plain.end());
    const auto codes = decodeCodes(late);
    ASSERT_TRUE(codes) << codes.error().message;
    EXPECT_EQ(codes->oddities.size(), 2u);
    EXPECT_THAT(
        codes->oddities,
        ::testing::Contains(::testing::EndsWith(" before its beginning belong to nothing, and are passed over")));
    EXPECT_THAT(codes->codes.samples(), ::testing::ElementsAreArray(expected.samples()));
    EXPECT_EQ(readJpegExif(late).orientation, 6);
    late.insert(late.begin(), 64, 'x');
    EXPECT_FALSE(decodeCodes(late));
  }
  Bytes archive = bytesOf(std::string("PK\x03\x04") + std::string(26, '\0'));
  archive.insert(archive.end(), plain.begin(), plain.end());
  EXPECT_THAT(decodeCodes(archive).error().message, StartsWith("is a zip archive"));
}

/// A small picture whose frame header says another size.
Bytes jpegWithSize(int width, int height) {
  Bytes bytes = encoded(photograph(16, 16, 3));
  const std::size_t at = frameHeader(bytes) + 5;
  bytes[at] = static_cast<std::uint8_t>(height >> 8);
  bytes[at + 1] = static_cast<std::uint8_t>(height);
  bytes[at + 2] = static_cast<std::uint8_t>(width >> 8);
  bytes[at + 3] = static_cast<std::uint8_t>(width);
  return bytes;
}

TEST(Jpeg, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  const auto error = [](int width, int height) { return decodeJpeg(jpegWithSize(width, height)).error(); };
  EXPECT_EQ(error(0, 16).code, ErrorCode::bad_file);
  EXPECT_EQ(error(65500, 65500).code, ErrorCode::too_large);
  EXPECT_THAT(error(30000, 30000).message, HasSubstr("cannot hold"));
  EXPECT_THAT(error(64, 16).message, HasSubstr("damaged JPEG, at byte "));
}

// A file long enough for what it says, which only decoding shows to be a lie.
// In a suite of its own, since a process tells only the most memory that it ever had.
TEST(JpegMemory, AnEarlyEndCostsNoMoreThanItsTexels) {
  if (testing::isSanitized())
    GTEST_SKIP() << "the address sanitizer takes an eighth of whatever memory is asked for, used or not";
  const auto peak_kb = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  Bytes bytes = jpegWithSize(30000, 30000);
  bytes.resize(150000);
  const long before = peak_kb();
  EXPECT_THAT(decodeJpeg(bytes).error().message, HasSubstr("damaged JPEG"));
  EXPECT_LT(peak_kb() - before, 200000) << "the picture would have 2.7 GB";
}

TEST(Jpeg, ATooLargeSideIsRefusedOnWriting) {
  const auto result = encodeJpeg(Image8(65501, 1, 3), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::bad_shape);
}

using testing::Damage;

INSTANTIATE_TEST_SUITE_P(
    Jpeg, Damage,
    ::testing::Values(
        testing::inPart("Jpeg",
                        [] {
                          return *encodeJpeg(pictureFromLinear(testing::gradient(13, 11, 3), 3), {{"envmap", "cube"}});
                        })),
    testing::nameOfDamaged);

using testing::CodecFormat;

INSTANTIATE_TEST_SUITE_P(Jpeg, CodecFormat,
                         ::testing::Values(testing::WrittenFormat{"a.JPG", 0.01f, false},
                                           testing::WrittenFormat{"a.jpeg", 0.01f, false}));

}  // namespace
}  // namespace mirrorball
