/// Files that end early: what is there is read, and nothing else is shown for it.

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <gmock/gmock.h>

#include "mirrorball/codec/early_end_testing.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/missing_rows.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/codec/row_reader.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using testing::CutFile;
using testing::EarlyEnd;

/// How many rows the one remark on a file calls missing; 0 without a remark.
int missingRows(const std::vector<std::string>& remarks) {
  if (remarks.empty()) return 0;
  EXPECT_EQ(remarks.size(), 1u) << remarks.back();
  int count = 1;
  std::sscanf(remarks[0].c_str(), "ends before its last row: the %d rows", &count);
  EXPECT_EQ(remarks[0], earlyEndText(std::size_t(count)));
  return count;
}

/// Whether a row has the samples of another picture's.
bool isSameRow(const Image& a, const Image& b, int y) {
  return std::equal(a.row(y).begin(), a.row(y).end(), b.row(y).begin(), b.row(y).end());
}

bool isBlackRow(const Image& image, int y) {
  for (int x = 0; x < image.width(); ++x)
    for (int c = 0; c < image.channels(); ++c)
      if (image.texel(x, y)[c] != (c == 3 ? 1.0f : 0.0f)) return false;
  return true;
}

TEST_P(EarlyEnd, IsReadAsFarAsItGoes) {
  const Bytes bytes = GetParam().bytes();
  const auto whole = decodeImage(bytes);
  ASSERT_TRUE(whole) << whole.error().message;
  ASSERT_THAT(whole->oddities, ::testing::IsEmpty());
  const int height = whole->image.height();
  int rows_before = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    // A copy of its own, so that the sanitizer sees a read past its end.
    const auto cut = decodeImage(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)));
    if (!cut) {
      EXPECT_EQ(rows_before, 0) << length << ": " << cut.error().message;
      continue;
    }
    const int rows = height - missingRows(cut->oddities);
    ASSERT_GE(rows, std::max(rows_before, 1)) << length;
    rows_before = rows;
    for (int y = 0; y < height; ++y) {
      const bool is_there = GetParam().from_top ? y < rows : y >= height - rows;
      ASSERT_TRUE(is_there ? isSameRow(cut->image, whole->image, y) : isBlackRow(cut->image, y)) << length << ", " << y;
    }
  }
  EXPECT_GE(rows_before, height - GetParam().rows_together);
}

TEST_P(EarlyEnd, IsReadByRowsAlike) {
  Bytes bytes = GetParam().bytes();
  bytes.resize(bytes.size() * 2 / 3);
  const auto folder = std::filesystem::path(::testing::TempDir());
  const auto path = folder / (std::string("mirrorball_early_end_") + GetParam().name);
  ASSERT_TRUE(writeFile(path, bytes));
  auto rows = openRows(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(rows) << rows.error().message;
  ASSERT_EQ(*rows != nullptr, GetParam().is_by_rows);
  if (!*rows) return;
  const auto whole = decodeImage(bytes);
  ASSERT_TRUE(whole) << whole.error().message;
  ASSERT_TRUE((*rows)->survey());
  EXPECT_EQ((*rows)->description().oddities, whole->oddities);
  for (int first = 0; first < whole->image.height(); ++first) {
    const auto row = (*rows)->read(1);
    ASSERT_TRUE(row) << row.error().message;
    EXPECT_THAT(row->row(0), ::testing::ElementsAreArray(whole->image.row(first))) << first;
  }
  (*rows)->goTo(1);
  EXPECT_THAT((*rows)->read(1)->row(0), ::testing::ElementsAreArray(whole->image.row(1))) << "it goes back";
}

/// Texels of any codes but 0, which would be black.
Bytes noise(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(1 + i * 37 % 250);
  return bytes;
}

Bytes withNoise(const std::string& header, std::size_t count) {
  Bytes bytes = bytesOf(header);
  const Bytes texels = noise(count);
  bytes.insert(bytes.end(), texels.begin(), texels.end());
  return bytes;
}

/// Floats of 0.5 and 2 in turn, little-endian.
Bytes floatMap(const std::string& header, std::size_t samples) {
  Bytes bytes = withNoise(header, 0);
  for (std::size_t i = 0; i < samples; ++i) testing::appendLittle(bytes, i % 2 == 0 ? 0x3f000000u : 0x40000000u, 4);
  return bytes;
}

/// A packet of two equal texels of 24 bits and one of another, for each row of three.
Bytes tgaRuns(int rows) {
  Bytes packets;
  for (int i = 0; i < rows; ++i) packets.insert(packets.end(), {129, 9, 8, 7, 0, 1, 2, 3});
  return packets;
}

/// Flat scan lines, which are shorter than what new RLE may have.
Bytes flatHdr(const std::string& resolution) {
  return withNoise("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n", std::size_t{4} * 5 * 6);
}

INSTANTIATE_TEST_SUITE_P(
    Files, EarlyEnd,
    ::testing::Values(
        CutFile{"Tga", [] { return testing::tgaFile({.width = 3, .height = 5}, noise(45)); }},
        CutFile{"TgaFromBelow", [] { return testing::tgaFile({.width = 3, .height = 5, .descriptor = 0}, noise(45)); },
                false},
        CutFile{"TgaAlpha",
                [] { return testing::tgaFile({.width = 3, .height = 5, .bits = 32, .descriptor = 0x28}, noise(60)); }},
        CutFile{"TgaRuns", [] { return testing::tgaFile({.type = 10, .width = 3, .height = 5}, tgaRuns(5)); }},
        CutFile{"Bmp", [] { return testing::bmpFile({.width = 3, .height = 5}, noise(60)); }, false},
        CutFile{"BmpFromTop", [] { return testing::bmpFile({.width = 3, .height = -5}, noise(60)); }},
        CutFile{"BmpRuns",
                [] {
                  return testing::bmpFile(
                      {.width = 3, .height = 3, .bits = 8, .compression = 1, .palette = {0xff, 0xff00}},
                      {0, 3, 1, 0, 1, 0, 0, 0, 3, 1, 0, 0, 2, 1, 1, 0, 0, 1});
                },
                false},
        CutFile{"Pgm", [] { return withNoise("P5 5 4 255\n", 20); }},
        CutFile{
            "PamAlpha",
            [] { return withNoise("P7\nWIDTH 2\nHEIGHT 4\nDEPTH 4\nMAXVAL 65535\nTUPLTYPE RGB_ALPHA\nENDHDR\n", 64); }},
        CutFile{"PgmText", [] { return withNoise("P2 2 4\n255\n17 180\n201 22 193 24\n15 6", 0); }},
        CutFile{"PbmText", [] { return withNoise("P1 3 4\n010 010 101\n111", 0); }},
        CutFile{"Pfm", [] { return floatMap("PF 3 4 -1\n", 36); }, false},
        CutFile{"PfmGrey", [] { return floatMap("Pf 3 4 -1\n", 12); }, false},
        CutFile{"PfmAlpha", [] { return floatMap("PF4 3 4 -1\n", 48); }, false},
        CutFile{"Hdr", [] { return encodeHdr(testing::gradient(13, 5, 3), {}); }, true, true},
        CutFile{"HdrFlat", [] { return flatHdr("-Y 6 +X 5"); }, true, true},
        CutFile{"HdrFromBelow", [] { return flatHdr("+Y 6 +X 5"); }, false}),
    testing::nameOfCut);

// What is stored one behind the other is not always a row.
TEST(EarlyEnd, OfColumnsCountsColumns) {
  Bytes bytes = flatHdr("+X 6 -Y 5");
  bytes.resize(bytes.size() - 50);
  const auto cut = decodeImage(bytes);
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_THAT(cut->oddities, ::testing::ElementsAre("ends before its last column: the 3 columns that are missing are "
                                                    "black"));
  for (int y = 0; y < 5; ++y) {
    EXPECT_GT(cut->image.texel(2, y)[1], 0.0f);
    EXPECT_EQ(cut->image.texel(3, y)[1], 0.0f);
  }
}

// A header alone, or a size a thousand times that of the file, would only cost memory.
TEST(EarlyEnd, OfNearlyEverythingIsRefused) {
  for (const Bytes& bytes : {testing::tgaFile({.width = 3, .height = 60000}, noise(90)),
                             testing::bmpFile({.width = 3, .height = 60000}, noise(90)),
                             withNoise("P6 3 60000 255\n", 90), floatMap("Pf 3 60000 -1\n", 12)}) {
    const auto refused = decodeImage(bytes);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, ::testing::HasSubstr("cannot hold"));
  }
}

}  // namespace
}  // namespace mirrorball
