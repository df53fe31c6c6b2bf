/// JPEGs that libjpeg warns of: what other programs write a little wrongly, and what ends early or is damaged.

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/coded_file.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/ldr/jpeg_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::JpegForm;

constexpr int kWidth = 40, kHeight = 60;

/// Smooth, and nowhere black.
Image8 smooth(int channels) {
  Image8 picture(kWidth, kHeight, channels);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < channels; ++c)
        picture.texel(x, y)[c] = static_cast<std::uint8_t>(150.0 + 90.0 * std::sin(0.3 * x + 0.21 * y + c));
  return picture;
}

Bytes jpegFile(const JpegForm& form) { return testing::jpegFile(smooth(form.channels), form); }

/// Where the data of the first scan begin.
std::size_t firstScan(const Bytes& bytes) {
  constexpr std::array<std::uint8_t, 2> kStartOfScan{0xff, 0xda};
  const auto marker = std::search(bytes.begin(), bytes.end(), kStartOfScan.begin(), kStartOfScan.end());
  return static_cast<std::size_t>(marker - bytes.begin()) + 2 + std::size_t{marker[3]};
}

Image8 codesIn(const Result<CodedFile>& file) {
  EXPECT_TRUE(file) << file.error().message;
  return file ? std::get<Image8>(file->codes) : Image8(1, 1, 3);
}

bool isBlack(std::span<const std::uint8_t> row) {
  return std::all_of(row.begin(), row.end(), [](std::uint8_t code) { return code == 0; });
}

/// Each row is the whole file's or black.
///
/// returns  how many are black
int blackRows(const Image8& picture, const Image8& whole) {
  int black = 0;
  for (int y = 0; y < whole.height(); ++y) {
    if (isBlack(picture.row(y)))
      ++black;
    else
      EXPECT_THAT(picture.row(y), ::testing::ElementsAreArray(whole.row(y))) << "row " << y;
  }
  return black;
}

TEST(JpegOddity, PhonesEndTheBandOfABaselineScanAtZero) {
  Bytes bytes = jpegFile({});
  const auto whole = decodeJpegCodes(bytes);
  EXPECT_THAT(whole->oddities, IsEmpty());
  bytes[firstScan(bytes) - 2] = 0;
  const auto read = decodeJpegCodes(bytes);
  EXPECT_EQ(blackRows(codesIn(read), codesIn(whole)), 0);
  EXPECT_THAT(read->oddities, ElementsAre("its scan says that it ends at frequency 0 of 63, as phones of Samsung write "
                                          "it: read with all"));
}

TEST(JpegOddity, TheEndMarkerMayBeMissing) {
  for (const bool progressive : {false, true}) {
    Bytes bytes = jpegFile({.progressive = progressive});
    const auto whole = decodeJpegCodes(bytes);
    bytes.resize(bytes.size() - 2);
    const auto read = decodeJpegCodes(bytes);
    EXPECT_EQ(blackRows(codesIn(read), codesIn(whole)), 0);
    EXPECT_THAT(read->oddities, ElementsAre("lacks its end marker; all of its rows are there"));
  }
}

TEST(JpegOddity, WhatLiesBehindTheEndMarkerIsNone) {
  Bytes bytes = jpegFile({});
  for (const char letter : std::string_view("Image_UTC_DataSEFH\xff\xd8SEFT")) bytes.push_back(std::uint8_t(letter));
  EXPECT_THAT(decodeJpegCodes(bytes)->oddities, IsEmpty());
}

TEST(JpegOddity, BytesBetweenSegmentsArePassedOver) {
  Bytes bytes = jpegFile({});
  const auto whole = decodeJpegCodes(bytes);
  bytes.insert(bytes.end() - 2, 50, 7);  // more than libjpeg reads ahead, which it forgets
  const auto read = decodeJpegCodes(bytes);
  EXPECT_EQ(blackRows(codesIn(read), codesIn(whole)), 0);
  EXPECT_THAT(read->oddities, ElementsAre(HasSubstr("between its segments belong to nothing, and are passed over")));
}

class JpegEnd : public ::testing::TestWithParam<JpegForm> {};

// No row is libjpeg's grey, and the remark counts those that are black.
TEST_P(JpegEnd, AsFarAsItGoes) {
  const Bytes bytes = jpegFile(GetParam());
  const Image8 whole = codesIn(decodeJpegCodes(bytes));
  int most = 0;
  for (std::size_t size = firstScan(bytes); size + 2 < bytes.size(); ++size) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const auto read = decodeJpegCodes(part);
    if (!read) {
      EXPECT_EQ(most, 0) << "refused only as long as no row is there";
      EXPECT_THAT(read.error().message, HasSubstr("is a damaged JPEG, at byte "));
      continue;
    }
    const int black = blackRows(codesIn(read), whole);
    EXPECT_LE(kHeight - most, kHeight);
    EXPECT_GE(kHeight - black, most) << "more bytes, more rows";
    most = kHeight - black;
    const std::string count = std::to_string(black);
    if (black == 0)
      EXPECT_THAT(read->oddities, ElementsAre("lacks its end marker; all of its rows are there"));
    else
      EXPECT_THAT(read->oddities, ElementsAre(black == 1 ? "ends before its last row: the row that is missing is black"
                                                         : "ends before its last row: the " + count +
                                                               " rows that are missing are black"));
  }
  EXPECT_GT(most, kHeight / 2);
}

INSTANTIATE_TEST_SUITE_P(Forms, JpegEnd,
                         ::testing::Values(JpegForm{}, JpegForm{.name = "Grey", .channels = 1},
                                           JpegForm{.name = "Subsampled", .subsampling = 2},
                                           JpegForm{.name = "GreyOfTwo", .channels = 1, .subsampling = 2},
                                           JpegForm{.name = "RestartEachRow", .interval = 5},
                                           JpegForm{.name = "RestartAnywhere", .interval = 3},
                                           JpegForm{.name = "RestartSubsampled", .subsampling = 2, .interval = 4}),
                         [](const auto& form) { return std::string(form.param.name); });

// Of a progressive file the first scan brings rows, and each later one sharpens them.
TEST(JpegOddity, AProgressiveFileThatEndsEarlyIsCoarser) {
  const Bytes bytes = jpegFile({.progressive = true});
  const Image8 whole = codesIn(decodeJpegCodes(bytes));
  bool was_coarse = false;
  for (std::size_t size = firstScan(bytes); size + 2 < bytes.size(); ++size) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const auto read = decodeJpegCodes(part);
    if (!read) {
      EXPECT_FALSE(was_coarse) << size << " of " << bytes.size() << ": " << read.error().message;
      continue;
    }
    ASSERT_EQ(read->oddities.size(), 1u) << size;
    const bool is_whole = read->oddities.front() == "lacks its end marker; all of its rows are there";
    if (is_whole) EXPECT_EQ(blackRows(codesIn(read), whole), 0) << size;
    was_coarse = was_coarse || !is_whole;
    // Never grey where nothing came: blocks have their means from the first scan on.
    const Image8 picture = codesIn(read);
    double difference = 0;
    for (int y = 0; y < kHeight; ++y)
      if (!isBlack(picture.row(y)))
        for (std::size_t i = 0; i < 3 * kWidth; ++i) difference += picture.row(y)[i] - whole.row(y)[i];
    ASSERT_LT(std::abs(difference) / (3.0 * kWidth * kHeight), 3.0) << size;
  }
  EXPECT_TRUE(was_coarse);
}

// A colour of which no scan came would be grey in libjpeg's picture.
TEST(JpegOddity, AFileWithoutOneOfItsColoursIsRefused) {
  const Bytes bytes = jpegFile({.scans = {{1, {0}, 0, 63, 0, 0}, {1, {1}, 0, 63, 0, 0}, {1, {2}, 0, 63, 0, 0}}});
  ASSERT_TRUE(decodeJpegCodes(bytes));
  constexpr std::array<std::uint8_t, 2> kStartOfScan{0xff, 0xda};
  const auto last = std::find_end(bytes.begin(), bytes.end(), kStartOfScan.begin(), kStartOfScan.end());
  Bytes two(bytes.begin(), last);
  two.insert(two.end(), {0xff, 0xd9});
  EXPECT_EQ(decodeJpegCodes(two).error().code, ErrorCode::bad_file);
}

TEST(JpegOddity, DamageReachesToTheNextRestart) {
  const Bytes bytes = jpegFile({.interval = 5});
  const Image8 whole = codesIn(decodeJpegCodes(bytes));
  // The third row of blocks loses its data: its restart marker is followed by the next one.
  const auto restart = [&](std::uint8_t number) {
    const std::array<std::uint8_t, 2> marker{0xff, static_cast<std::uint8_t>(0xd0 + number)};
    return std::search(bytes.begin(), bytes.end(), marker.begin(), marker.end());
  };
  Bytes damaged(bytes.begin(), restart(1) + 2);
  damaged.insert(damaged.end(), restart(2), bytes.end());
  const auto read = decodeJpegCodes(damaged);
  const Image8 picture = codesIn(read);
  EXPECT_EQ(blackRows(picture, whole), 8);
  EXPECT_TRUE(isBlack(picture.row(16)) && isBlack(picture.row(23)));
  EXPECT_THAT(read->oddities, ElementsAre(HasSubstr("is damaged from row 16 on")));
}

TEST(JpegOddity, IsReportedOfLightTexturesNumbersAndCodes) {
  Bytes bytes = jpegFile({});
  bytes.resize(bytes.size() * 3 / 4);
  const auto ends = ElementsAre(HasSubstr("ends before its last row: the "));
  const auto light = decodeImage(bytes);
  ASSERT_TRUE(light);
  EXPECT_THAT(light->oddities, ends);
  EXPECT_EQ(light->image.texel(3, kHeight - 1)[1], 0.0f);
  const auto colors = decodeColorTexture(bytes);
  EXPECT_THAT(colors->oddities, ends);
  EXPECT_THAT(std::get<Image8>(colors->picture).row(kHeight - 1).first(4), ElementsAre(0, 0, 0, 255));
  EXPECT_THAT(decodeDataTexture(bytes)->oddities, ends);
  EXPECT_THAT(decodeNumbers(bytes)->oddities, ends);
  EXPECT_THAT(decodeCodes(bytes)->oddities, ends);
}

}  // namespace
}  // namespace mirrorball
