#include "mirrorball/codec/exr/exr_missing_rows.h"

#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/early_end_testing.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::CutFile;
using testing::decoded;
using testing::EarlyEnd;
using ::testing::ElementsAre;
using testing::gradient;
using ::testing::HasSubstr;

const std::vector<std::string> kRgbNames{"R", "G", "B"};

Imf::Header exrHeader(int width, int height, Imf::Compression compression, Imf::LineOrder order = Imf::INCREASING_Y) {
  Imf::Header header(width, height);
  header.compression() = compression;
  header.lineOrder() = order;
  return header;
}

INSTANTIATE_TEST_SUITE_P(
    Exr, EarlyEnd,
    ::testing::Values(
        CutFile{"ExrPlain",
                [] { return testing::foreignFile(exrHeader(5, 6, Imf::NO_COMPRESSION), gradient(5, 6, 3), kRgbNames); },
                true, true},
        CutFile{"ExrAlpha", [] { return *encodeExr(gradient(9, 40, 4), {}); }, true, true, 16},
        CutFile{
            "ExrPiz",
            [] { return testing::foreignFile(exrHeader(5, 70, Imf::PIZ_COMPRESSION), gradient(5, 70, 3), kRgbNames); },
            true, true, 32},
        CutFile{"ExrFromBelow",
                [] {
                  return testing::foreignFile(exrHeader(5, 6, Imf::ZIPS_COMPRESSION, Imf::DECREASING_Y),
                                              gradient(5, 6, 3), kRgbNames);
                },
                false, true},
        CutFile{"ExrTiles",
                [] { return testing::tiledFile(Imf::Header(40, 70), gradient(40, 70, 3), kRgbNames, Imf::ONE_LEVEL); },
                true, true, 32},
        CutFile{
            "ExrTilesWithAlpha",
            [] {
              return testing::tiledFile(Imf::Header(8, 70), gradient(8, 70, 4), {"R", "G", "B", "A"}, Imf::ONE_LEVEL);
            },
            true, true, 32}),
    testing::nameOfCut);

/// What a renderer has written when it stops.
///
/// rows          of the picture that it has got to
/// is_killed     whether it stops without writing its table of offsets
Bytes unfinished(const Image& image, int rows, Imf::LineOrder order, bool is_killed) {
  Imf::Header header = exrHeader(image.width(), image.height(), Imf::ZIP_COMPRESSION, order);
  testing::addChannels(header, kRgbNames);
  ExrOutput stream;
  Bytes bytes;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(testing::frameOf(image, kRgbNames, header.dataWindow()));
    file.writePixels(rows);
    if (is_killed) bytes = stream.takeBytes();
  }
  return is_killed ? bytes : stream.takeBytes();
}

void expectBlackBut(const Image& image, const Image& whole, int begin, int end) {
  for (int y = 0; y < whole.height(); ++y)
    for (int x = 0; x < whole.width(); ++x)
      ASSERT_EQ(image.texel(x, y)[1], y >= begin && y < end ? whole.texel(x, y)[1] : 0.0f) << x << ", " << y;
}

TEST(ExrMissingRows, OfARendererThatStoppedAreBlack) {
  const Image image = gradient(7, 60, 3);
  for (const bool is_killed : {false, true}) {
    const DecodedImage upper = decoded(unfinished(image, 40, Imf::INCREASING_Y, is_killed));
    EXPECT_THAT(upper.oddities, ElementsAre("ends before its last row: the 28 rows that are missing are black"));
    expectBlackBut(upper.image, image, 0, 32);
    // From below the first chunk has the twelve rows that do not fill one.
    const DecodedImage lower = decoded(unfinished(image, 40, Imf::DECREASING_Y, is_killed));
    EXPECT_THAT(lower.oddities, ElementsAre("ends before its last row: the 32 rows that are missing are black"));
    expectBlackBut(lower.image, image, 32, 60);
    const auto none = decodeExr(unfinished(image, 10, Imf::INCREASING_Y, is_killed));
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message, HasSubstr("none of its rows is whole; the file was not written to its end"));
  }
}

/// 40 x 96 texels in tiles of 32 x 32, the lowest two first and the ones in the middle last.
///
/// last   how many of these two are written
Bytes tilesInNoOrder(const Image& image, int last) {
  Imf::Header header = exrHeader(40, 96, Imf::ZIP_COMPRESSION, Imf::RANDOM_Y);
  header.setTileDescription(Imf::TileDescription(32, 32, Imf::ONE_LEVEL));
  testing::addChannels(header, kRgbNames);
  ExrOutput stream;
  {
    Imf::TiledOutputFile file(stream, header);
    file.setFrameBuffer(testing::frameOf(image, kRgbNames, header.dataWindow()));
    file.writeTiles(0, 1, 2, 2);
    file.writeTiles(0, 1, 0, 0);
    for (int tile = 0; tile < last; ++tile) file.writeTile(1 - tile, 1);
  }
  return stream.takeBytes();
}

// Renderers of buckets write tiles in the order in which they are done.
TEST(ExrMissingRows, BetweenOthersAreCounted) {
  const Image image = gradient(40, 96, 3);
  Bytes cut = tilesInNoOrder(image, 2);
  EXPECT_EQ(decoded(cut).oddities, std::vector<std::string>{});
  cut.pop_back();
  for (const Bytes& file : {tilesInNoOrder(image, 1), cut}) {
    const DecodedImage read = decoded(file);
    EXPECT_THAT(read.oddities, ElementsAre("was not written to its end: the 32 rows that are missing are black"));
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 40; ++x)
        ASSERT_EQ(read.image.texel(x, y)[1], y / 32 == 1 ? 0.0f : image.texel(x, y)[1]) << x << ", " << y;
  }
}

// As programs leave it that convert tiles to scan lines and keep the other attributes.
TEST(ExrMissingRows, OfScanLinesThatOnceWereTilesAreFound) {
  const Image image = gradient(7, 60, 3);
  for (const Imf::LineOrder order : {Imf::INCREASING_Y, Imf::DECREASING_Y}) {
    Imf::Header header = exrHeader(7, 60, Imf::ZIP_COMPRESSION, order);
    header.setTileDescription(Imf::TileDescription(32, 32, Imf::ONE_LEVEL));
    Bytes bytes = testing::foreignFile(header, image, kRgbNames);
    bytes[5] &= static_cast<std::uint8_t>(~0x02u);  // the flag of tiles, which OpenEXR sets for the attribute
    const DecodedImage whole = decoded(bytes);
    EXPECT_EQ(whole.format, "OpenEXR, float, ZIP");
    EXPECT_EQ(whole.oddities, std::vector<std::string>{});
    testing::expectSameBits(whole.image, image);
    bytes.pop_back();
    const DecodedImage cut = decoded(bytes);
    // From below the last chunk has all its sixteen rows.
    const bool is_from_top = order == Imf::INCREASING_Y;
    EXPECT_THAT(cut.oddities, ElementsAre(HasSubstr(is_from_top ? "the 12 rows" : "the 16 rows")));
    expectBlackBut(cut.image, image, is_from_top ? 0 : 16, is_from_top ? 48 : 60);
  }
}

// Rows that the picture does not show are not missed.
TEST(ExrMissingRows, OutsideTheDisplayWindowAreNotTold) {
  const Image image = gradient(6, 8, 3);
  Imf::Header header(Imath::Box2i({0, 0}, {5, 3}), Imath::Box2i({0, 0}, {5, 7}));
  header.compression() = Imf::NO_COMPRESSION;
  Bytes bytes = testing::foreignFile(header, image, kRgbNames);
  const DecodedImage whole = decoded(bytes);
  bytes.resize(bytes.size() - 100);
  const DecodedImage cut = decoded(bytes);
  EXPECT_EQ(cut.oddities, whole.oddities);
  testing::expectSameBits(cut.image, whole.image);
}

/// A picture 8 texels wide as luminance, chroma and alpha, whose colours change slowly.
Bytes chromaFile(int height, Imf::LineOrder order, Imf::Compression compression) {
  std::vector<Imf::Rgba> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 8; ++x)
      texels.emplace_back(0.5f + 0.005f * float(y), 0.25f + 0.01f * float(x), 0.75f - 0.005f * float(y), 0.5f);
  ExrOutput stream;
  {
    Imf::RgbaOutputFile file(stream, exrHeader(8, height, compression, order), Imf::WRITE_YCA);
    file.setFrameBuffer(texels.data(), 1, 8);
    file.writePixels(height);
  }
  return stream.takeBytes();
}

/// Such a file of 60 rows that is not compressed, without its last rows.
Bytes cutChromaFile(int rows, Imf::LineOrder order) {
  Bytes bytes = chromaFile(60, order, Imf::NO_COMPRESSION);
  for (int missing = rows; missing < 60; ++missing) {
    const int row = order == Imf::INCREASING_Y ? missing : 59 - missing;
    const std::size_t samples = row % 2 == 0 ? 3 * 8 : 2 * 8;  // of odd rows luminance and alpha alone
    bytes.resize(bytes.size() - 2 * samples - 8);              // in half floats, behind their row and size
  }
  return bytes;
}

/// How many rows the filter of chroma reads above and below each, the neighbours' saturation included.
constexpr int kRowsOfFilter = 14;

/// Expects the texels of rows that a cut file has: those of the whole one where the filter of chroma reads nothing that
/// is missing, else nearly.
///
/// begin, end   rows that the cut file has
void expectNearly(const Image& cut, const Image& whole, int begin, int end) {
  for (int y = begin; y < end; ++y) {
    const bool is_exact =
        (begin == 0 || y - begin >= kRowsOfFilter) && (end == whole.height() || end - y > kRowsOfFilter);
    for (int x = 0; x < whole.width(); ++x)
      for (int c = 0; c < whole.channels(); ++c)
        ASSERT_NEAR(cut.texel(x, y)[c], whole.texel(x, y)[c], is_exact ? 0.0f : 0.02f) << x << ", " << y << ", " << c;
  }
}

TEST(ExrMissingRows, OfLuminanceAndChromaAreBlack) {
  const Image whole = decoded(cutChromaFile(60, Imf::INCREASING_Y)).image;
  for (const int rows : {1, 2, 29, 40}) {
    const DecodedImage upper = decoded(cutChromaFile(rows, Imf::INCREASING_Y));
    EXPECT_THAT(upper.oddities, ElementsAre("ends before its last row: the " + std::to_string(60 - rows) +
                                            " rows that are missing are black"));
    expectNearly(upper.image, whole, 0, rows);
    for (int y = rows; y < 60; ++y) {
      ASSERT_EQ(upper.image.texel(3, y)[2], 0.0f);
      ASSERT_EQ(upper.image.texel(3, y)[3], 1.0f) << "opaque, as the missing rows of others";
    }
  }
  const DecodedImage lower = decoded(cutChromaFile(40, Imf::DECREASING_Y));
  EXPECT_THAT(lower.oddities, ElementsAre("ends before its last row: the 20 rows that are missing are black"));
  expectNearly(lower.image, decoded(cutChromaFile(60, Imf::DECREASING_Y)).image, 20, 60);
  ASSERT_EQ(lower.image.texel(3, 19)[2], 0.0f);
}

// Rows of odd numbers have the chroma of those around them.
TEST(ExrMissingRows, OfLuminanceWithoutItsChromaAreMissing) {
  EXPECT_THAT(decoded(cutChromaFile(3, Imf::DECREASING_Y)).oddities, ElementsAre(HasSubstr("the 57 rows")));
  const auto none = decodeExr(cutChromaFile(1, Imf::DECREASING_Y));
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("none of its rows is whole"));
}

// Cut anywhere, by transfers that stop: the offsets are there, and the chunks are not.
TEST(ExrMissingRows, OfLuminanceAndChromaThatIsCutAreBlack) {
  const Bytes bytes = chromaFile(40, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
  const Image whole = decoded(bytes).image;
  int rows_before = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const auto cut = decodeExr(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)));
    if (!cut) {
      ASSERT_EQ(rows_before, 0) << length << ": " << cut.error().message;
      continue;
    }
    ASSERT_EQ(cut->oddities.size(), 1u) << length;
    const int rows = cut->oddities[0] == "ends before its last row: the 24 rows that are missing are black" ? 16 : 32;
    if (rows == 32)
      ASSERT_EQ(cut->oddities[0], "ends before its last row: the 8 rows that are missing are black") << length;
    ASSERT_GE(rows, rows_before);
    rows_before = rows;
    expectNearly(cut->image, whole, 0, rows);
    ASSERT_EQ(cut->image.texel(3, rows)[1], 0.0f) << length;
  }
  EXPECT_EQ(rows_before, 32);
}

}  // namespace
}  // namespace mirrorball
