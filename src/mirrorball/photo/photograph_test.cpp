#include "mirrorball/photo/photograph.h"

#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/left_out_testing.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::withExif;

/// A folder of its own for each test, since tests run at the same time.
class PhotographTest : public ::testing::Test {
 protected:
  PhotographTest() {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("photograph_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  ~PhotographTest() override { fs::remove_all(folder_); }

  fs::path write(const char* name, const Bytes& bytes) const {
    EXPECT_TRUE(writeFile(folder_ / name, bytes));
    return folder_ / name;
  }

  fs::path folder_;
};

/// 32 × 16, black but for its top left quarter, which is white.
Image8 marked() {
  Image8 picture(32, 16, 3);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) std::fill_n(picture.texel(x, y), 3, std::uint8_t{255});
  return picture;
}
Bytes jpegOf(const Image8& picture) { return *encodeJpeg(picture, {}); }

// Where the white quarter of the stored picture is shown, by the table of tag 274.
TEST_F(PhotographTest, OrientationIsApplied) {
  struct Row {
    int orientation;
    bool right, below, exchanged;
  };
  for (const Row row :
       {Row{1, false, false, false}, Row{2, true, false, false}, Row{3, true, true, false}, Row{4, false, true, false},
        Row{5, false, false, true}, Row{6, true, false, true}, Row{7, true, true, true}, Row{8, false, true, true}}) {
    SCOPED_TRACE(row.orientation);
    const auto path = write("turned.jpg", withExif(jpegOf(marked()), {.exposure_time_s = {},
                                                                      .f_number = {},
                                                                      .iso = {},
                                                                      .focal_length_35mm = {},
                                                                      .orientation = row.orientation}));
    const auto photograph = readPhotograph(path);
    ASSERT_TRUE(photograph);
    EXPECT_EQ(photograph->width(), row.exchanged ? 16 : 32);
    EXPECT_EQ(photograph->height(), row.exchanged ? 32 : 16);
    for (const bool right : {false, true})
      for (const bool below : {false, true}) {
        const int x = photograph->width() * (right ? 3 : 1) / 4, y = photograph->height() * (below ? 3 : 1) / 4;
        EXPECT_EQ(*photograph->codes.texel(x, y) > 128, right == row.right && below == row.below);
      }
  }
}

TEST_F(PhotographTest, ExposuresCountTimeApertureAndSensitivity) {
  Photograph first, second;
  first.exif = {.exposure_time_s = 0.01, .f_number = 4.0, .iso = 100.0, .focal_length_35mm = {}, .orientation = 1};
  second.exif = {.exposure_time_s = 0.02, .f_number = 8.0, .iso = 400.0, .focal_length_35mm = {}, .orientation = 1};
  const std::vector both{first, second};
  auto exposures = exposuresFromExif(both);
  // Twice the time, a quarter of the aperture's area, four times the sensitivity.
  EXPECT_NEAR((*exposures)[1] / (*exposures)[0], 2.0, 1e-12);
  const auto without = [&](auto member) {
    std::vector changed = both;
    (changed[1].exif.*member).reset();
    return changed;
  };
  exposures = exposuresFromExif(without(&Exif::f_number));
  EXPECT_NEAR((*exposures)[1] / (*exposures)[0], 8.0, 1e-12);
  std::vector unknown = without(&Exif::exposure_time_s);
  unknown[1].name = "b.jpg";
  const auto failed = exposuresFromExif(unknown);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::usage);
  EXPECT_THAT(failed.error().message, HasSubstr("b.jpg"));
  EXPECT_EQ(failed.error().fix_hint, FixHint::give_exposures);
}

TEST_F(PhotographTest, FocalLengthOfTheFullFrame) {
  // 50 mm on 36 × 24 mm: a vertical field of view of 27.0°, whatever the pixels.
  const double focal = focalLengthFromExif(
      {.exposure_time_s = {}, .f_number = {}, .iso = {}, .focal_length_35mm = 50.0, .orientation = 1}, 6000, 4000);
  EXPECT_NEAR(glm::degrees(2.0 * std::atan(2000.0 / focal)), 26.99, 0.01);
  EXPECT_EQ(focalLengthFromExif({}, 6000, 4000), 0.0);
}

TEST_F(PhotographTest, LinearFilesAreLight) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  const Image light(4, 3, 3, 7.5f);
  ASSERT_TRUE(writeImage(folder_ / "a.exr", light));
  const auto photograph = readPhotograph(folder_ / "a.exr");
  ASSERT_TRUE(photograph);
  EXPECT_TRUE(photograph->codes.empty());
  EXPECT_EQ(*photograph->light.texel(2, 1), 7.5f);
  EXPECT_EQ(readPhotograph(folder_ / "none.jpg").error().code, ErrorCode::not_found);
  EXPECT_EQ(readPhotograph(write("x.jpg", {1, 2, 3})).error().code, ErrorCode::bad_file);
}

TEST_F(PhotographTest, LinearCodesHaveTheFilesChannels) {
  const Bytes profile = testing::iccMatrixProfile(
      "Linear", {{{0.51512, 0.24120, -0.00105}, {0.29198, 0.69225, 0.04189}, {0.15710, 0.06657, 0.78407}}},
      testing::iccValue("para", {1.0}, {0}));
  const auto photograph = readPhotograph(write(
      "linear.jpg", withExif(testing::jpegWithProfile(*encodeJpeg(marked(), {}), profile), {.exposure_time_s = 0.5})));
  ASSERT_TRUE(photograph) << photograph.error().message;
  EXPECT_TRUE(photograph->codes.empty());
  EXPECT_TRUE(photograph->is_clipped_at_1);
  EXPECT_EQ(photograph->light.channels(), 3);
  EXPECT_EQ(photograph->color.transfer, Transfer::linear);
  EXPECT_EQ(photograph->exif.exposure_time_s, 0.5);
}

TEST_F(PhotographTest, PrimariesAndOdditiesAreKept) {
  const Bytes p3 = testing::jpegWithProfile(jpegOf(marked()), testing::iccDisplayP3());
  const auto photograph = readPhotograph(write("p3.jpg", withExif(p3, {.orientation = 3})));
  ASSERT_TRUE(photograph) << photograph.error().message;
  ASSERT_TRUE(photograph->color.primaries);
  EXPECT_NEAR(photograph->color.primaries->green.y, 0.690, 1e-4);
  EXPECT_GT(*photograph->codes.texel(31, 15), 128) << "codes as the camera made them, upright";
  EXPECT_THAT(photograph->oddities, ::testing::ElementsAre(HasSubstr("turned upright"), HasSubstr("Display P3")));
}

}  // namespace
}  // namespace mirrorball
