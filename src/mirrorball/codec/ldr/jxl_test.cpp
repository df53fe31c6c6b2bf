#include "mirrorball/codec/ldr/jxl.h"

#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/compressed_xmp.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/jxl_testing.h"
#include "mirrorball/codec/ldr/jxl_xmp.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using testing::jxlFile;
using testing::JxlForm;

Image8 jxlPicture(int channels) { return pictureFromLinear(testing::gradient(13, 11, channels), channels); }

TEST(Jxl, IntegersComeBack) {
  for (const int channels : {3, 4}) {
    const Image8 source = jxlPicture(channels);
    const Bytes bytes = jxlFile(source);
    EXPECT_TRUE(isJxl(bytes));
    const auto image = decodeJxl(bytes);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, "JPEG XL, 8 bits");
    EXPECT_EQ(image->color, "sRGB");
    const Image light = linearFromPicture(source);
    ASSERT_EQ(image->image.channels(), channels);
    for (std::size_t i = 0; i < light.samples().size(); ++i)
      ASSERT_NEAR(image->image.samples()[i], light.samples()[i], 1e-5f) << i;
    const auto texture = decodeTexture(bytes);
    ASSERT_TRUE(texture);
    EXPECT_EQ(texture->texel(5, 6)[1], source.texel(5, 6)[1]);
    EXPECT_TRUE(jxlCodec().holds_integers(bytes));
  }
}

TEST(Jxl, SixteenBitsComeBackAsTheyAre) {
  ImageOf<std::uint16_t> source(9, 7, 3, 0);
  for (std::size_t i = 0; i < source.samples().size(); ++i) source.samples()[i] = static_cast<std::uint16_t>(i * 331);
  const auto codes = decodeJxlCodes(jxlFile(source));
  ASSERT_TRUE(codes) << codes.error().message;
  EXPECT_THAT(std::get<ImageOf<std::uint16_t>>(codes->codes).samples(), ::testing::ElementsAreArray(source.samples()));
}

TEST(Jxl, EightBitsAreCodesOfEightBits) {
  const auto codes = decodeJxlCodes(jxlFile(jxlPicture(3)));
  ASSERT_TRUE(codes) << codes.error().message;
  EXPECT_TRUE(std::holds_alternative<Image8>(codes->codes));
}

// libjxl decodes them all, though nobody asks for them.
TEST(Jxl, ExtraChannelsCountAsMemory) {
  const Image8 source(256, 256, 3, 100);
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{16} << 20u);
  const auto plain = decodeJxl(jxlFile(source));
  const auto refused = decodeJxl(jxlFile(source, JxlForm{.extra_channels = 32}));
  setMemoryLimit(usual);
  EXPECT_TRUE(plain) << plain.error().message;
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_TRUE(decodeJxl(jxlFile(source, JxlForm{.extra_channels = 32})));
}

// A sun of 1e5 beside black.
TEST(Jxl, FloatsAreLight) {
  Image source(8, 4, 3, 0.0f);
  source.texel(3, 2)[0] = 1e5f;
  source.texel(3, 2)[1] = 0.25f;
  const Bytes bytes = jxlFile(source, JxlForm{.transfer = JXL_TRANSFER_FUNCTION_LINEAR});
  const auto image = decodeJxl(bytes);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->format, "JPEG XL, 32-bit floats");
  EXPECT_EQ(image->color, "linear, Rec.709");
  EXPECT_EQ(image->image.texel(3, 2)[0], 1e5f);
  EXPECT_EQ(image->image.texel(3, 2)[1], 0.25f);
  EXPECT_EQ(image->image.texel(2, 2)[0], 0.0f);
  EXPECT_FALSE(jxlCodec().holds_integers(bytes));
}

TEST(Jxl, PqIsLightWithAndWithoutLoss) {
  ImageOf<std::uint16_t> white(32, 32, 3, static_cast<std::uint16_t>(0.58f * 65535.0f));
  for (const bool is_lossy : {false, true}) {
    const auto image = decodeJxl(jxlFile(
        white, JxlForm{.transfer = JXL_TRANSFER_FUNCTION_PQ, .primaries = JXL_PRIMARIES_2100, .is_lossy = is_lossy}));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->color, "PQ, primaries of the file (Rec.2020): converted");
    EXPECT_NEAR(image->image.texel(16, 16)[1], 1.0f, is_lossy ? 0.05f : 0.01f);
  }
}

TEST(Jxl, IsUpright) {
  const Image8 source = jxlPicture(3);
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Bytes bytes = jxlFile(source, JxlForm{.orientation = orientation});
    const Image8 expected = upright(Image8(source), orientation);
    const auto turned = decodeCodes(bytes);
    ASSERT_TRUE(turned) << turned.error().message;
    ASSERT_EQ(turned->codes.width(), expected.width());
    EXPECT_EQ(turned->codes.texel(2, 4)[0], expected.texel(2, 4)[0]);
    const auto light = decodeImage(bytes);
    ASSERT_TRUE(light);
    EXPECT_NEAR(light->image.texel(2, 4)[0], linearFromPicture(expected).texel(2, 4)[0], 1e-4f);
    for (const auto& oddities : {turned->oddities, light->oddities})
      EXPECT_EQ(oddities.size(), orientation == 1 ? 0u : 1u);
  }
}

// Which libjxl's own encoder compresses by itself.
TEST(Jxl, XmpThatBrotliCompressedIsFound) {
  const std::string packet = "<x:xmpmeta>" + std::string(40000, 'x') + "</x:xmpmeta>";
  const Bytes file = jxlFile(jxlPicture(3), JxlForm{.xmp = packet});
  EXPECT_TRUE(decodeJxlCodes(file));
  EXPECT_EQ(compressedXmp(file), packet);
  EXPECT_EQ(compressedXmp(jxlFile(jxlPicture(3))), "");
  const std::string other = "<svg>" + std::string(40000, 'x') + "</svg>";
  EXPECT_EQ(compressedXmp(jxlFile(jxlPicture(3), JxlForm{.other_xml = other, .xmp = packet})), packet);
  const std::string long_one(kLongestCompressedXmp, ' ');
  EXPECT_EQ(compressedXmp(jxlFile(jxlPicture(3), JxlForm{.other_xml = long_one, .xmp = packet})), "");
  for (std::size_t size = 0; size < 300; ++size) {
    const std::string found = compressedXmpInJxl(std::span(file).first(size));
    EXPECT_TRUE(found.empty() || found == packet) << size;
  }
  EXPECT_EQ(compressedXmpInJxl(std::span(file).first(40)), "") << "in the middle of the box";
}

INSTANTIATE_TEST_SUITE_P(Jxl, Damage,
                         ::testing::Values(testing::DamagedFile{"jxl", [] { return jxlFile(jxlPicture(4)); }}),
                         testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
