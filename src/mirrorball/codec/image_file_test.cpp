#include "mirrorball/codec/image_file.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/written_format_testing.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::bytesOf;
using testing::CodecFile;
using testing::CodecFormat;
using testing::gradient;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_P(CodecFormat, WhatIsWrittenIsRead) {
  const ImageWriteOptions options{.half = false, .metadata = {{"mirrorball:projection", "sphere"}}};
  for (const int channels : {1, 3, 4}) {
    Image image(16, 9, channels, 0.75f);
    ASSERT_TRUE(writeImage(path(), image, options));
    const auto back = readImage(path());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->metadata, options.metadata);
    EXPECT_EQ(back->image.width(), 16);
    EXPECT_EQ(back->image.height(), 9);
    EXPECT_EQ(back->image.channels() == 4, channels == 4 && GetParam().keeps_alpha);
    for (const float sample : back->image.samples()) ASSERT_NEAR(sample, 0.75f, GetParam().tolerance);
  }
}

TEST_P(CodecFormat, TheFilesNameStandsInFrontOfAnErrorOnce) {
  ASSERT_TRUE(writeImage(path(), gradient(16, 9, 3)));
  fs::resize_file(path(), 20);  // before any row: some formats are read as far as they go
  const auto truncated = readImage(path());
  ASSERT_FALSE(truncated);
  EXPECT_THAT(truncated.error().message, StartsWith(path().string() + ": "));
  EXPECT_EQ(truncated.error().message.rfind(path().string()), 0u) << truncated.error().message;
  EXPECT_EQ(writeImage(path(), Image(2, 2, 2)).error().message,
            path().string() + ": an image of 2 channels cannot be written; give it 1, 3 or 4");
}

TEST_P(CodecFormat, AnUnwritablePlaceIsAnErrorAndLeavesNothing) {
  const auto result = writeImage(folder_ / "none" / GetParam().name, Image(2, 2, 3));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::io);
  EXPECT_THAT(result.error().message, HasSubstr("none"));
  EXPECT_EQ(fileCount(), 0u);
}

TEST_P(CodecFormat, WhatNoImageIsCannotBeWritten) {
  EXPECT_EQ(writeImage(path(), Image()).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(writeImage(path(), Image(2, 2, 2)).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(fileCount(), 0u);
}

TEST_P(CodecFormat, NanIsWrittenWithoutHarm) {
  EXPECT_TRUE(writeImage(path(), Image(9, 9, 3, std::nanf(""))));
  EXPECT_TRUE(writeImage(path(), Image(9, 9, 3, std::numeric_limits<float>::infinity())));
}

INSTANTIATE_TEST_SUITE_P(Hdr, CodecFormat,
                         ::testing::Values(testing::WrittenFormat{"a.hdr", 0.0f, false},
                                           testing::WrittenFormat{"a.HDR", 0.0f, false}));

TEST_F(CodecFile, BytesTellTheFormatAndNotTheName) {
  ASSERT_TRUE(writeImage(folder_ / "a.hdr", gradient(4, 4, 3)));
  fs::rename(folder_ / "a.hdr", folder_ / "a.png");
  EXPECT_EQ(readImage(folder_ / "a.png")->format, "Radiance HDR, flat");
}

TEST_F(CodecFile, UnknownExtensionsListTheKnown) {
  for (const char* name : {"a.bmp", "a", "a.hdr.gz"}) {
    const auto result = writeImage(folder_ / name, Image(2, 2, 3));
    ASSERT_FALSE(result) << name;
    EXPECT_EQ(result.error().code, ErrorCode::usage);
    EXPECT_THAT(result.error().message,
                AllOf(HasSubstr(name), HasSubstr("; use " + writtenExtensions(Holds::light, " or "))));
    EXPECT_FALSE(checkWritable(name));
  }
  EXPECT_TRUE(checkWritable("b/a.HDR"));
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(CodecFile, ForeignMetadataIsRefused) {
  const auto write = [&](const char* key, const char* value) {
    return writeImage(folder_ / "a.hdr", Image(1, 1, 3), {.half = false, .metadata = {{key, value}}});
  };
  EXPECT_TRUE(write("mirrorball:projection", "sphere"));
  EXPECT_EQ(write("compression", "x").error().code, ErrorCode::usage);
  EXPECT_EQ(write("mirrorball:", "x").error().code, ErrorCode::usage);
  EXPECT_EQ(write("mirrorball:a=b", "x").error().code, ErrorCode::usage);
  EXPECT_EQ(write("mirrorball:projection", "two\nlines").error().code, ErrorCode::usage);
  EXPECT_EQ(write("envmap", "sphere").error().code, ErrorCode::usage);
}

TEST(Codec, ATextureOfOneFaceIsAPicture) {
  const ImageSet levels = testing::textureOf(2, 1, 1, 4, 4, 2);
  const auto image = decodeImage(testing::bytesOfTexture(writeKtx2, levels));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->image.samples(), ::testing::ElementsAreArray(levels.at(0, 0).samples()));
  const auto cube = decodeImage(testing::bytesOfTexture(writeDds, testing::textureOf(1, 6, 1, 3, 2, 2)));
  ASSERT_FALSE(cube);
  EXPECT_EQ(cube.error().code, ErrorCode::bad_shape);
}

TEST(Codec, WhatIsNoImageIsNamed) {
  EXPECT_THAT(decodeImage({}).error().message, HasSubstr("is empty"));
  EXPECT_THAT(decodeImage(bytesOf("GIFT")).error().message, AllOf(HasSubstr("47 49 46 54"), HasSubstr("Radiance HDR")));
  EXPECT_EQ(decodeImage(bytesOf("#")).error().code, ErrorCode::bad_file);
  EXPECT_THAT(decodeTexture(bytesOf("#?RADIANCE\n\n-Y 1 +X 1\n1234")).error().message,
              AllOf(HasSubstr("is Radiance HDR"), HasSubstr("BMP or PNM for textures")));
  EXPECT_EQ(readImage("no such file.hdr").error().code, ErrorCode::not_found);
}

#if GTEST_IS_THREADSAFE  // a browser has no such large files
// It has a hole, and takes no room on the disk. Were it read before it is looked at, it would not fit.
TEST(ImageFile, ALargeFileOfNothingIsNotRead) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "hole.hdr";
  ASSERT_TRUE(writeFile(path, {}));
  std::filesystem::resize_file(path, std::uintmax_t{3} << 30u);
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{64} << 20u);
  EXPECT_THAT(readImage(path).error().message, HasSubstr("hole.hdr: is not an image that can be read"));
  setMemoryLimit(usual);
  std::filesystem::remove(path);
}
#endif

// Which a footer tells, at its end.
TEST(ImageFile, ALargeTgaIsRead) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "large.tga";
  constexpr int kSide = 2400;
  const Bytes tga =
      testing::withTgaFooter(testing::tgaFile({.width = kSide, .height = kSide},
                                              std::vector<std::uint8_t>(std::size_t{3} * kSide * kSide, 90)),
                             0);
  ASSERT_TRUE(writeFile(path, tga));
  const auto image = readImage(path);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->image.width(), kSide);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace mirrorball
