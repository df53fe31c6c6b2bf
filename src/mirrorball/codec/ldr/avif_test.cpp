#include "mirrorball/codec/ldr/avif.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/avif_testing.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using testing::avifFile;
using testing::AvifForm;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Image8 avifPicture(int channels) { return pictureFromLinear(testing::gradient(13, 11, channels), channels); }

TEST(Avif, EightBitsComeBack) {
  for (const int channels : {3, 4}) {
    const Image8 source = avifPicture(channels);
    const Bytes bytes = avifFile(source);
    EXPECT_TRUE(isAvif(bytes));
    const auto image = decodeImage(bytes);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, "AVIF, 8 bits");
    EXPECT_EQ(image->color, "sRGB");
    const Image light = linearFromPicture(source);
    ASSERT_EQ(image->image.channels(), channels);
    for (std::size_t i = 0; i < light.samples().size(); ++i)
      ASSERT_NEAR(image->image.samples()[i], light.samples()[i], 1e-5f) << i;
    const auto texture = decodeTexture(bytes);
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
  const auto image = decodeImage(avifFile(codes, AvifForm{.depth = 12, .primaries = 9, .transfer = 16}));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->format, "AVIF, 12 bits");
  EXPECT_EQ(image->color, "PQ, primaries of the file (Rec.2020): converted");
  EXPECT_NEAR(image->image.texel(7, 3)[1], 10000.0f / 203.0f, 0.1f);
  EXPECT_NEAR(image->image.texel(0, 3)[1], 0.0f, 1e-5f);
  const auto stored = decodeAvif(avifFile(codes, AvifForm{.depth = 12}));
  ASSERT_TRUE(stored);
  EXPECT_NEAR(std::get<ImageOf<std::uint16_t>>(stored->codes).texel(3, 3)[0], 3 * 585 * 65535 / 4095, 1);
}

TEST(Avif, IsUpright) {
  const Image8 source = avifPicture(3);
  const auto turned = decodeTexture(avifFile(source, AvifForm{.quarters = 1}));
  ASSERT_TRUE(turned);
  ASSERT_EQ(turned->width(), source.height());
  // Against the clock: what is on the right comes to the top.
  EXPECT_EQ(turned->texel(2, 0)[0], source.texel(source.width() - 1, 2)[0]);
  const auto mirrored = decodeTexture(avifFile(source, AvifForm{.mirrors = true}));
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored->texel(0, 4)[1], source.texel(source.width() - 1, 4)[1]);
  // First turned, a quarter after the other, and then mirrored.
  Image8 expected = source;
  for (int quarters = 0; quarters < 4; ++quarters) {
    const auto both = decodeCodes(avifFile(source, AvifForm{.quarters = quarters, .mirrors = true}));
    ASSERT_TRUE(both);
    const Image8 last = upright(Image8(expected), 2);
    ASSERT_EQ(both->codes.width(), last.width());
    EXPECT_EQ(both->codes.texel(3, 1)[0], last.texel(3, 1)[0]) << quarters;
    EXPECT_EQ(both->oddities.size(), 1u);
    expected = upright(std::move(expected), 8);
  }
}

// 13 x 11 texels, of which 6 x 5 are shown: their middle is half a texel left of the picture's, and a texel below it.
constexpr avifCleanApertureBox kAperture{6, 1, 5, 1, std::uint32_t(-1), 2, 1, 1};

TEST(Avif, ItsCleanApertureIsThePicture) {
  const Image8 source = avifPicture(3);
  ASSERT_EQ(glm::ivec2(source.width(), source.height()), glm::ivec2(13, 11));
  const auto cut = decodeCodes(avifFile(source, AvifForm{.clap = kAperture}));
  ASSERT_TRUE(cut) << cut.error().message;
  ASSERT_EQ(glm::ivec2(cut->codes.width(), cut->codes.height()), glm::ivec2(6, 5));
  EXPECT_EQ(cut->codes.texel(0, 0)[0], source.texel(3, 4)[0]);
  EXPECT_EQ(cut->codes.texel(5, 4)[1], source.texel(8, 8)[1]);
  EXPECT_THAT(cut->oddities,
              ElementsAre("is cut to 6x5 of its 13x11 texels at (3, 4), as its clean aperture (clap) says"));
  // It is cut first, and then turned.
  const auto turned = decodeTexture(avifFile(source, AvifForm{.quarters = 1, .clap = kAperture}));
  ASSERT_TRUE(turned);
  ASSERT_EQ(turned->width(), 5);
  EXPECT_EQ(turned->texel(0, 0)[0], source.texel(8, 4)[0]);
  const avifCleanApertureBox whole{13, 1, 11, 1, 0, 1, 0, 1};
  EXPECT_THAT(decodeCodes(avifFile(source, AvifForm{.clap = whole}))->oddities, IsEmpty());
}

// As whoever crops about the middle writes it: six of thirteen texels begin behind three and a half.
TEST(Avif, ACleanApertureBetweenTexelsIsRounded) {
  const Image8 source = avifPicture(3);
  struct Row {
    avifCleanApertureBox clap;
    int width, left;
  };
  for (const Row& row : {Row{{6, 1, 5, 1, 0, 1, 0, 1}, 6, 4},
                         {{25, 4, 5, 1, 0, 1, 0, 1}, 6, 4},
                         {{13, 2, 5, 1, 0, 1, 0, 1}, 7, 3},
                         {{12, 1, 5, 1, 1, 2, 0, 1}, 12, 1},
                         {{12, 1, 5, 1, std::uint32_t(-1), 1, 0, 1}, 12, 0}}) {
    const auto cut = decodeCodes(avifFile(source, AvifForm{.clap = row.clap}));
    ASSERT_TRUE(cut) << cut.error().message;
    ASSERT_EQ(cut->codes.width(), row.width);
    EXPECT_EQ(cut->codes.texel(0, 0)[0], source.texel(row.left, 3)[0]);
    EXPECT_EQ(cut->codes.texel(row.width - 1, 4)[1], source.texel(row.left + row.width - 1, 7)[1]);
    const bool is_whole = row.clap.widthN == 12 && row.clap.horizOffN == 1;
    EXPECT_THAT(cut->oddities, ElementsAre("is cut to " + std::to_string(row.width) + "x5 of its 13x11 texels at (" +
                                           std::to_string(row.left) + ", 3), as its clean aperture (clap) says" +
                                           (is_whole ? "" : ", rounded to whole texels")));
  }
}

TEST(Avif, ACleanApertureBeyondThePictureIsIgnored) {
  const Image8 source = avifPicture(3);
  for (const avifCleanApertureBox& beyond :
       {avifCleanApertureBox{15, 1, 11, 1, 0, 1, 0, 1}, {5, 1, 5, 1, 9, 1, 0, 1}, {5, 0, 5, 1, 0, 1, 0, 1}}) {
    const auto read = decodeCodes(avifFile(source, AvifForm{.clap = beyond}));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->codes.width(), 13);
    EXPECT_THAT(read->oddities, ElementsAre(HasSubstr("does not lie in the picture")));
  }
}

/// A grey picture.
Bytes flatAvif(int side) {
  const std::unique_ptr<avifImage, decltype(&avifImageDestroy)> image(
      avifImageCreate(side, side, 8, AVIF_PIXEL_FORMAT_YUV400), avifImageDestroy);
  avifImageAllocatePlanes(image.get(), AVIF_PLANES_YUV);
  std::fill_n(image->yuvPlanes[0], std::size_t(image->yuvRowBytes[0]) * std::size_t(side), std::uint8_t{128});
  const std::unique_ptr<avifEncoder, decltype(&avifEncoderDestroy)> encoder(avifEncoderCreate(), avifEncoderDestroy);
  encoder->speed = AVIF_SPEED_FASTEST;
  avifRWData output = AVIF_DATA_EMPTY;
  EXPECT_EQ(avifEncoderWrite(encoder.get(), image.get(), &output), AVIF_RESULT_OK);
  Bytes bytes(output.data, output.data + output.size);
  avifRWDataFree(&output);
  return bytes;
}

// Where the levels of AV1 end, dav1d gives up, and libaom goes on.
TEST(AvifLarge, MayHaveMoreTexelsThanTheLevelsOfAv1) {
  const auto texture = decodeTexture(flatAvif(5984));
  ASSERT_TRUE(texture) << texture.error().message;
  EXPECT_EQ(texture->width(), 5984);
  EXPECT_NEAR(texture->texel(5983, 5983)[0], 128, 1);
}

/// The file that says of its picture that it has another size than its data.
Bytes sayingSize(Bytes bytes, std::uint8_t side) {
  constexpr std::string_view kName = "ispe";
  const auto box = std::search(bytes.begin(), bytes.end(), kName.begin(), kName.end());
  EXPECT_NE(box, bytes.end());
  const std::array<std::uint8_t, 8> size{0, 0, 0, side, 0, 0, 0, side};
  std::copy(size.begin(), size.end(), box + 8);  // after the name and a version
  return bytes;
}

TEST(Avif, DataThatIsLargerThanTheFileSaysTakesNoMoreMemory) {
  const Bytes small = sayingSize(flatAvif(1024), 16);
  const auto scaled = decodeImage(small);
  ASSERT_TRUE(scaled) << scaled.error().message;
  EXPECT_EQ(scaled->image.width(), 16) << "libavif scales it";
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{8} << 20u);
  const auto refused = decodeImage(small);
  setMemoryLimit(usual);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large) << refused.error().message;
}

TEST(Avif, OtherBoxesAreNone) {
  EXPECT_FALSE(isAvif(testing::bytesOf(std::string("\0\0\0\x18", 4) + "ftypheic" + std::string(12, '\0'))));
  EXPECT_FALSE(isAvif(testing::bytesOf("ftypavif")));
  EXPECT_TRUE(isAvif(testing::bytesOf(std::string("\0\0\0\x14", 4) + "ftypmif1" + std::string(4, '\0') + "avif")));
  EXPECT_FALSE(isAvif(testing::bytesOf(std::string("\0\0\0\x10", 4) + "ftypmif1" + std::string(4, '\0') + "avif")))
      << "beyond the box";
}

INSTANTIATE_TEST_SUITE_P(Avif, Damage,
                         ::testing::Values(testing::DamagedFile{"avif", [] { return avifFile(avifPicture(4)); }}),
                         testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
