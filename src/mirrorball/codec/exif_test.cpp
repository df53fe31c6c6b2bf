#include "mirrorball/codec/exif.h"

#include <gtest/gtest.h>

#include "mirrorball/codec/exif_testing.h"
#include "mirrorball/codec/ldr/jpeg.h"

namespace mirrorball {
namespace {

using testing::exifBlock;
using testing::withExif;

Bytes plainJpeg() { return *encodeJpeg(Image8(8, 8, 3, 128), {}); }

constexpr Exif kAll{.exposure_time_s = 0.004,
                    .f_number = 5.6,
                    .iso = 200.0,
                    .focal_length_35mm = 50.0,
                    .image_direction_deg = 123.25,
                    .is_direction_magnetic = true,
                    .orientation = 6};

void expectAll(const Exif& read) {
  EXPECT_NEAR(read.exposure_time_s.value(), 0.004, 1e-9);
  EXPECT_NEAR(read.f_number.value(), 5.6, 1e-9);
  EXPECT_EQ(read.iso, 200.0);
  EXPECT_EQ(read.focal_length_35mm, 50.0);
  EXPECT_EQ(read.image_direction_deg, 123.25);
  EXPECT_TRUE(read.is_direction_magnetic);
  EXPECT_EQ(read.orientation, 6);
}

void expectNone(const Exif& read) {
  EXPECT_FALSE(read.exposure_time_s || read.f_number || read.iso || read.focal_length_35mm ||
               read.image_direction_deg || read.is_direction_magnetic);
  EXPECT_EQ(read.orientation, 1);
}

TEST(Exif, IsReadInEitherByteOrder) {
  for (const ExifByteOrder order : {EXIF_BYTE_ORDER_INTEL, EXIF_BYTE_ORDER_MOTOROLA}) {
    const Bytes block = exifBlock(kAll, order);
    expectAll(readExif(block));
    expectAll(readExif(std::span(block).subspan(6)));  // without "Exif"
  }
  expectAll(readJpegExif(withExif(plainJpeg(), kAll)));
}

TEST(Exif, WithoutItNothingIsKnown) {
  expectNone(readExif({}));
  expectNone(readJpegExif(plainJpeg()));
  expectNone(readJpegExif(exifBlock(kAll)));  // no JPEG
}

TEST(Exif, ZeroIsNoValue) {
  expectNone(readExif(exifBlock({.exposure_time_s = 0.0, .iso = 0.0, .focal_length_35mm = 0.0, .orientation = 0})));
  EXPECT_EQ(readExif(exifBlock({.orientation = 9})).orientation, 1);
}

TEST(Exif, DamageIsNoReasonToStop) {
  const Bytes block = exifBlock(kAll);
  for (std::size_t at = 0; at < block.size(); ++at) {
    for (const std::uint8_t change : {std::uint8_t{0xa5}, std::uint8_t{0xff}}) {
      Bytes damaged = block;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ change);
      const Exif read = readExif(damaged);
      EXPECT_TRUE(!read.exposure_time_s || *read.exposure_time_s > 0.0);
      EXPECT_TRUE(read.orientation >= 1 && read.orientation <= 8);
    }
    const Bytes part(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(at));
    readExif(part);
  }
}

}  // namespace
}  // namespace mirrorball
