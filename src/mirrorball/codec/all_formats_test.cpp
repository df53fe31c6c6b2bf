// The formats beside each other, in a build that has them all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/written_format_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using ::testing::HasSubstr;

class AllFormats : public testing::FolderTest {};

TEST_F(AllFormats, LinearFormatsAreTold) {
  EXPECT_TRUE(storesLinearLight("a.exr"));
  EXPECT_TRUE(storesLinearLight("a.HDR"));
  EXPECT_FALSE(storesLinearLight("a.png"));
  EXPECT_FALSE(storesLinearLight("a"));
}

TEST_F(AllFormats, PicturesKeepTheirCodes) {
  Image8 picture(3, 2, 4, 77);
  ASSERT_TRUE(savePicture(folder_ / "a.png", picture, {{"mirrorball:projection", "sphere"}}));
  const auto bytes = readFile(folder_ / "a.png");
  ASSERT_TRUE(bytes);
  EXPECT_THAT(decodeTexture(*bytes)->samples(), ::testing::ElementsAreArray(picture.samples()));
  EXPECT_EQ(readImage(folder_ / "a.png")->metadata.at("mirrorball:projection"), "sphere");
  EXPECT_TRUE(savePicture(folder_ / "a.jpg", picture));
  EXPECT_EQ(savePicture(folder_ / "a.exr", picture).error().code, ErrorCode::usage);
}

TEST_F(AllFormats, ThoseOfTexturesAreNamed) {
  EXPECT_THAT(decodeTexture(bytesOf("GIFT")).error().message, HasSubstr("use PNG, JPEG"));
}

// Of heights and normals: no colour's curve, and all 16 bits.
TEST_F(AllFormats, NumbersAreSharesOfTheGreatestCode) {
  const auto numbers = decodeNumbers(bytesOf("P2 2 1 65535\n1 30000\n"));
  ASSERT_TRUE(numbers);
  EXPECT_EQ(numbers->picture.channels(), 1);
  EXPECT_EQ(numbers->picture.samples()[0], 1.0f / 65535.0f);
  EXPECT_EQ(numbers->picture.samples()[1], 30000.0f / 65535.0f);

  Image8 picture(2, 2, 3, 128);
  ASSERT_TRUE(savePicture(folder_ / "codes.png", picture));
  const auto codes = decodeNumbers(*readFile(folder_ / "codes.png"));
  ASSERT_TRUE(codes);
  EXPECT_EQ(codes->picture.channels(), 3);
  EXPECT_EQ(codes->picture.samples()[0], 128.0f / 255.0f);

  ASSERT_TRUE(writeImage(folder_ / "light.exr", Image(2, 2, 3, -2.5f)));
  EXPECT_EQ(decodeNumbers(*readFile(folder_ / "light.exr"))->picture.samples()[0], -2.5f);
  EXPECT_FALSE(decodeNumbers(bytesOf("no picture")));
}

}  // namespace
}  // namespace mirrorball
