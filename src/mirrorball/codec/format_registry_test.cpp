#include "mirrorball/codec/format_registry.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {
namespace {

using testing::bytesOf;

const std::string kExr = "\x76\x2f\x31\x01";
const std::string kPng = "\x89PNG\r\n\x1a\n";
const std::string kJpeg = "\xff\xd8\xff\xe0";
const std::string kTiff("II\x2a\0", 4);
const std::string kWebp = "RIFF....WEBPVP8 ";

/// A stand-in for a format's target: any decoder will do.
Result<DecodedImage> decodeNothing(std::span<const std::uint8_t>, const ImageReadOptions&) {
  return fail(ErrorCode::bad_file, "is empty");
}

FormatRegistry registryOf(std::initializer_list<ImageFormatId> ids) {
  std::vector<OptionalFormat> formats;
  for (const ImageFormatId id : ids) formats.push_back({id, {.decode = decodeNothing}});
  return FormatRegistry(formats);
}

std::string answerTo(const FormatRegistry& registry, const std::string& text) {
  const auto codec = registry.codecFor(bytesOf(text));
  if (!codec) return codec.error().message;
  return *codec ? "is read" : "is no format";
}

TEST(FormatRegistry, AFormatThatIsLeftOutIsAnsweredByOneLine) {
  const FormatRegistry none = registryOf({});
  EXPECT_EQ(answerTo(none, kTiff), "this build reads no TIFF; one with MIRRORBALL_TIFF=ON does");
  EXPECT_EQ(answerTo(none, kPng), "this build reads no PNG; one with MIRRORBALL_PNG=ON does");
  EXPECT_EQ(answerTo(none, kExr), "this build reads no OpenEXR; one with MIRRORBALL_EXR=ON does");
  EXPECT_EQ(answerTo(none, kJpeg), "this build reads no JPEG; one with MIRRORBALL_JPEG=ON does");
  EXPECT_EQ(answerTo(none, kWebp), "this build reads no WebP; one with MIRRORBALL_WEBP=ON does");
  EXPECT_EQ(none.codecFor(bytesOf(kTiff)).error().code, ErrorCode::unsupported);
  EXPECT_EQ(answerTo(none, "#?RADIANCE\n"), "is read");
  EXPECT_EQ(answerTo(none, "GIF89a"), "is no format");
}

TEST(FormatRegistry, HasWhatItIsGiven) {
  const FormatRegistry without_tiff =
      registryOf({ImageFormatId::exr, ImageFormatId::png, ImageFormatId::jpeg, ImageFormatId::webp});
  for (const std::string& read : {kExr, kPng, kJpeg, kWebp}) EXPECT_EQ(answerTo(without_tiff, read), "is read");
  EXPECT_NE(answerTo(without_tiff, kTiff), "is read");
  EXPECT_FALSE(without_tiff.has(ImageFormatId::tiff));
  EXPECT_TRUE(without_tiff.has(ImageFormatId::webp));
}

TEST(FormatRegistry, WhatIsLeftOutIsNotWrittenAndNotAdvised) {
  const auto answerOf = [](const FormatRegistry& registry, const char* path) {
    const auto refused = formatToWrite(path, {Holds::light, Holds::picture}, registry);
    return refused ? "" : refused.error().message;
  };
  const FormatRegistry none = registryOf({});
  const auto messageOf = [&](const char* path) { return answerOf(none, path); };
  EXPECT_EQ(messageOf("a.exr"), "a.exr: this build writes no OpenEXR; one with MIRRORBALL_EXR=ON does");
  EXPECT_EQ(messageOf("a.jpeg"), "a.jpeg: this build writes no JPEG; one with MIRRORBALL_JPEG=ON does");
  EXPECT_EQ(messageOf("a.png"), "a.png: this build writes no PNG; one with MIRRORBALL_PNG=ON does");
  EXPECT_EQ(messageOf("a.gif"), "a.gif: is not a format that Mirrorball writes; use .hdr for linear light");
  const auto no_picture = formatToWrite("a.gif", {Holds::picture}, none);
  EXPECT_EQ(no_picture.error().message, "a.gif: is not a format that Mirrorball writes");

  const FormatRegistry png = registryOf({ImageFormatId::png});
  EXPECT_EQ(answerOf(png, "a.png"), "");
  EXPECT_EQ(answerOf(png, "a.gif"),
            "a.gif: is not a format that Mirrorball writes; use .hdr for linear light, .png for pictures");
}

/// The list that CMake writes: each format of its own is there if its options says so, and only those are optional.
TEST(FormatRegistry, OnlyFormatsWithAnOptionAreOptional) {
  for (const OptionalFormat& format : optionalFormats()) EXPECT_NE(formatOf(format.id).build_option, "");
  const FormatRegistry none = registryOf({});
  for (const ImageFormat& format : kImageFormats)
    EXPECT_EQ(none.has(format.id), format.build_option.empty()) << format.name;
}

/// A file of Zstandard's levels is refused by a build without it, and read by one with it.
TEST(FormatRegistry, ZstandardIsThereOrNamed) {
  const Result<void> there = checkZstandard();
  const Result<Bytes> packed = packZstandard(bytesOf("levels"), 1);
  EXPECT_EQ(packed.has_value(), there.has_value());
  if (!there) {
    EXPECT_EQ(packed.error().message, "this build knows no Zstandard; one with MIRRORBALL_ZSTD=ON does");
  }
}

}  // namespace
}  // namespace mirrorball
