#include "mirrorball/scene/picture_decoding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/picture_testing.h"

namespace mirrorball {
namespace {

// One file as colours and as numbers: the former are converted; the remark names the place in the list.
TEST(PictureDecoding, ColoursAreConvertedWithARemark) {
  const Bytes grey{128, 128, 128, 0}, orange{60, 120, 200, 0};  // blue first, padded
  const testing::BmpForm plain{.width = 1, .height = 1};
  const testing::BmpForm p3{.header = 124, .width = 1, .height = 1, .profile = testing::iccDisplayP3()};
  const Bytes first = testing::bmpFile(plain, grey), second = testing::bmpFile(p3, orange);
  const std::vector<EncodedPicture> pictures{
      {first, ReadAs::light}, {second, ReadAs::light}, {second, ReadAs::numbers}};
  MemoryBudget budget;
  std::vector<std::string> remarks;
  const auto decoded = decodePictures(pictures, budget, {}, [&](std::size_t picture, const std::string& oddity) {
    remarks.push_back(std::to_string(picture) + " " + oddity);
  });
  ASSERT_TRUE(decoded[0] && decoded[1] && decoded[2]);
  const auto codes = [&](std::size_t i) {
    const Image8& image = std::get<Image8>(decoded[i]->picture);
    return std::vector<int>(image.samples().begin(), image.samples().end());
  };
  EXPECT_THAT(codes(0), ::testing::ElementsAre(128, 128, 128, 255));
  // Display P3's (200, 120, 60) by the matrix of the two primaries.
  EXPECT_THAT(codes(1), ::testing::ElementsAre(213, 115, 42, 255));
  EXPECT_THAT(codes(2), ::testing::ElementsAre(200, 120, 60, 255));
  EXPECT_TRUE(!decoded[0]->is_converted && decoded[1]->is_converted && !decoded[2]->is_converted);
  EXPECT_THAT(remarks, ::testing::ElementsAre("1 its colours are not sRGB's: sRGB, primaries of the file (Display P3): "
                                              "converted",
                                              "2 states a colour space (sRGB, Display P3), which does not count for "
                                              "numbers: they are read as they are stored"));
}

}  // namespace
}  // namespace mirrorball
