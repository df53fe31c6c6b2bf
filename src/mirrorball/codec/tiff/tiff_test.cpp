#include "mirrorball/codec/tiff/tiff.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/early_end_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/coded_picture.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/image/small_float.h"

namespace mirrorball {
namespace {

using testing::bytesOfNumbers;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using testing::tiffFile;
using testing::tiffFloats;
using testing::TiffForm;
using testing::tiffSamples;

DecodedImage decoded(const Bytes& bytes) {
  auto result = decodeTiff(bytes);
  EXPECT_TRUE(result) << result.error().message;
  return result ? std::move(*result) : DecodedImage{};
}

Image8 texture(const Bytes& bytes) {
  auto result = decodeTexture(bytes);
  EXPECT_TRUE(result) << result.error().message;
  return result ? std::move(*result) : Image8();
}

Error refused(const Bytes& bytes) {
  const auto result = decodeTiff(bytes);
  EXPECT_FALSE(result);
  if (result) return {};
  EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
  return result.error();
}

/// The light of one grey code.
float lightOfCode(std::uint16_t code) {
  ImageOf<std::uint16_t> codes(1, 1, 1, code);
  return lightOf(CodedPicture(codes)).samples()[0];
}

class TiffStorage : public ::testing::TestWithParam<std::tuple<int, int, bool, std::string>> {
 protected:
  TiffForm form() const {
    const auto [compression, tile, is_by_planes, mode] = GetParam();
    return {.width = 21,
            .height = 19,
            .compression = static_cast<std::uint16_t>(compression),
            .tile = static_cast<std::uint32_t>(tile),
            .rows_per_strip = 5,
            .is_by_planes = is_by_planes,
            .mode = mode};
  }
};

TEST_P(TiffStorage, IntegersComeBack) {
  TiffForm form = this->form();
  const Bytes samples = tiffSamples(form);
  const Image8 rgba = texture(tiffFile(form, samples));
  ASSERT_EQ(rgba.texelCount(), 21u * 19u);
  for (std::size_t i = 0; i < rgba.samples().size(); ++i)
    ASSERT_EQ(rgba.samples()[i], i % 4 == 3 ? 255 : samples[i / 4 * 3 + i % 4]) << i;

  form.bits = 16;
  std::vector<std::uint16_t> codes(std::size_t{21} * 19 * 3);
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint16_t>(i * 12345);
  const DecodedImage image = decoded(tiffFile(form, bytesOfNumbers(codes)));
  ASSERT_EQ(image.image.channels(), 3);
  for (std::size_t i = 0; i < codes.size(); ++i) ASSERT_EQ(image.image.samples()[i], lightOfCode(codes[i])) << i;
  EXPECT_EQ(image.color, "sRGB");
}

TEST_P(TiffStorage, FloatsComeBack) {
  TiffForm form = this->form();
  form.kind = SAMPLEFORMAT_IEEEFP;
  form.bits = 32;
  const std::vector<float> floats = tiffFloats(form);
  const DecodedImage image = decoded(tiffFile(form, bytesOfNumbers(floats)));
  EXPECT_THAT(image.image.samples(), ElementsAreArray(floats));
  EXPECT_EQ(image.color, "linear, Rec.709");

  form.bits = 16;
  std::vector<std::uint16_t> halves;
  for (const float value : floats) halves.push_back(halfFromFloat(value));
  EXPECT_THAT(decoded(tiffFile(form, bytesOfNumbers(halves))).image.samples(), ElementsAreArray(floats));
  form.bits = 64;
  EXPECT_THAT(
      decoded(tiffFile(form, bytesOfNumbers(std::vector<double>(floats.begin(), floats.end())))).image.samples(),
      ElementsAreArray(floats));
}

INSTANTIATE_TEST_SUITE_P(Forms, TiffStorage,
                         ::testing::Combine(::testing::Values(COMPRESSION_NONE, COMPRESSION_LZW,
                                                              COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS,
                                                              COMPRESSION_ZSTD),
                                            ::testing::Values(0, 16), ::testing::Bool(),
                                            ::testing::Values("w", "wb", "w8")));

TEST(Tiff, PredictorsAreUndone) {
  TiffForm form{.bits = 16, .compression = COMPRESSION_LZW, .predictor = PREDICTOR_HORIZONTAL};
  const std::vector<std::uint16_t> codes(45, 20000);
  EXPECT_EQ(decoded(tiffFile(form, bytesOfNumbers(codes))).image.samples()[44], lightOfCode(20000));
  form = {.bits = 32,
          .kind = SAMPLEFORMAT_IEEEFP,
          .compression = COMPRESSION_ADOBE_DEFLATE,
          .predictor = PREDICTOR_FLOATINGPOINT};
  const std::vector<float> floats = tiffFloats(form);
  EXPECT_THAT(decoded(tiffFile(form, bytesOfNumbers(floats))).image.samples(), ElementsAreArray(floats));
}

TEST(Tiff, OddBitsAreSharesOfTheirRange) {
  const auto codes = [](TiffForm form, const Bytes& row) {
    form.width = 4;
    form.height = form.samples = 1;
    std::vector<int> reds;
    const Image8 rgba = texture(tiffFile(form, row));
    for (int x = 0; x < 4; ++x) reds.push_back(rgba.texel(x, 0)[0]);
    return reds;
  };
  EXPECT_THAT(codes({.bits = 1, .photometric = PHOTOMETRIC_MINISBLACK}, {0xa0}), ElementsAre(255, 0, 255, 0));
  EXPECT_THAT(codes({.bits = 1, .photometric = PHOTOMETRIC_MINISWHITE}, {0xa0}), ElementsAre(0, 255, 0, 255));
  EXPECT_THAT(codes({.bits = 2, .photometric = PHOTOMETRIC_MINISBLACK}, {0x1b}), ElementsAre(0, 85, 170, 255));
  EXPECT_THAT(codes({.bits = 4, .photometric = PHOTOMETRIC_MINISWHITE}, {0x1f, 0x08}), ElementsAre(238, 0, 255, 119));
  // 12 bits: 0, 1024, 2048, 4095.
  EXPECT_THAT(codes({.bits = 12, .photometric = PHOTOMETRIC_MINISBLACK}, {0, 4, 0, 0x80, 0x0f, 0xff}),
              ElementsAre(0, 64, 128, 255));
}

TEST(Tiff, GreyStaysOneChannelAndWhiteMayBeZero) {
  TiffForm form{.width = 1, .height = 1, .samples = 1, .bits = 16, .photometric = PHOTOMETRIC_MINISWHITE};
  const DecodedImage image = decoded(tiffFile(form, bytesOfNumbers(std::vector<std::uint16_t>{65535 - 1000})));
  EXPECT_EQ(image.image.channels(), 1);
  EXPECT_EQ(image.image.samples()[0], lightOfCode(1000));
  EXPECT_EQ(image.format, "TIFF, 16 bit");
  form.bits = 32;
  EXPECT_EQ(decoded(tiffFile(form, bytesOfNumbers(std::vector<std::uint32_t>{0}))).image.samples()[0], 1.0f);
  form.kind = SAMPLEFORMAT_IEEEFP;
  EXPECT_EQ(refused(tiffFile(form, bytesOfNumbers(std::vector<float>{0}))).code, ErrorCode::unsupported);
}

TEST(Tiff, PalettesAreLookedUp) {
  TiffForm form{.width = 2, .height = 1, .samples = 1, .bits = 4, .photometric = PHOTOMETRIC_PALETTE};
  form.palette.resize(48);
  form.palette[2] = 65535;
  form.palette[16 + 2] = 257;
  form.palette[32 + 2] = 514;
  EXPECT_THAT(texture(tiffFile(form, {0x20})).samples(), ElementsAre(255, 1, 2, 255, 0, 0, 0, 255));
  EXPECT_EQ(decoded(tiffFile(form, {0x20})).format, "TIFF, 4 bit palette");
  // Some writers fill it with 8 bits.
  form.palette[2] = 255;
  form.palette[16 + 2] = 1;
  form.palette[32 + 2] = 2;
  EXPECT_THAT(texture(tiffFile(form, {0x20})).samples(), ElementsAre(255, 1, 2, 255, 0, 0, 0, 255));
}

TEST(Tiff, AlphaIsStraightWithIntegersAndPremultipliedWithFloats) {
  TiffForm form{.width = 1, .height = 1, .samples = 4, .extras = {EXTRASAMPLE_UNASSALPHA}};
  EXPECT_THAT(texture(tiffFile(form, {100, 50, 25, 128})).samples(), ElementsAre(100, 50, 25, 128));
  form.extras = {EXTRASAMPLE_ASSOCALPHA};
  EXPECT_THAT(texture(tiffFile(form, {100, 50, 25, 128})).samples(), ElementsAre(199, 100, 50, 128));
  form.extras = {EXTRASAMPLE_UNSPECIFIED};
  EXPECT_EQ(decoded(tiffFile(form, {100, 50, 25, 128})).image.channels(), 3);

  form.bits = 32;
  form.kind = SAMPLEFORMAT_IEEEFP;
  form.extras = {EXTRASAMPLE_UNASSALPHA};
  const Bytes floats = bytesOfNumbers(std::vector<float>{4, 2, 1, 0.5f});
  EXPECT_THAT(decoded(tiffFile(form, floats)).image.samples(), ElementsAre(2, 1, 0.5f, 0.5f));
  form.extras = {EXTRASAMPLE_ASSOCALPHA};
  EXPECT_THAT(decoded(tiffFile(form, floats)).image.samples(), ElementsAre(4, 2, 1, 0.5f));

  // Grey with alpha becomes RGBA, whatever stands between the two.
  form = {.width = 1,
          .height = 1,
          .samples = 3,
          .photometric = PHOTOMETRIC_MINISBLACK,
          .extras = {EXTRASAMPLE_UNSPECIFIED, EXTRASAMPLE_UNASSALPHA}};
  EXPECT_THAT(texture(tiffFile(form, {9, 1, 77})).samples(), ElementsAre(9, 9, 9, 77));
  form.is_by_planes = true;
  EXPECT_THAT(texture(tiffFile(form, {9, 1, 77})).samples(), ElementsAre(9, 9, 9, 77));
}

TEST(Tiff, ThePictureIsTurnedAsItsTagSays) {
  TiffForm form{.width = 2, .height = 1, .samples = 1, .photometric = PHOTOMETRIC_MINISBLACK};
  form.orientation = ORIENTATION_RIGHTTOP;  // stored row 0 is the right side
  const DecodedImage image = decoded(tiffFile(form, {10, 200}));
  ASSERT_EQ(image.image.width(), 1);
  ASSERT_EQ(image.image.height(), 2);
  EXPECT_LT(image.image.texel(0, 0)[0], image.image.texel(0, 1)[0]);
  EXPECT_THAT(image.oddities, ElementsAre(HasSubstr("turned upright, as its tag says (orientation ")));
  form.orientation = ORIENTATION_BOTRIGHT;
  EXPECT_GT(decoded(tiffFile(form, {10, 200})).image.texel(0, 0)[0], 0.5f);
}

TEST(Tiff, AProfileIsNamedAndPrimariesAreConverted) {
  TiffForm form{.width = 1, .height = 1, .profile = testing::iccProfile("Adobe RGB (1998)")};
  EXPECT_EQ(decoded(tiffFile(form, {255, 0, 0})).color,
            "sRGB assumed: its ICC profile (Adobe RGB (1998)) is not applied");
  form.bits = 32;
  form.kind = SAMPLEFORMAT_IEEEFP;
  const Bytes red = bytesOfNumbers(std::vector<float>{1, 0, 0});
  EXPECT_EQ(decoded(tiffFile(form, red)).color,
            "linear, Rec.709 assumed: its ICC profile (Adobe RGB (1998)) is not applied");
  form.profile = testing::iccDisplayP3();
  const DecodedImage light = decoded(tiffFile(form, red));
  EXPECT_EQ(light.color, "linear, primaries of the file (Display P3): converted");
  EXPECT_NEAR(light.image.samples()[0], 1.2249f, 1e-3f);
  EXPECT_THAT(light.oddities, ElementsAre(HasSubstr("with a curve: taken as linear light")));
  const DecodedImage green = decoded(tiffFile({.width = 1, .height = 1, .profile = form.profile}, {0, 255, 0}));
  EXPECT_EQ(green.color, "sRGB, primaries of the file (Display P3): converted");
  EXPECT_NEAR(green.image.samples()[0], -0.2249f, 1e-3f);
  form.profile.clear();
  form.primaries = {0.3127f, 0.329f, 0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f};
  const DecodedImage wide = decoded(tiffFile(form, red));
  EXPECT_EQ(wide.color, "linear, primaries of the file (Rec.2020): converted");
  // ITU-R BT.2087: red of BT.2020 in BT.709.
  EXPECT_NEAR(wide.image.samples()[0], 1.6605f, 2e-3f);
  EXPECT_NEAR(wide.image.samples()[1], -0.1246f, 2e-3f);
}

TEST(Tiff, LogLuvIsLight) {
  for (const int compression : {COMPRESSION_SGILOG, COMPRESSION_SGILOG24}) {
    const TiffForm form{.bits = 32,
                        .kind = SAMPLEFORMAT_IEEEFP,
                        .photometric = PHOTOMETRIC_LOGLUV,
                        .compression = static_cast<std::uint16_t>(compression)};
    const float share = compression == COMPRESSION_SGILOG ? 0.02f : 0.06f;      // steps of 1.1 %, and of u', v'
    const float bright = compression == COMPRESSION_SGILOG ? 20000.0f : 12.0f;  // 24 bits end at 16
    std::vector<float> xyz(45, 0.25f);
    for (int i = 0; i < 3; ++i) xyz[std::size_t(i)] = bright;
    const DecodedImage image = decoded(tiffFile(form, bytesOfNumbers(xyz)));
    for (std::size_t i = 0; i < 45; ++i) {
      const float expected = i < 3 ? bright : 0.25f;
      ASSERT_NEAR(image.image.samples()[i], expected, share * expected) << i;
    }
    EXPECT_EQ(image.color, "CIE XYZ: converted");
  }
  const TiffForm grey{.samples = 1,
                      .bits = 32,
                      .kind = SAMPLEFORMAT_IEEEFP,
                      .photometric = PHOTOMETRIC_LOGL,
                      .compression = COMPRESSION_SGILOG};
  const std::vector<float> floats = tiffFloats(grey);
  const DecodedImage image = decoded(tiffFile(grey, bytesOfNumbers(floats)));
  EXPECT_EQ(image.format, "TIFF, LogL, RLE");
  for (std::size_t i = 0; i < floats.size(); ++i)
    ASSERT_NEAR(image.image.samples()[i], floats[i], 0.003f * floats[i]);  // steps of 2^(1/256)
}

TEST(Tiff, JpegInsideIsReadAndItsEarlyEndIsAnError) {
  TiffForm form{.width = 32, .height = 32, .compression = COMPRESSION_JPEG, .rows_per_strip = 32};
  Bytes samples(32 * 32 * 3);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<std::uint8_t>(100 + i / 96);
  const Bytes bytes = tiffFile(form, samples);
  const Image8 rgba = texture(bytes);
  for (int y = 0; y < 32; ++y) ASSERT_NEAR(rgba.texel(7, y)[1], 100 + y, 3);

  // The data's second half is lost behind an early end.
  form.width = form.height = 16;
  form.rows_per_strip = 16;
  Bytes cut = tiffFile(form, tiffSamples(form));
  ASSERT_TRUE(decodeTiff(cut));
  const std::array<std::uint8_t, 2> end{0xff, 0xd9};
  const auto at = std::search(cut.begin(), cut.end(), end.begin(), end.end());
  std::copy(end.begin(), end.end(), at - (at - cut.begin()) / 3);
  EXPECT_THAT(refused(cut).message, HasSubstr("damaged or truncated"));
}

using testing::CutFile;
using testing::EarlyEnd;
using testing::tiffWithPageFirst;

INSTANTIATE_TEST_SUITE_P(
    Tiff, EarlyEnd,
    ::testing::Values(CutFile{"TiffOneStrip", [] { return tiffWithPageFirst({}); }},
                      CutFile{"TiffBigEndian", [] { return tiffWithPageFirst({.is_big_endian = true}); }},
                      CutFile{"TiffStrips", [] { return tiffWithPageFirst({.height = 7, .rows = 2}); }},
                      CutFile{"TiffPacked",
                              [] { return tiffWithPageFirst({.height = 7, .rows = 2, .is_packed = true}); }, true,
                              false, 2},
                      CutFile{"TiffTiles", [] { return tiffWithPageFirst({.width = 32, .height = 48, .tile = 16}); },
                              true, false, 16}),
    testing::nameOfCut);

// Programs that write strips as they are done leave the others without bytes.
TEST(Tiff, StripsBetweenOthersMayBeMissing) {
  Bytes file = tiffWithPageFirst({.height = 7, .rows = 2});
  constexpr std::size_t kSizes = 8 + 2 + 12 * 10 + 4 + 4 * 4;
  file[kSizes + 4] = 0;  // of the second
  const DecodedImage image = decoded(file);
  EXPECT_THAT(image.oddities, ElementsAre("was not written to its end: the 2 rows that are missing are black"));
  for (int y = 0; y < 7; ++y)
    EXPECT_EQ(image.image.texel(2, y)[0], y / 2 == 1 ? 0.0f : lightOfCode(std::uint16_t(257 * (1 + y * 5 + 2))));
  for (std::size_t strip = 0; strip < 4; ++strip) file[kSizes + 4 * strip] = 0;
  EXPECT_EQ(refused(file).code, ErrorCode::bad_file);
}

// libtiff writes it last, and without it nothing is known of the rows.
TEST(Tiff, AFileThatEndsBeforeItsDirectorySaysSo) {
  for (const char* mode : {"wl", "wb", "wl8", "wb8"}) {
    TiffForm form{.rows_per_strip = 1};
    form.mode = mode;
    const bool is_big_tiff = form.mode.size() == 3;
    const std::size_t header = is_big_tiff ? 16 : 8, directory = header + 45 + 1;
    Bytes bytes = tiffFile(form, tiffSamples(form));
    for (std::size_t length = 16; length < bytes.size(); ++length) {
      const std::string message = refused(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(length))).message;
      const std::string where = (length > directory ? ", within" : ", before") + std::string(" its directory at byte ");
      ASSERT_EQ(message, "ends at byte " + std::to_string(length) + where + std::to_string(directory) +
                             ", which says how large it is and where its rows are; copy or save it again")
          << mode;
    }
    // As libtiff leaves it until it closes the file.
    std::fill_n(bytes.begin() + std::ptrdiff_t(header / 2), header / 2, std::uint8_t{0});
    EXPECT_THAT(refused(bytes).message, HasSubstr("has no directory")) << mode;
    EXPECT_THAT(refused(bytes).message, HasSubstr("save it again")) << mode;
  }
}

TEST(Tiff, ThePictureBehindAPreviewIsRead) {
  const TiffForm preview{.width = 1, .height = 1, .subfile = FILETYPE_REDUCEDIMAGE};
  const TiffForm form;
  EXPECT_EQ(decoded(tiffFile({{preview, {1, 2, 3}}, {form, tiffSamples(form)}})).image.width(), 5);
  EXPECT_EQ(decoded(tiffFile({{form, tiffSamples(form)}, {preview, {1, 2, 3}}})).image.width(), 5);
  EXPECT_THAT(refused(tiffFile({{preview, {1, 2, 3}}})).message, HasSubstr("nothing but a preview"));
}

TEST(Tiff, WhatCannotBeReadIsNamed) {
  TiffForm form{.samples = 4, .photometric = PHOTOMETRIC_SEPARATED};
  EXPECT_THAT(refused(tiffFile(form, tiffSamples(form))).message, HasSubstr("CMYK"));
  form = {.photometric = PHOTOMETRIC_CIELAB};
  EXPECT_THAT(refused(tiffFile(form, tiffSamples(form))).message, HasSubstr("L*a*b*"));
  form = {.samples = 1, .photometric = PHOTOMETRIC_CFA};
  EXPECT_THAT(refused(tiffFile(form, tiffSamples(form))).message, HasSubstr("raw picture"));
  form = {.is_dng = true};
  EXPECT_THAT(refused(tiffFile(form, tiffSamples(form))).message, HasSubstr("raw picture"));
  form = {.bits = 16, .kind = SAMPLEFORMAT_INT};
  EXPECT_EQ(refused(tiffFile(form, tiffSamples(form))).code, ErrorCode::unsupported);
  form = {.compression = COMPRESSION_LZMA};
  EXPECT_THAT(refused(tiffFile(form, tiffSamples(form))).message, HasSubstr("compression 34925"));
  form = {.bits = 32, .kind = SAMPLEFORMAT_IEEEFP};
  const Bytes floats = tiffFile(form, bytesOfNumbers(tiffFloats(form)));
  EXPECT_THAT(decodeTexture(floats).error().message, HasSubstr("save it with 8 or 16 bits"));
  EXPECT_FALSE(isTiffOfIntegers(floats));
  EXPECT_TRUE(isTiffOfIntegers(tiffFile({}, tiffSamples({}))));
}

TEST(Tiff, NothingIsPrinted) {
  TiffForm form{.compression = COMPRESSION_LZW};
  const Bytes bytes = tiffFile(form, tiffSamples(form));
  ::testing::internal::CaptureStderr();
  for (std::size_t i = 4; i < bytes.size(); ++i) {
    Bytes damaged = bytes;
    damaged[i] ^= 0xff;
    static_cast<void>(decodeTiff(damaged).has_value());
    const Bytes cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(i));
    EXPECT_FALSE(decodeTiff(cut)) << i;
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Tiff, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  // Written with the size that it says, of one strip that deflate makes small; then most of it is taken away.
  TiffForm form{.width = 2000, .height = 2000, .compression = COMPRESSION_ADOBE_DEFLATE, .rows_per_strip = 2000};
  const Bytes bytes = tiffFile(form, Bytes(std::size_t{2000} * 2000 * 3));
  EXPECT_EQ(decoded(bytes).image.width(), 2000);
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(std::uint64_t{50} << 20);
  EXPECT_EQ(refused(bytes).code, ErrorCode::too_large);
  setMemoryLimit(before);
  form.compression = COMPRESSION_NONE;
  form.width = form.height = 1;
  Bytes lie = tiffFile(form, {1, 2, 3});
  // The directory's entries: tag, type, count, value. 256 and 257 are the sides.
  for (std::size_t i = 0; i + 12 <= lie.size(); ++i)
    if ((lie[i] == 0 || lie[i] == 1) && lie[i + 1] == 1 && lie[i + 2] == 3 && lie[i + 4] == 1) lie[i + 9] = 0x40;
  EXPECT_THAT(refused(lie).message, HasSubstr("cannot hold"));
}

TEST(Tiff, DecodingCanBeInterrupted) {
  const Bytes bytes = tiffFile({}, tiffSamples({}));
  std::size_t asked = 0;
  const auto stop = [&](std::size_t, std::size_t) { return ++asked < 2; };
  const auto result = decodeTiff(bytes, {.progress = stop});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
