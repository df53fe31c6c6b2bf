#include "mirrorball/codec/foreign_file.h"

#include <array>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

struct ForeignCase {
  std::string begin;
  const char* message;
};

/// The beginning of a file whose first box, of 24 bytes, says what it holds.
std::string boxOfKind(const std::string& kind) { return std::string("\0\0\0\x18", 4) + kind + std::string(16, '\0'); }

const std::array<ForeignCase, 18> kForeignCases{{
    {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
     "is a Git LFS pointer, which is not read; run `git lfs pull`, which fetches the file that it stands for"},
    {"\xef\xbb\xbf\r\n <!DOCTYPE html><html><body>404</body></html>",
     "is a web page, which is not read; it came in the file's place: download the file itself"},
    {"<!-- saved -->\n<HTML lang=\"en\">", "is a web page, which"},
    {"<?xml version=\"1.0\"?>\n<Error><Code>NoSuchKey</Code></Error>", "is a server's message, which"},
    {"\x1f\x8b\x08\xff", "is compressed by gzip, which is not read; unpack it: `gunzip` does"},
    {"BZh91AY&SY", "is compressed by bzip2, which is not read; unpack it: `bunzip2` does"},
    {"PK\x03\x04" + std::string(60, '\0'), "is a zip archive, which"},
    {std::string("8BPS\0\1", 6), "is a Photoshop document, which is not read; save it as OpenEXR, or as PNG"},
    {"GIF89a", "is a GIF, which is not read; save it as PNG"},
    {"<?xml version=\"1.0\"?>\n<!-- by Inkscape -->\n<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "is an SVG, which"},
    {boxOfKind("ftypheic"), "is a HEIC, which"},
    {boxOfKind("ftypmif1"), "is a HEIF, which"},
    {boxOfKind("ftypcrx "), "is a camera's raw picture, which is not read; develop it"},
    {boxOfKind("ftypisom"), "is a video, which is not read; save one of its frames as PNG"},
    {boxOfKind("ftypqt  "), "is a video, which"},
    {std::string("\0\0\0\x0cjP  \r\n\x87\n", 12), "is a JPEG 2000, which"},
    {"BLENDER-v402", "is a Blender file, a model and no picture"},
    {"Kaydara FBX Binary", "is an FBX, a model and no picture"},
}};

TEST(ForeignFile, InAPicturesPlaceIsNamedWithWhatHelps) {
  for (const ForeignCase& c : kForeignCases) {
    SCOPED_TRACE(c.message);
    for (const std::string& file : {c.begin, c.begin + std::string(std::size_t{2} * kForeignFileBytes, 'x')}) {
      const Bytes bytes(file.begin(), file.end());
      const auto image = decodeImage(bytes);
      ASSERT_FALSE(image);
      EXPECT_EQ(image.error().code, ErrorCode::unsupported);
      EXPECT_THAT(image.error().message, HasSubstr(c.message));
      EXPECT_THAT(decodeTexture(bytes).error().message, HasSubstr(c.message));
    }
  }
}

TEST(ForeignFile, OfNoKnownKindIsNone) {
  const auto isNamed = [](const std::string& text) {
    return foreignFileError(FileUse::picture, Bytes(text.begin(), text.end())).has_value();
  };
  for (const char* text : {"", "<", "hello <html>", "version 2", "\xef\xbb\xbf  ", "<x3d>", "ftyp"})
    EXPECT_FALSE(isNamed(text)) << text;
  EXPECT_FALSE(foreignFileError(FileUse::model, {}, "glb"));
  EXPECT_TRUE(foreignFileError(FileUse::model, {}, "usdz"));
  // Markup that stands too far behind is not looked for.
  EXPECT_FALSE(isNamed("<" + std::string(kForeignFileBytes, ' ') + "<html>"));
}

}  // namespace
}  // namespace mirrorball
