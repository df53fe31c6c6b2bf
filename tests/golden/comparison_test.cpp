// The comparison of golden_test can fail: with pictures made here, and with golden ones that are altered.

#include "golden/comparison.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "golden/cases.h"
#include "golden/golden_picture.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball::golden {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const Tolerance kNoDifference{0, 0, "the same pixels"};

Image8 greyPicture(int width, int height) {
  Image8 picture(width, height, 4, 100);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.texel(x, y)[3] = 255;
  return picture;
}

TEST(Difference, EqualPicturesHaveNone) {
  const Difference difference = differenceOf(greyPicture(5, 4), greyPicture(5, 4));
  EXPECT_EQ(difference.maximum, 0.0);
  EXPECT_EQ(difference.mean, 0.0);
  EXPECT_TRUE(isWithin(difference, kNoDifference));
}

TEST(Difference, MaximumIsTheWorstChannelOfTheWorstPixel) {
  Image8 now = greyPicture(5, 4);
  now.texel(3, 2)[0] = 110;
  now.texel(3, 2)[1] = 60;
  now.texel(0, 1)[2] = 105;
  const Difference difference = differenceOf(greyPicture(5, 4), now);
  EXPECT_EQ(difference.maximum, 40.0);
  EXPECT_EQ(difference.worst, glm::ivec2(3, 2));
  EXPECT_DOUBLE_EQ(difference.mean, (40.0 + 5.0) / 20.0);
}

TEST(Difference, EitherNumberAloneRefuses) {
  const Difference difference{.maximum = 40.0, .mean = 2.0, .worst = {}};
  EXPECT_TRUE(isWithin(difference, {40, 2, ""}));
  EXPECT_FALSE(isWithin(difference, {39, 2, ""}));
  EXPECT_FALSE(isWithin(difference, {40, 1.9, ""}));
}

TEST(Difference, ColourCountsByItsCoverage) {
  Image8 golden = greyPicture(1, 1);
  Image8 now = greyPicture(1, 1);
  golden.texel(0, 0)[3] = now.texel(0, 0)[3] = 0;
  now.texel(0, 0)[0] = 255;
  EXPECT_EQ(differenceOf(golden, now).maximum, 0.0);
  now.texel(0, 0)[3] = 51;  // a fifth of red 255
  EXPECT_EQ(differenceOf(golden, now).maximum, 51.0);
}

/// A folder for contact sheets of failures that are meant, apart from those that are not.
class MeantFailure : public ::testing::Test {
 protected:
  void SetUp() override {
    if (isUpdating()) GTEST_SKIP() << "the golden pictures are being made";
  }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ = ::testing::TempDir() + "mirrorball_meant_failures_" + std::to_string(::getpid());
};

TEST_F(MeantFailure, MissingGoldenPictureFails) {
  const auto verdict = matchesGolden(goldenPath("no_such_picture"), greyPicture(4, 4), {255, 255, "anything"}, folder_);
  EXPECT_FALSE(verdict);
  EXPECT_THAT(verdict.message(), HasSubstr("pictures/no_such_picture.png: there is no golden picture"));
  EXPECT_THAT(verdict.message(), HasSubstr((folder_ / "no_such_picture.png").string()));
  EXPECT_TRUE(fs::exists(folder_ / "no_such_picture.png"));
}

TEST_F(MeantFailure, OtherSizeFails) {
  const auto verdict = matchesGolden(goldenPath("mirror"), greyPicture(4, 4), {255, 255, "anything"}, folder_);
  EXPECT_FALSE(verdict);
  EXPECT_THAT(verdict.message(), HasSubstr("is 4x4, its golden picture 96x96"));
}

TEST_F(MeantFailure, LeavesAContactSheetUntilThePictureIsRight) {
  const Result<Image8> golden = readGolden(goldenPath("mirror"));
  ASSERT_TRUE(golden) << golden.error().message;
  Image8 now = *golden;
  std::uint8_t& red = now.texel(20, 30)[0];
  const int red_difference = red < 128 ? 10 : -10;
  red = static_cast<std::uint8_t>(red + red_difference);

  const auto verdict = matchesGolden(goldenPath("mirror"), now, kNoDifference, folder_);
  EXPECT_FALSE(verdict);
  EXPECT_THAT(verdict.message(), HasSubstr("by 10 at (20, 30), "));
  EXPECT_THAT(verdict.message(), HasSubstr("allowed: 0, 0 in the mean (the same pixels)"));
  EXPECT_THAT(verdict.message(), HasSubstr((folder_ / "mirror.png").string()));

  const auto bytes = readFile(folder_ / "mirror.png");
  ASSERT_TRUE(bytes) << bytes.error().message;
  const auto sheet = decodeTexture(*bytes);
  ASSERT_TRUE(sheet) << sheet.error().message;
  const int gap = 4;
  EXPECT_EQ(sheet->width(), 3 * golden->width() + 2 * gap);
  EXPECT_EQ(sheet->height(), golden->height());
  const int second = golden->width() + gap;
  EXPECT_EQ(sheet->texel(second + 20, 30)[0] - sheet->texel(20, 30)[0], red_difference);
  EXPECT_EQ(sheet->texel(2 * second + 20, 30)[0], 80);
  EXPECT_EQ(sheet->texel(2 * second + 20, 30)[1], 0);
  EXPECT_EQ(sheet->texel(2 * second + 21, 30)[0], 0);

  EXPECT_TRUE(matchesGolden(goldenPath("mirror"), *golden, kNoDifference, folder_));
  EXPECT_FALSE(fs::exists(folder_ / "mirror.png"));
}

/// What could be wrong with a projection, done to its golden picture: the case must refuse it.
class WrongProjection : public MeantFailure {
 protected:
  template <typename Alter>
  void expectFound(const std::string& name, const Alter& alter) {
    const Result<Image8> golden = readGolden(goldenPath(name));
    ASSERT_TRUE(golden) << golden.error().message;
    Image8 wrong = *golden;
    alter(wrong);
    EXPECT_FALSE(isWithin(differenceOf(*golden, wrong), *caseNamed(name).tolerance)) << name;
  }
};

/// Mirrors a rectangle from left to right.
void mirror(Image8& picture, int left, int top, int width, int height) {
  for (int y = top; y < top + height; ++y)
    for (int x = 0; x < width / 2; ++x)
      std::swap_ranges(picture.texel(left + x, y), picture.texel(left + x, y) + 4,
                       picture.texel(left + width - 1 - x, y));
}

void darken(std::uint8_t& code, int by) { code = static_cast<std::uint8_t>(std::max(0, code - by)); }

TEST_F(WrongProjection, AnyMirroredFaceOfACubeIsFound) {
  const int face = 40;
  for (const glm::ivec2 place :
       {glm::ivec2(0, 1), glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(1, 2), glm::ivec2(2, 1), glm::ivec2(3, 1)})
    expectFound("convert_cross", [&](Image8& picture) { mirror(picture, place.x * face, place.y * face, face, face); });
}

TEST_F(WrongProjection, AMirroredPictureIsFound) {
  for (const char* name : {"convert_equirect", "convert_sphere", "convert_angular"})
    expectFound(name, [](Image8& picture) { mirror(picture, 0, 0, picture.width(), picture.height()); });
}

TEST_F(WrongProjection, AShiftByOneTexelIsFound) {
  for (const char* name : {"convert_equirect", "convert_sphere", "convert_angular", "convert_cross"}) {
    expectFound(name, [](Image8& picture) {
      for (int y = 0; y < picture.height(); ++y)
        std::rotate(picture.row(y).begin(), picture.row(y).begin() + picture.channels(), picture.row(y).end());
    });
  }
}

TEST_F(WrongProjection, AFaintSeamIsFound) {
  expectFound("convert_equirect", [](Image8& picture) {
    for (int y = 0; y < picture.height(); ++y) darken(picture.texel(0, y)[0], 2);
  });
}

}  // namespace
}  // namespace mirrorball::golden
