#include "mirrorball/codec/exr/exr.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/exr/exr_stream.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/written_format_testing.h"
#include "test_data.h"

namespace mirrorball {
namespace {

using testing::addChannels;
using testing::decoded;
using testing::expectSameBits;
using testing::foreignFile;
using testing::frameOf;
using testing::gradient;
using ::testing::HasSubstr;
using testing::tiledFile;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Error failureOfExr(const Bytes& bytes) {
  const auto result = decodeExr(bytes);
  if (result) {
    ADD_FAILURE() << "was read";
    return {};
  }
  return result.error();
}

Bytes encoded(const Image& image, const ImageWriteOptions& options = {}) {
  auto result = encodeExr(image, options);
  EXPECT_TRUE(result);
  return result ? std::move(*result) : Bytes();
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

// What is written beside the image does not change how it is read, and OpenEXR finds it under its name.
TEST(Exr, LayersAreWrittenBesideTheImage) {
  const Image image = gradient(7, 5, 4), normals = gradient(7, 5, 3);
  const Bytes bytes = encoded(image, {.metadata = {}, .layers = {{"normal", "XYZ", normals}}});
  expectSameBits(decoded(bytes).image, image);
  ExrInput stream(bytes);
  Imf::InputFile file(stream);
  std::vector<float> y(7 * 5);
  Imf::FrameBuffer frame;
  frame.insert("normal.Y", Imf::Slice::Make(Imf::FLOAT, y.data(), file.header().dataWindow()));
  file.setFrameBuffer(frame);
  file.readPixels(0, 4);
  EXPECT_EQ(y[3 * 7 + 2], normals.texel(2, 3)[1]);
  EXPECT_FALSE(writeImage("layers.hdr", image, {.metadata = {}, .layers = {{"normal", "XYZ", normals}}}));
}

TEST(Exr, AFileWithoutAPictureListsItsLayers) {
  const Error error = failureOfExr(foreignFile(Imf::Header(5, 4), gradient(5, 4, 2), {"Z", "id"}));
  EXPECT_EQ(error.code, ErrorCode::unsupported);
  EXPECT_THAT(error.message, HasSubstr("no picture among its layers: Z, id;"));
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
  EXPECT_EQ(failureOfExr(withDataWindow(bytes, -1, 7)).code, ErrorCode::bad_file);
  EXPECT_EQ(failureOfExr(withDataWindow(bytes, 2147483647, 7)).code, ErrorCode::too_large);
  EXPECT_EQ(failureOfExr(withDataWindow(bytes, 1 << 29, 7)).code, ErrorCode::too_large);
  EXPECT_THAT(failureOfExr(withDataWindow(bytes, (1 << 26) - 1, 7)).message, HasSubstr("cannot hold"));

  Bytes tiled = tiledFile(Imf::Header(8, 8), gradient(8, 8, 3), {"R", "G", "B"}, Imf::ONE_LEVEL);
  const std::string key = std::string("tiles\0tiledesc\0", 15);
  const auto found = std::search(tiled.begin(), tiled.end(), key.begin(), key.end());
  ASSERT_NE(found, tiled.end());
  *(found + 15 + 4 + 3) = 0x7f;  // the highest byte of a tile's width
  EXPECT_EQ(failureOfExr(tiled).code, ErrorCode::too_large);

  Bytes attribute = bytes;
  attribute[8 + std::string("channels.chlist.").size() + 3] = 0x7f;  // of the first attribute's size
  EXPECT_THAT(failureOfExr(attribute).message, HasSubstr("attribute at byte 24"));

  // OpenEXR reads a list of channels to its end, whatever its size (found by the fuzzer).
  Bytes list = bytes;
  list[8 + std::string("channels.chlist.").size()] -= 3;
  EXPECT_THAT(failureOfExr(list).message, HasSubstr("which its type does not have"));
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

TEST(Exr, StopsWhenItIsTold) {
  const Bytes file = *encodeExr(Image(8, 1000, 3, 1.0f), {});
  std::vector<std::size_t> told;
  const auto stopped = decodeExr(file, {.progress = [&](std::size_t done, std::size_t total) {
                                   EXPECT_EQ(total, 1000u);
                                   told.push_back(done);
                                   return done < 512;
                                 }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  EXPECT_EQ(told, (std::vector<std::size_t>{256, 512}));
}

using testing::CodecFormat;

INSTANTIATE_TEST_SUITE_P(Exr, CodecFormat, ::testing::Values(testing::WrittenFormat{"a.exr", 0.0f, true}));

}  // namespace
}  // namespace mirrorball
