#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/photo/photograph.h"

namespace mirrorball {
namespace {

TEST(PhotographTiff, IsCodesOrLight) {
  const auto write = [](const char* name, const Bytes& bytes) {
    const auto path = std::filesystem::path(::testing::TempDir()) / name;
    EXPECT_TRUE(writeFile(path, bytes));
    return path;
  };
  testing::TiffForm form{.width = 2, .height = 1, .orientation = 3};
  const auto codes = readPhotograph(write("codes.tif", testing::tiffFile(form, {1, 2, 3, 4, 5, 6})));
  ASSERT_TRUE(codes) << codes.error().message;
  EXPECT_THAT(codes->codes.samples(), ::testing::ElementsAre(4, 5, 6, 255, 1, 2, 3, 255));
  form.bits = 32;
  form.kind = SAMPLEFORMAT_IEEEFP;
  const auto light = readPhotograph(
      write("light.tif", testing::tiffFile(form, testing::bytesOfNumbers(std::vector<float>{1, 2, 3, 4, 5, 6}))));
  ASSERT_TRUE(light) << light.error().message;
  EXPECT_TRUE(light->codes.empty());
  EXPECT_THAT(light->light.samples(), ::testing::ElementsAre(4, 5, 6, 1, 2, 3));
}

// With all bits, in the file's primaries.
TEST(PhotographTiff, LinearCodesKeepTheirBits) {
  testing::TiffForm form{.width = 1, .height = 1, .bits = 16};
  form.profile = testing::iccMatrixProfile(
      "Linear P3", {{{0.51512, 0.24120, -0.00105}, {0.29198, 0.69225, 0.04189}, {0.15710, 0.06657, 0.78407}}},
      testing::iccValue("para", {1.0}, {0}));
  const auto path = std::filesystem::path(::testing::TempDir()) / "linear.tif";
  ASSERT_TRUE(
      writeFile(path, testing::tiffFile(form, testing::bytesOfNumbers(std::vector<std::uint16_t>{1, 300, 65535}))));
  const auto photograph = readPhotograph(path);
  ASSERT_TRUE(photograph) << photograph.error().message;
  EXPECT_TRUE(photograph->codes.empty());
  EXPECT_TRUE(photograph->is_clipped_at_1);
  EXPECT_EQ(photograph->color.transfer, Transfer::linear);
  EXPECT_NEAR(photograph->color.primaries->green.y, 0.690, 1e-3);
  EXPECT_THAT(photograph->light.samples(), ::testing::ElementsAre(1 / 65535.0f, 300 / 65535.0f, 1.0f));
  EXPECT_THAT(photograph->oddities, ::testing::ElementsAre("its colours are not sRGB's: linear, primaries of the file "
                                                           "(Display P3): converted"));
}

}  // namespace
}  // namespace mirrorball
