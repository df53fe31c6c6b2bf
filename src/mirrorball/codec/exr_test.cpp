#include "mirrorball/codec/exr.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/codec_testing.h"
#include "mirrorball/codec/exr_stream.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::gradient;
using ::testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

DecodedImage decoded(const Bytes& bytes) {
  auto result = decodeExr(bytes, "test.exr");
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return {Image(1, 1, 3), {}, ""};
  }
  return std::move(*result);
}

Error failureOf(const Bytes& bytes) {
  const auto result = decodeExr(bytes, "test.exr");
  if (result) {
    ADD_FAILURE() << "was read";
    return {};
  }
  return result.error();
}

Bytes encoded(const Image& image, const ImageWriteOptions& options = {}) {
  auto result = encodeExr(image, options, "test.exr");
  EXPECT_TRUE(result);
  return result ? std::move(*result) : Bytes();
}

void expectSameBits(const Image& actual, const Image& expected) {
  ASSERT_EQ(actual.width(), expected.width());
  ASSERT_EQ(actual.height(), expected.height());
  ASSERT_EQ(actual.channels(), expected.channels());
  EXPECT_EQ(std::memcmp(actual.samples().data(), expected.samples().data(), expected.samples().size_bytes()), 0);
}

/// A frame over an image's channels with those names.
Imf::FrameBuffer frameOf(const Image& image, const std::vector<std::string>& names, const Imath::Box2i& window) {
  Imf::FrameBuffer frame;
  const std::size_t texel = sizeof(float) * std::size_t(image.channels());
  for (std::size_t c = 0; c < names.size(); ++c)
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.samples().data() + c, window, texel,
                                            texel * std::size_t(image.width())));
  return frame;
}

void addChannels(Imf::Header& header, const std::vector<std::string>& names) {
  for (const std::string& name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
}

/// A file written by OpenEXR with channels that this program does not write itself.
Bytes foreignFile(Imf::Header header, const Image& image, const std::vector<std::string>& names) {
  addChannels(header, names);
  ExrOutput stream("foreign.exr");
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, names, header.dataWindow()));
    file.writePixels(image.height());
  }
  return stream.takeBytes();
}

/// Tiles of 32 × 32. All levels hold the image's top left corner.
Bytes tiledFile(const Image& image, const std::vector<std::string>& names, Imf::LevelMode levels) {
  Imf::Header header(image.width(), image.height());
  header.setTileDescription(Imf::TileDescription(32, 32, levels));
  addChannels(header, names);
  ExrOutput stream("tiled.exr");
  {
    Imf::TiledOutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, names, header.dataWindow()));
    for (int level = 0; level < file.numLevels(); ++level)
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
  }
  return stream.takeBytes();
}

class ExrSize : public ::testing::TestWithParam<std::tuple<glm::ivec2, int>> {};

TEST_P(ExrSize, FloatsComeBackBitByBit) {
  const auto [size, channels] = GetParam();
  const Image image = gradient(size.x, size.y, channels);
  expectSameBits(decoded(encoded(image)).image, image);
}

INSTANTIATE_TEST_SUITE_P(SizesAndChannels, ExrSize,
                         ::testing::Combine(::testing::Values(glm::ivec2{1, 1}, glm::ivec2{7, 3}, glm::ivec2{100, 57}),
                                            ::testing::Values(1, 3, 4)));

TEST(Exr, NanAndInfinityAreKept) {
  Image image(3, 1, 3, 0.5f);
  image.texel(0, 0)[0] = kNan;
  image.texel(1, 0)[1] = kInfinity;
  image.texel(2, 0)[2] = -kInfinity;
  expectSameBits(decoded(encoded(image)).image, image);
  EXPECT_EQ(findNonFinite(decoded(encoded(image, {.half = true, .metadata = {}})).image).count, 3u);
}

TEST(Exr, HalfIsClampedToItsRange) {
  Image image(4, 1, 1);
  const float given[] = {1e6f, -1e6f, 65504.0f, 65519.0f};
  const float expected[] = {65504.0f, -65504.0f, 65504.0f, 65504.0f};
  std::copy(std::begin(given), std::end(given), image.samples().begin());
  const DecodedImage back = decoded(encoded(image, {.half = true, .metadata = {}}));
  EXPECT_THAT(back.image.samples(), ::testing::ElementsAreArray(expected));
  EXPECT_EQ(back.format, "OpenEXR, half, ZIP");
}

TEST(Exr, HalfRoundsToTenBits) {
  const Image image = gradient(20, 20, 3);
  const Image back = decoded(encoded(image, {.half = true, .metadata = {}})).image;
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    ASSERT_NEAR(back.samples()[i], image.samples()[i], image.samples()[i] / 2048.0f);
}

TEST(Exr, MetadataComesBack) {
  const Metadata metadata{{"mirrorball:projection", "cube"}, {"mirrorball:layout", "vstrip"}, {"envmap", "latlong"}};
  EXPECT_EQ(decoded(encoded(Image(2, 2, 3), {.half = false, .metadata = metadata})).metadata, metadata);
  const Metadata cube{{"envmap", "cube"}};
  EXPECT_EQ(decoded(encoded(Image(2, 12, 3), {.half = false, .metadata = cube})).metadata, cube);
}

class ExrCompression : public ::testing::TestWithParam<int> {};

TEST_P(ExrCompression, IsRead) {
  const Image image = gradient(70, 50, 3);
  Imf::Header header(70, 50);
  header.compression() = static_cast<Imf::Compression>(GetParam());
  const DecodedImage back = decoded(foreignFile(header, image, {"R", "G", "B"}));
  // PXR24 keeps 24 bits; B44 keeps floats whole; DWA loses what its level 45 lets go.
  const bool dwa = GetParam() == Imf::DWAA_COMPRESSION || GetParam() == Imf::DWAB_COMPRESSION;
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    ASSERT_NEAR(back.image.samples()[i], image.samples()[i], dwa ? 0.05f : 1e-4f);
}

// Far more texels a byte than a picture has, which the check of sizes must still let through.
TEST_P(ExrCompression, OfABlackImageIsNotTakenForALie) {
  Imf::Header header(2048, 1024);
  header.compression() = static_cast<Imf::Compression>(GetParam());
  const DecodedImage back = decoded(foreignFile(header, Image(2048, 1024, 3), {"R", "G", "B"}));
  EXPECT_EQ(back.image.width(), 2048);
}

INSTANTIATE_TEST_SUITE_P(All, ExrCompression, ::testing::Range(0, static_cast<int>(Imf::NUM_COMPRESSION_METHODS)));

TEST(Exr, TilesAreRead) {
  const Image image = gradient(70, 50, 4);
  const DecodedImage back = decoded(tiledFile(image, {"R", "G", "B", "A"}, Imf::ONE_LEVEL));
  expectSameBits(back.image, image);
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, tiled");
}

TEST(Exr, OfSeveralLevelsTheLargestIsRead) {
  const Image image = gradient(70, 50, 3);
  expectSameBits(decoded(tiledFile(image, {"R", "G", "B"}, Imf::MIPMAP_LEVELS)).image, image);
}

TEST(Exr, TheDataWindowIsTheImage) {
  const Image image = gradient(5, 4, 3);
  const Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), Imath::Box2i({-7, 20}, {-3, 23}));
  expectSameBits(decoded(foreignFile(header, image, {"R", "G", "B"})).image, image);
}

TEST(Exr, UnsignedIntegersBecomeFloats) {
  std::vector<unsigned> samples{0, 1, 70000};
  Imf::Header header(3, 1);
  header.channels().insert("Y", Imf::Channel(Imf::UINT));
  ExrOutput stream("uint.exr");
  {
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::UINT, samples.data(), header.dataWindow()));
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  const DecodedImage back = decoded(stream.takeBytes());
  EXPECT_THAT(back.image.samples(), ::testing::ElementsAre(0.0f, 1.0f, 70000.0f));
  EXPECT_EQ(back.format, "OpenEXR, uint, ZIP");
}

TEST(Exr, GreyWithAlphaBecomesFourChannels) {
  const Image image = decoded(foreignFile(Imf::Header(5, 4), gradient(5, 4, 2), {"Y", "A"})).image;
  const Image source = gradient(5, 4, 2);
  ASSERT_EQ(image.channels(), 4);
  EXPECT_EQ(rgbaAt(image, 3, 2), glm::vec4(glm::vec3(source.texel(3, 2)[0]), source.texel(3, 2)[1]));
}

TEST(Exr, ALayerIsReadWhereThereIsNoPlainColour) {
  const Image image = gradient(5, 4, 4);
  const Bytes bytes = foreignFile(Imf::Header(5, 4), image, {"light.R", "light.G", "light.B", "depth.Z"});
  const DecodedImage back = decoded(bytes);
  EXPECT_EQ(rgbAt(back.image, 3, 2), rgbAt(image, 3, 2));
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, layer light");
}

TEST(Exr, LuminanceAndChromaAreRead) {
  ExrOutput stream("chroma.exr");
  const std::vector<Imf::Rgba> orange(30 * 20, Imf::Rgba(0.75f, 0.5f, 0.25f, 1.0f));
  {
    Imf::RgbaOutputFile file(stream, Imf::Header(30, 20), Imf::WRITE_YC);
    file.setFrameBuffer(orange.data(), 1, 30);
    file.writePixels(20);
  }
  const DecodedImage back = decoded(stream.takeBytes());
  ASSERT_EQ(back.image.channels(), 3);
  for (const auto& [x, y] : {std::pair{0, 0}, {15, 10}, {29, 19}}) {
    EXPECT_NEAR(back.image.texel(x, y)[0], 0.75f, 2e-3f);
    EXPECT_NEAR(back.image.texel(x, y)[2], 0.25f, 2e-3f);
  }
  EXPECT_THAT(back.format, HasSubstr("luminance and chroma"));
}

TEST(Exr, ChromaticitiesAreConverted) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header,
                         Imf::Chromaticities({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}));
  Image red(1, 1, 3);
  red.samples()[0] = 1.0f;
  const Image back = decoded(foreignFile(header, red, {"R", "G", "B"})).image;
  EXPECT_NEAR(back.samples()[0], 1.6605f, 1e-3f);
  EXPECT_NEAR(back.samples()[1], -0.1246f, 1e-3f);
}

TEST(Exr, TheFirstPartWithColourIsRead) {
  const Image image = gradient(6, 5, 3);
  const Imath::Box2i screen({0, 0}, {5, 4});  // one for all parts
  std::vector<Imf::Header> headers{Imf::Header(screen, Imath::Box2i({0, 0}, {2, 1})), Imf::Header(screen, screen)};
  addChannels(headers[0], {"Z"});
  addChannels(headers[1], {"R", "G", "B"});
  const char* names[] = {"depth", "colour"};
  for (std::size_t i = 0; i < 2; ++i) {
    headers[i].setName(names[i]);
    headers[i].setType(Imf::SCANLINEIMAGE);
  }
  ExrOutput stream("parts.exr");
  {
    Imf::MultiPartOutputFile file(stream, headers.data(), 2);
    Imf::OutputPart depth(file, 0);
    const Image depths(3, 2, 1);
    depth.setFrameBuffer(frameOf(depths, {"Z"}, headers[0].dataWindow()));
    depth.writePixels(2);
    Imf::OutputPart colour(file, 1);
    colour.setFrameBuffer(frameOf(image, {"R", "G", "B"}, headers[1].dataWindow()));
    colour.writePixels(5);
  }
  const DecodedImage back = decoded(stream.takeBytes());
  expectSameBits(back.image, image);
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, part 2");
}

TEST(Exr, AFileWithoutColourListsItsChannels) {
  const Error error = failureOf(foreignFile(Imf::Header(5, 4), gradient(5, 4, 2), {"Z", "id"}));
  EXPECT_EQ(error.code, ErrorCode::unsupported);
  EXPECT_THAT(error.message, HasSubstr("Z id"));
}

TEST(Exr, AFileThatWasNotWrittenToItsEndIsRefused) {
  Imf::Header header(40, 40);
  addChannels(header, {"R", "G", "B"});
  const Image image = gradient(40, 40, 3);
  ExrOutput stream("half.exr");
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, {"R", "G", "B"}, header.dataWindow()));
    file.writePixels(20);
  }
  const Error error = failureOf(stream.takeBytes());
  EXPECT_EQ(error.code, ErrorCode::bad_file);
  EXPECT_THAT(error.message, HasSubstr("missing"));
}

/// Replaces the data window's largest x and y where they stand in a file's header.
Bytes withDataWindow(Bytes bytes, std::int32_t x, std::int32_t y) {
  const std::string key = std::string("dataWindow\0box2i\0", 17);
  const auto found = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
  EXPECT_NE(found, bytes.end());
  static_assert(std::endian::native == std::endian::little);
  std::uint8_t* largest = &*found + key.size() + 4 + 8;  // behind the attribute's size and the minimum
  std::memcpy(largest, &x, 4);
  std::memcpy(largest + 4, &y, 4);
  return bytes;
}

TEST(Exr, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  const Bytes bytes = encoded(gradient(8, 8, 3));
  EXPECT_EQ(failureOf(withDataWindow(bytes, -1, 7)).code, ErrorCode::bad_file);
  EXPECT_EQ(failureOf(withDataWindow(bytes, 2147483647, 7)).code, ErrorCode::too_large);
  EXPECT_EQ(failureOf(withDataWindow(bytes, 1 << 29, 7)).code, ErrorCode::too_large);
  EXPECT_THAT(failureOf(withDataWindow(bytes, (1 << 26) - 1, 7)).message, HasSubstr("cannot hold"));

  Bytes tiled = tiledFile(gradient(8, 8, 3), {"R", "G", "B"}, Imf::ONE_LEVEL);
  const std::string key = std::string("tiles\0tiledesc\0", 15);
  const auto found = std::search(tiled.begin(), tiled.end(), key.begin(), key.end());
  ASSERT_NE(found, tiled.end());
  *(found + 15 + 4 + 3) = 0x7f;  // the highest byte of a tile's width
  EXPECT_EQ(failureOf(tiled).code, ErrorCode::too_large);

  Bytes attribute = bytes;
  attribute[8 + std::string("channels.chlist.").size() + 3] = 0x7f;  // of the first attribute's size
  EXPECT_THAT(failureOf(attribute).message, HasSubstr("attribute at byte 24"));

  // OpenEXR reads a list of channels to its end, whatever its size (found by the fuzzer).
  Bytes list = bytes;
  list[8 + std::string("channels.chlist.").size()] -= 3;
  EXPECT_THAT(failureOf(list).message, HasSubstr("which its type does not have"));
}

TEST(Exr, RealFileWithDwab) {
  const auto path = testing::sharedData("courtyard.exr");
  if (!path) GTEST_SKIP() << "no shared data: set MIRRORBALL_DATA";
  const auto result = readImage(*path);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->image.width(), 1024);
  EXPECT_EQ(result->image.height(), 512);
  EXPECT_THAT(result->format, HasSubstr("DWAB"));
  EXPECT_EQ(findNonFinite(result->image).count, 0u);
  // The sky under the roof's edge, and the orange wall on the left.
  EXPECT_GT(result->image.texel(530, 150)[2], 1.0f);
  const glm::vec3 wall = rgbAt(result->image, 60, 230);
  EXPECT_GT(wall.r, 1.5f * wall.g);
  EXPECT_GT(wall.g, 1.5f * wall.b);
}

}  // namespace
}  // namespace mirrorball
