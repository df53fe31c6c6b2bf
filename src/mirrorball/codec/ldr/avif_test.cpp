#include "mirrorball/codec/ldr/avif.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/avif_testing.h"

namespace mirrorball {
namespace {

using testing::AvifForm;
using testing::avifOf;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;

Image8 avifPicture(int channels) { return pictureFromLinear(testing::gradient(13, 11, channels), channels); }

TEST(Avif, EightBitsComeBack) {
  for (const int channels : {3, 4}) {
    const Image8 source = avifPicture(channels);
    const Bytes bytes = avifOf(source);
    EXPECT_TRUE(isAvif(bytes));
    const auto image = decodeAvif(bytes);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, "AVIF, 8 bits");
    EXPECT_EQ(image->color, "sRGB");
    const Image light = linearFromPicture(source);
    ASSERT_EQ(image->image.channels(), channels);
    for (std::size_t i = 0; i < light.samples().size(); ++i)
      ASSERT_NEAR(image->image.samples()[i], light.samples()[i], 1e-5f) << i;
    const auto texture = decodeAvifTexture(bytes);
    ASSERT_TRUE(texture);
    EXPECT_EQ(texture->channels(), 4);
    EXPECT_EQ(texture->texel(5, 6)[1], source.texel(5, 6)[1]);
  }
}

TEST(Avif, TwelveBitsOfPqAreLight) {
  ImageOf<std::uint16_t> codes(8, 8, 3, 0);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int c = 0; c < 3; ++c) codes.texel(x, y)[c] = static_cast<std::uint16_t>(x * 585);
  const auto image = decodeAvif(avifOf(codes, AvifForm{.depth = 12, .primaries = 9, .transfer = 16}));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->format, "AVIF, 12 bits");
  EXPECT_EQ(image->color, "PQ, primaries of the file (Rec.2020): converted");
  EXPECT_NEAR(image->image.texel(7, 3)[1], 10000.0f / 203.0f, 0.1f);
  EXPECT_NEAR(image->image.texel(0, 3)[1], 0.0f, 1e-5f);
  const auto stored = decodeAvifCodes(avifOf(codes, AvifForm{.depth = 12}));
  ASSERT_TRUE(stored);
  EXPECT_NEAR(std::get<ImageOf<std::uint16_t>>(*stored).texel(3, 3)[0], 3 * 585 * 65535 / 4095, 1);
}

TEST(Avif, IsUpright) {
  const Image8 source = avifPicture(3);
  const auto turned = decodeAvifTexture(avifOf(source, AvifForm{.quarters = 1}));
  ASSERT_TRUE(turned);
  ASSERT_EQ(turned->width(), source.height());
  // Against the clock: what is on the right comes to the top.
  EXPECT_EQ(turned->texel(2, 0)[0], source.texel(source.width() - 1, 2)[0]);
  const auto mirrored = decodeAvifTexture(avifOf(source, AvifForm{.mirrors = true}));
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->texel(0, 4)[1], source.texel(source.width() - 1, 4)[1]);
}

TEST(Avif, OtherBoxesAreNone) {
  EXPECT_FALSE(isAvif(testing::bytesOf(std::string("\0\0\0\x18", 4) + "ftypheic" + std::string(12, '\0'))));
  EXPECT_FALSE(isAvif(testing::bytesOf("ftypavif")));
  EXPECT_TRUE(isAvif(testing::bytesOf(std::string("\0\0\0\x14", 4) + "ftypmif1" + std::string(4, '\0') + "avif")));
  EXPECT_FALSE(isAvif(testing::bytesOf(std::string("\0\0\0\x10", 4) + "ftypmif1" + std::string(4, '\0') + "avif")))
      << "beyond the box";
}

INSTANTIATE_TEST_SUITE_P(Avif, Damage,
                         ::testing::Values(testing::DamagedFile{"avif", [] { return avifOf(avifPicture(4)); }}),
                         testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
