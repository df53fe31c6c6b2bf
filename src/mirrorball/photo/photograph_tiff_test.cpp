#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mirrorball
