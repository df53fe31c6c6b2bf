#include "mirrorball/codec/ldr/ultra_hdr.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using testing::bytesOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;

constexpr GainMap kFourStops{.min_log2 = glm::vec3(-1.0f), .max_log2 = glm::vec3(4.0f), .headroom_max_log2 = 4.0f};

/// A picture of code 128 whose map has the code 204, everywhere.
Bytes evenUltraHdr(int channels = 3, glm::ivec2 map_size = {8, 4}) {
  return joinedUltraHdr(*encodeJpeg(Image8(16, 8, 3, 128), {{"envmap", "latlong"}}),
                        *encodeJpeg(Image8(map_size.x, map_size.y, channels, 204), {}), kFourStops);
}

/// Its light: the picture's 0.2158605 by 3 stops.
constexpr float kEvenLight = (0.2158605f + 1.0f / 64.0f) * 8.0f - 1.0f / 64.0f;

/// Where those bytes stand in a file for the last time.
std::size_t lastOf(const Bytes& bytes, const Bytes& part) {
  const auto at = std::find_end(bytes.begin(), bytes.end(), part.begin(), part.end());
  EXPECT_NE(at, bytes.end());
  return static_cast<std::size_t>(at - bytes.begin());
}

/// Where the picture's JPEG ends.
std::size_t endOfPicture(const Bytes& bytes) { return lastOf(bytes, {0xff, 0xd8, 0xff}); }

/// With its ISO 21496-1 metadata under a name that says nothing.
Bytes withoutIso(Bytes bytes) {
  for (int i = 0; i < 2; ++i) bytes[lastOf(bytes, bytesOf(std::string(kIsoGainMapName)))] = 'U';
  return bytes;
}

void expectEvenLight(const Bytes& bytes) {
  const auto decoded = decodeJpeg(bytes);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->gain_map, GainMapUse::applied);
  ASSERT_EQ(decoded->image.width(), 16);
  ASSERT_EQ(decoded->image.channels(), 3);
  EXPECT_THAT(decoded->image.samples(), Each(AllOf(Ge(kEvenLight * 0.99f), Le(kEvenLight * 1.01f))));
}

TEST(UltraHdr, APictureInP3HasItsGainsThereAndIsConverted) {
  Image8 green(16, 8, 3, 0);
  for (int i = 0; i < 128; ++i) green.texel(i % 16, i / 16)[1] = 200;
  const Bytes plain = *encodeJpeg(green, {});
  const Bytes map = *encodeJpeg(Image8(8, 4, 3, 204), {});
  const glm::vec3 light = rgbAt(decodeJpeg(joinedUltraHdr(plain, map, kFourStops))->image, 5, 5);
  const Bytes in_p3 = joinedUltraHdr(testing::jpegWithProfile(plain, testing::iccDisplayP3()), map, kFourStops);
  const auto decoded = decodeJpeg(in_p3);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->gain_map, GainMapUse::applied);
  EXPECT_EQ(decoded->color, "sRGB, primaries of the file (Display P3): converted");
  const glm::vec3 expected = *rec709FromPrimaries(kDisplayP3) * light;
  EXPECT_LT(expected.x, 0.0f) << "beyond Rec.709";
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgbAt(decoded->image, 5, 5)[c], expected[c], 2e-3f * light.y);
}

TEST(UltraHdr, IsReadAsLight) {
  expectEvenLight(evenUltraHdr());
  expectEvenLight(evenUltraHdr(1));
  expectEvenLight(evenUltraHdr(1, {1, 1}));
  const auto decoded = decodeJpeg(evenUltraHdr());
  EXPECT_EQ(decoded->format, "JPEG, 8 bit, gain map of 8x4");
  EXPECT_EQ(decoded->metadata, (Metadata{{"envmap", "latlong"}}));
}

TEST(UltraHdr, EitherMetadataSuffice) {
  expectEvenLight(withoutIso(evenUltraHdr()));
  Bytes iso = evenUltraHdr();
  for (int i = 0; i < 2; ++i) iso[lastOf(iso, bytesOf(std::string(kXmpName)))] = 'H';
  expectEvenLight(iso);
}

TEST(UltraHdr, ATextureIsThePictureAlone) {
  const auto texture = decodeTexture(evenUltraHdr());
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->samples()[0], 128);
}

TEST(UltraHdr, AnotherPictureMayStandBetween) {
  Bytes bytes = evenUltraHdr();
  const Bytes preview = *encodeJpeg(Image8(2, 2, 3, 9), {});
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(endOfPicture(bytes)), preview.begin(), preview.end());
  expectEvenLight(bytes);
}

TEST(UltraHdr, ItsIndexSaysWhereTheMapIs) {
  const Bytes bytes = evenUltraHdr();
  const std::size_t index = lastOf(bytes, bytesOf(std::string("MPF\0", 4))) + 4;
  const auto number = [&](std::size_t at) { return bigU32(bytes.data() + index + at); };
  const std::size_t end = endOfPicture(bytes);
  EXPECT_EQ(end, endOfJpeg(bytes));
  EXPECT_EQ(number(54), end);                 // the picture's bytes
  EXPECT_EQ(number(58), 0u);                  // where it begins
  EXPECT_EQ(number(70), bytes.size() - end);  // the map's bytes
  EXPECT_EQ(number(74) + index, end);         // where it begins, from the index on
}

TEST(UltraHdr, WrongOffsetsMisleadNobody) {
  Bytes bytes = evenUltraHdr();
  const std::size_t index = lastOf(bytes, bytesOf(std::string("MPF\0", 4))) + 4;
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(index), 82, std::uint8_t{0xff});
  const std::size_t length = lastOf(bytes, bytesOf("Item:Length=\"")) + 13;
  bytes[length] = '9';
  expectEvenLight(bytes);
}

TEST(UltraHdr, WhereTheMapIsGoneThePictureIsRead) {
  Bytes bytes = evenUltraHdr();
  bytes.resize(endOfPicture(bytes));
  const auto decoded = decodeJpeg(bytes);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_EQ(decoded->gain_map, GainMapUse::lost);
  EXPECT_EQ(decoded->format, "JPEG, 8 bit, its gain map lost");
  EXPECT_NEAR(decoded->image.samples()[0], 0.2158605f, 1e-5f);
}

// Whatever is left of such a file gives its light, or the picture with a remark.
TEST(UltraHdr, WhereTheMapEndsEarlyThePictureIsRead) {
  const Bytes bytes = evenUltraHdr();
  for (std::size_t length = 0; length + 2 < bytes.size(); ++length) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    const auto decoded = decodeJpeg(part);
    if (!decoded) {
      EXPECT_LT(length, endOfPicture(bytes));
      EXPECT_EQ(decoded.error().message.find('\n'), std::string::npos);
      continue;
    }
    EXPECT_NE(decoded->gain_map, GainMapUse::applied) << length;
    EXPECT_TRUE(decoded->gain_map == GainMapUse::lost || !decoded->oddities.empty()) << length;
  }
  Bytes cut = bytes;
  cut.resize(bytes.size() - 20);
  const auto decoded = decodeJpeg(cut);
  ASSERT_TRUE(decoded) << decoded.error().message;
  EXPECT_THAT(decoded->oddities,
              ::testing::ElementsAre(HasSubstr("is read without its gain map: it has a gain map that")));
  EXPECT_NEAR(decoded->image.samples()[0], 0.2158605f, 1e-5f);
}

TEST(UltraHdr, WhereTheNumbersAreDamagedThePictureIsRead) {
  Bytes bytes = withoutIso(evenUltraHdr());
  const std::size_t max = lastOf(bytes, bytesOf("GainMapMax=\"4\"")) + 12;
  for (const char letter : {'x', ' ', '"'}) {
    bytes[max] = static_cast<std::uint8_t>(letter);
    const auto decoded = decodeJpeg(bytes);
    ASSERT_TRUE(decoded) << decoded.error().message;
    EXPECT_EQ(decoded->gain_map, GainMapUse::none);
    EXPECT_THAT(decoded->oddities, ::testing::ElementsAre(HasSubstr("it has a damaged gain map: its GainMapMax")));
    EXPECT_NEAR(decoded->image.samples()[0], 0.2158605f, 1e-5f);
  }
}

// A phone held upside down: the map is turned with the picture.
TEST(UltraHdr, IsUpright) {
  const Image8 picture = pictureFromLinear(testing::gradient(16, 8, 3), 3);
  const Image light = testing::gradient(16, 8, 3);
  const Bytes stored = *encodeJpegWithGainMap(picture, light, {});
  const auto plain = decodeJpeg(stored);
  const auto turned = decodeJpeg(testing::withExif(stored, {.orientation = 6}));
  ASSERT_TRUE(plain && turned);
  EXPECT_EQ(turned->gain_map, GainMapUse::applied);
  const Image expected = upright(Image(plain->image), 6);
  ASSERT_EQ(turned->image.width(), 8);
  for (std::size_t i = 0; i < expected.samples().size(); ++i)
    ASSERT_NEAR(turned->image.samples()[i], expected.samples()[i], 1e-5f);
}

TEST(UltraHdr, RandomBytesAreSurvived) {
  const Bytes bytes = evenUltraHdr();
  std::mt19937 random(20260901);
  for (int variant = 0; variant < 3000; ++variant) {
    Bytes damaged = bytes;
    for (int count = 0; count < 4; ++count) damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    const auto decoded = decodeJpeg(damaged);
    if (!decoded) continue;
    for (const float sample : decoded->image.samples()) ASSERT_TRUE(std::isfinite(sample) && sample >= 0.0f);
  }
}

/// A sky from dark to bright, and a sun of one texel.
Image skyWithSun(float sun) {
  Image sky(64, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const float light = 0.05f * std::exp2(static_cast<float>(y) / 5.0f);
      const glm::vec3 color = light * glm::vec3(0.6f, 0.8f, 1.0f + 0.01f * static_cast<float>(x));
      std::copy_n(&color.x, 3, sky.texel(x, y));
    }
  std::fill_n(sky.texel(20, 12), 3, sun);
  return sky;
}

TEST(UltraHdr, WhatIsWrittenIsReadAsItsLight) {
  for (const float sun : {1.0f, 50.0f, 6e4f, 1e6f}) {
    const Image light = skyWithSun(sun);
    const auto bytes = encodeJpegWithGainMap(pictureFromLinear(light, 3), light, {{"envmap", "latlong"}});
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto back = decodeJpeg(*bytes);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->gain_map, GainMapUse::applied);
    EXPECT_EQ(back->metadata, (Metadata{{"envmap", "latlong"}}));
    EXPECT_NEAR(back->image.texel(20, 12)[1] / sun, 1.0f, 0.1f) << sun;
    // Far from the sun, whose block of 8 x 8 texels a JPEG blurs.
    double sum = 0.0;
    for (int y = 16; y < 32; ++y)
      for (int x = 32; x < 64; ++x) sum += std::abs(back->image.texel(x, y)[1] / light.texel(x, y)[1] - 1.0f);
    EXPECT_LT(sum / (16 * 32), 0.02) << sun;
  }
}

TEST(UltraHdr, OneTexelIsWritten) {
  const auto bytes = encodeJpegWithGainMap(Image8(1, 1, 3, 255), Image(1, 1, 3, 1e5f), {});
  ASSERT_TRUE(bytes);
  EXPECT_NEAR(decodeJpeg(*bytes)->image.samples()[0], 1e5f, 1e3f);
}

TEST(JpegSegments, AreReadWithinTheirBytes) {
  const Bytes bytes = evenUltraHdr();
  const JpegHeader header = jpegHeader(bytes);
  EXPECT_GT(header.segments.size(), 6u);
  EXPECT_LT(header.end, endOfJpeg(bytes));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_LE(jpegHeader(part).end, length);
    EXPECT_LE(endOfJpeg(part), length);
  }
}

}  // namespace
}  // namespace mirrorball
