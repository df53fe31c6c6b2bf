#include "mirrorball/codec/ldr/tga.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/picture_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using testing::tgaFile;

/// The codes of a picture, RGBA.
std::vector<int> codesOfTga(const Bytes& bytes) {
  const auto texture = decodeTexture(bytes);
  EXPECT_TRUE(texture) << texture.error().message;
  return texture ? std::vector<int>(texture->samples().begin(), texture->samples().end()) : std::vector<int>();
}

int decodedChannels(const Bytes& bytes) {
  const auto image = decodeImage(bytes);
  EXPECT_TRUE(image) << image.error().message;
  return image ? image->image.channels() : 0;
}

Error refusedTga(const Bytes& bytes) {
  const auto result = decodeTga(bytes);
  EXPECT_FALSE(result);
  return result ? Error() : result.error();
}

TEST(Tga, ColorsAreStoredBlueFirst) {
  const Bytes file = tgaFile({.width = 1, .height = 1, .id = "a name"}, {3, 2, 1});
  EXPECT_THAT(codesOfTga(file), ElementsAre(1, 2, 3, 255));
  const auto image = decodeImage(file);
  EXPECT_EQ(image->format, "TGA, 24 bit");
  EXPECT_EQ(image->color, "sRGB");
  EXPECT_EQ(image->image.channels(), 3);
}

TEST(Tga, EveryCornerMayBeTheFirst) {
  const Bytes grey{1, 2, 3, 4};
  const auto from = [&](std::uint8_t descriptor) {
    const auto image =
        decodeTexture(tgaFile({.type = 3, .width = 2, .height = 2, .bits = 8, .descriptor = descriptor}, grey));
    std::vector<int> reds;
    for (std::size_t i = 0; i < 16; i += 4) reds.push_back(image->samples()[i]);
    return reds;
  };
  EXPECT_THAT(from(0x20), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(from(0x00), ElementsAre(3, 4, 1, 2));
  EXPECT_THAT(from(0x30), ElementsAre(2, 1, 4, 3));
  EXPECT_THAT(from(0x10), ElementsAre(4, 3, 2, 1));
}

TEST(Tga, FiveBitsAreSharesOfTheirRange) {
  // ARRRRRGGGGGBBBBB with red 31, green 1, blue 16.
  const Bytes texel{0x30, 0x7c};
  EXPECT_THAT(codesOfTga(tgaFile({.width = 1, .height = 1, .bits = 15}, texel)), ElementsAre(255, 8, 132, 255));
  EXPECT_THAT(codesOfTga(tgaFile({.width = 2, .height = 1, .bits = 16, .descriptor = 0x21}, {0x30, 0x7c, 0x30, 0xfc})),
              ElementsAre(255, 8, 132, 0, 255, 8, 132, 255));
}

TEST(Tga, AlphaIsWhatTheFileSaysIsAlpha) {
  const Bytes texels{3, 2, 1, 128, 3, 2, 1, 0};
  EXPECT_THAT(codesOfTga(tgaFile({.width = 2, .height = 1, .bits = 32, .descriptor = 0x28}, texels)),
              ElementsAre(1, 2, 3, 128, 1, 2, 3, 0));
  const Bytes unsaid = tgaFile({.width = 2, .height = 1, .bits = 32}, texels);
  EXPECT_EQ(decodedChannels(unsaid), 3);
  EXPECT_EQ(decodedChannels(testing::withTgaFooter(unsaid, 3)), 4);
  EXPECT_EQ(decodedChannels(
                testing::withTgaFooter(tgaFile({.width = 2, .height = 1, .bits = 32, .descriptor = 0x28}, texels), 0)),
            3);
  // Premultiplied: 64 of 128 is 128 of 255.
  EXPECT_THAT(codesOfTga(testing::withTgaFooter(tgaFile({.width = 1, .height = 1, .bits = 32}, {64, 64, 64, 128}), 4)),
              ElementsAre(128, 128, 128, 128));
  // All of it 0 is none.
  EXPECT_THAT(codesOfTga(tgaFile({.width = 1, .height = 1, .bits = 32, .descriptor = 0x28}, {3, 2, 1, 0})),
              ElementsAre(1, 2, 3, 255));
}

TEST(Tga, GreyStaysOneChannelUnlessItHasAlpha) {
  EXPECT_EQ(decodedChannels(tgaFile({.type = 3, .width = 1, .height = 1, .bits = 8}, {7})), 1);
  EXPECT_THAT(codesOfTga(tgaFile({.type = 3, .width = 1, .height = 1, .bits = 16}, {7, 99})), ElementsAre(7, 7, 7, 99));
}

TEST(Tga, PalettesAreLookedUp) {
  testing::TgaForm form{.type = 1, .width = 2, .height = 1, .bits = 8};
  form.palette_first = 5;
  form.palette_length = 2;
  form.palette_bits = 24;
  EXPECT_THAT(codesOfTga(tgaFile(form, {3, 2, 1, 30, 20, 10, 6, 5})), ElementsAre(10, 20, 30, 255, 1, 2, 3, 255));
  EXPECT_EQ(decodeImage(tgaFile(form, {3, 2, 1, 30, 20, 10, 6, 5}))->format, "TGA, 8 bit palette");
  EXPECT_THAT(refusedTga(tgaFile(form, {3, 2, 1, 30, 20, 10, 6, 7})).message, HasSubstr("texel (1, 0)"));
  EXPECT_THAT(refusedTga(tgaFile(form, {3, 2, 1, 30, 20, 10, 6, 4})).message, HasSubstr("texel (1, 0)"));
  form.bits = 16;
  EXPECT_THAT(codesOfTga(tgaFile(form, {3, 2, 1, 30, 20, 10, 6, 0, 5, 0})), ElementsAre(10, 20, 30, 255, 1, 2, 3, 255));
}

TEST(Tga, RunsMayGoOnInTheNextRow) {
  const testing::TgaForm form{.type = 11, .width = 3, .height = 2, .bits = 8};
  const auto image = decodeImage(tgaFile(form, {129, 9, 2, 1, 2, 3, 0, 4}));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->format, "TGA, 8 bit, RLE");
  const std::vector<int> all = codesOfTga(tgaFile(form, {129, 9, 2, 1, 2, 3, 0, 4}));
  std::vector<int> reds;
  for (std::size_t i = 0; i < all.size(); i += 4) reds.push_back(all[i]);
  EXPECT_THAT(reds, ElementsAre(9, 9, 1, 2, 3, 4));
  EXPECT_THAT(refusedTga(tgaFile(form, {129, 9, 2, 1})).message, HasSubstr("ends at byte 22"));
}

TEST(Tga, IsToldByItsFooterOrByAPlausibleHeader) {
  const Bytes file = tgaFile({}, Bytes(18));
  EXPECT_TRUE(isTga(file));
  EXPECT_TRUE(isTga(testing::withTgaFooter(bytesOf("no header of a TGA"), 0)));
  EXPECT_EQ(refusedTga(testing::withTgaFooter(bytesOf("no header of a TGA"), 0)).code, ErrorCode::bad_file);
  EXPECT_FALSE(isTga(bytesOf("A text that is no picture")));
  EXPECT_FALSE(isTga(Bytes(100)));
  EXPECT_FALSE(isTga(Bytes(17)));
  for (const auto& [at, value] : {std::pair(1, 2), {2, 4}, {16, 20}, {17, 0x40}}) {
    Bytes other = file;
    other[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
    EXPECT_FALSE(isTga(other)) << at;
  }
  // A Windows icon begins with 0 0 1 0.
  Bytes icon = file;
  icon[2] = 1;
  EXPECT_FALSE(isTga(icon));
}

TEST(Tga, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  EXPECT_EQ(refusedTga(tgaFile({.width = 0}, Bytes(18))).code, ErrorCode::bad_file);
  EXPECT_THAT(refusedTga(tgaFile({.width = 60000, .height = 1000}, Bytes(18))).message, HasSubstr("cannot hold"));
  EXPECT_THAT(refusedTga(tgaFile({.type = 10, .width = 60000, .height = 1000}, Bytes(18))).message,
              HasSubstr("cannot hold"));
  EXPECT_EQ(refusedTga(tgaFile({.width = 65535, .height = 65535}, Bytes(18))).code, ErrorCode::too_large);
}

}  // namespace
}  // namespace mirrorball
