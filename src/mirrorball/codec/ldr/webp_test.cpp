#include "mirrorball/codec/ldr/webp.h"

#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAreArray;
using testing::encodedWebp;
using ::testing::HasSubstr;

constexpr float kLossless = 101.0f;

Image8 picture(int channels) { return pictureFromLinear(testing::gradient(13, 11, channels), channels); }

TEST(Webp, LosslessComesBack) {
  for (const int channels : {3, 4}) {
    const Image8 source = picture(channels);
    const Bytes bytes = encodedWebp(source, kLossless);
    const auto image = decodeImage(bytes);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_THAT(image->image.samples(), ElementsAreArray(linearFromPicture(source).samples()));
    EXPECT_EQ(image->format, "WebP, lossless");
    EXPECT_EQ(image->color, "sRGB");
    const auto texture = decodeTexture(bytes);
    ASSERT_TRUE(texture);
    for (std::size_t i = 0; i < source.texelCount(); ++i)
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_EQ(texture->samples()[4 * i + c],
                  c < std::size_t(channels) ? source.samples()[i * std::size_t(channels) + c] : 255);
  }
}

TEST(Webp, LossyComesBackWithinItsQuality) {
  Image8 smooth(40, 30, 4, 255);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      for (int c = 0; c < 3; ++c) smooth.texel(x, y)[c] = static_cast<std::uint8_t>(60 + 3 * x + 2 * y);
  smooth.texel(3, 4)[3] = 128;
  const auto texture = decodeTexture(encodedWebp(smooth, 95));
  ASSERT_TRUE(texture) << texture.error().message;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) ASSERT_NEAR(texture->texel(x, y)[1], smooth.texel(x, y)[1], 6);
  EXPECT_EQ(texture->texel(3, 4)[3], 128);  // alpha is lossless
  EXPECT_EQ(decodeImage(encodedWebp(smooth, 95))->format, "WebP, lossy");
}

TEST(Webp, AProfileIsNamedAndOneOfAMatrixConverted) {
  const Bytes bytes = testing::extendedWebp(picture(3), 0x20, "ICCP", testing::iccProfile("Display P3"));
  const auto image = decodeImage(bytes);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->color, "sRGB assumed: its ICC profile (Display P3) is not applied");
  const auto p3 = decodeImage(testing::extendedWebp(picture(3), 0x20, "ICCP", testing::iccDisplayP3()));
  ASSERT_TRUE(p3) << p3.error().message;
  EXPECT_EQ(p3->color, "sRGB, primaries of the file (Display P3): converted");
  EXPECT_GT(std::abs(p3->image.samples()[0] - image->image.samples()[0]), 1e-4f);
}

TEST(Webp, IsUprightAsItsExifSays) {
  const Image8 source = picture(3);
  for (const bool is_named : {false, true}) {  // some writers put JPEG's name before it
    const Bytes exif = testing::exifBlock({.exposure_time_s = 0.25, .orientation = 6});
    const Bytes chunk(exif.begin() + (is_named ? 0 : 6), exif.end());
    const Bytes bytes = testing::extendedWebp(source, 0x08, "EXIF", chunk);
    const auto turned = decodeImage(bytes);
    ASSERT_TRUE(turned) << turned.error().message;
    EXPECT_THAT(turned->image.samples(), ElementsAreArray(linearFromPicture(upright(Image8(source), 6)).samples()));
    EXPECT_THAT(turned->oddities, ::testing::ElementsAre("turned upright, as its EXIF says (orientation 6)"));
    EXPECT_EQ(decodeCodes(bytes)->exif.exposure_time_s, 0.25);
  }
}

TEST(Webp, AnAnimationIsRefused) {
  const auto refused = decodeImage(testing::extendedWebp(picture(3), 0x02, "ANIM", Bytes(6)));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::unsupported);
  EXPECT_THAT(refused.error().message, HasSubstr("is an animated WebP"));
}

/// Codes that no neighbour tells, so that the file is as long as its rows are many; alpha is even, for it comes first.
Image8 noisyPicture(int width, int height, int channels) {
  Image8 noisy(width, height, channels, 200);
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < noisy.samples().size(); ++i) {
    state = state * 1664525u + 1013904223u;
    if (channels == 3 || i % 4 != 3) noisy.samples()[i] = static_cast<std::uint8_t>(state >> 24);
  }
  return noisy;
}

Bytes firstPart(const Bytes& bytes, double share) {
  return Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(bytes.size()) * share));
}

// Of lossy files the lowest row that is there may still be without the filter between blocks.
TEST(Webp, ThatEndsEarlyIsReadAsFarAsItGoes) {
  for (const float quality : {80.0f, kLossless})
    for (const int channels : {3, 4}) {
      const Bytes bytes = encodedWebp(noisyPicture(64, 128, channels), quality);
      const Image8 whole = *decodeTexture(bytes);
      int rows_before = 0;
      for (const double share : {0.3, 0.5, 0.7, 0.9}) {
        const auto cut = decodeCodes(firstPart(bytes, share));
        ASSERT_TRUE(cut) << quality << ": " << cut.error().message;
        ASSERT_EQ(cut->oddities.size(), 1u);
        int missing = 0;
        ASSERT_EQ(std::sscanf(cut->oddities[0].c_str(), "ends before its last row: the %d rows", &missing), 1)
            << cut->oddities[0];
        const int rows = 128 - missing;
        ASSERT_GT(rows, rows_before) << share;
        rows_before = rows;
        for (int y = 0; y < 128; ++y)
          for (int x = 0; x < 64; ++x) {
            ASSERT_EQ(cut->codes.texel(x, y)[1], y < rows ? whole.texel(x, y)[1] : 0) << rows << ": " << x << ", " << y;
            ASSERT_EQ(cut->codes.texel(x, y)[3], y < rows ? whole.texel(x, y)[3] : 255);
          }
      }
      EXPECT_GT(rows_before, 64);
    }
  EXPECT_THAT(decodeImage(firstPart(encodedWebp(noisyPicture(64, 128, 3), 80), 0.01)).error().message,
              HasSubstr("before the end of its first row"));
}

TEST(Webp, ThatEndsEarlyKeepsItsProfile) {
  const Bytes bytes = testing::extendedWebp(noisyPicture(64, 128, 3), 0x20, "ICCP", testing::iccDisplayP3());
  const auto cut = decodeImage(firstPart(bytes, 0.6));
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_EQ(cut->color, "sRGB, primaries of the file (Display P3): converted");
}

using testing::Damage;

INSTANTIATE_TEST_SUITE_P(Webp, Damage,
                         ::testing::Values(testing::inPart("WebpLossy", [] { return encodedWebp(picture(3), 80); }),
                                           testing::inPart("WebpLossless",
                                                           [] { return encodedWebp(picture(3), 101); })),
                         testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
