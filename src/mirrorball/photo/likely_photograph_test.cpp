#include "mirrorball/photo/likely_photograph.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/environment/file/photo_sphere_testing.h"

namespace mirrorball {
namespace {

using testing::withExif;

Exif ofCamera() {
  Exif exif;
  exif.exposure_time_s = 0.01;
  return exif;
}
const Exif kOfCamera = ofCamera();

/// What is said of a .jpg of that size.
bool isLikely(int width, int height, const Exif* exif = nullptr) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "likely_photograph.jpg";
  const Bytes plain = *encodeJpeg(Image8(width, height, 3), {});
  EXPECT_TRUE(writeFile(path, exif ? withExif(plain, *exif) : plain));
  const auto likely = isLikelyPhotograph(path);
  EXPECT_TRUE(likely) << likely.error().message;
  return likely && *likely;
}

TEST(LikelyPhotograph, IsWhatHasTheShapeOfNoMap) {
  EXPECT_TRUE(isLikely(90, 70));
  EXPECT_FALSE(isLikely(64, 32)) << "a panorama";
  EXPECT_FALSE(isLikely(64, 64)) << "a sphere map";
  EXPECT_FALSE(isLikely(64, 48)) << "a cross";
}

TEST(LikelyPhotograph, IsWhatACameraHasMade) {
  EXPECT_TRUE(isLikely(64, 48, &kOfCamera));
  EXPECT_FALSE(isLikely(64, 32, &kOfCamera)) << "a camera for panoramas";
  Exif turned = kOfCamera;
  turned.orientation = 6;
  EXPECT_FALSE(isLikely(32, 64, &turned)) << "held upright";
  const Exif unknown{};
  EXPECT_FALSE(isLikely(64, 48, &unknown));
}

TEST(LikelyPhotograph, IsNothingThatSaysWhichMapItIs) {
  const std::string path = ::testing::TempDir() + "likely_photograph.hdr";
  ImageWriteOptions sheet;
  sheet.metadata = {{"mirrorball:sheet", "mip levels"}};
  ASSERT_TRUE(writeImage(path, Image(90, 70, 3), sheet));
  EXPECT_FALSE(*isLikelyPhotograph(path));
  ASSERT_TRUE(writeImage(path, Image(90, 70, 3)));
  EXPECT_TRUE(*isLikelyPhotograph(path));
  EXPECT_FALSE(isLikelyPhotograph("nowhere.jpg"));
  Bytes strip = withExif(*encodeJpeg(Image8(256, 64, 3), {}), kOfCamera);
  const std::string packet = testing::packetWith(testing::kHalfOfPanorama);
  strip.insert(strip.end(), packet.begin(), packet.end());
  ASSERT_TRUE(writeFile(path, strip));
  EXPECT_FALSE(*isLikelyPhotograph(path)) << "a Photo Sphere";
}

TEST(LikelyPhotograph, ReadsTheShapeOfOtherFormatsToo) {
  const std::string path = ::testing::TempDir() + "likely_photograph.png";
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::png));
  ASSERT_TRUE(savePicture(path, Image8(90, 70, 3)));
  EXPECT_TRUE(*isLikelyPhotograph(path));
  ASSERT_TRUE(savePicture(path, Image8(64, 48, 3)));
  EXPECT_FALSE(*isLikelyPhotograph(path));
}

// A header may say anything.
TEST(LikelyPhotograph, EveryCutOfAFileIsReadOrRefused) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "cut_photograph.jpg";
  const Bytes whole = withExif(*encodeJpeg(Image8(90, 70, 3), {}), kOfCamera);
  for (std::size_t size = 0; size < whole.size(); size += 31) {
    ASSERT_TRUE(writeFile(path, std::span(whole).first(size)));
    (void)isLikelyPhotograph(path);
  }
}

}  // namespace
}  // namespace mirrorball
