#include "mirrorball/codec/image_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

TEST(ImageFormat, ListsAreMadeFromTheTable) {
  EXPECT_EQ(readExtensions(), ".hdr .exr .png .jpg .ktx2 .ktx .dds .tif .webp .avif .jxl .tga .bmp .pnm .pfm");
  EXPECT_EQ(readExtensions(Holds::light), ".hdr .exr .tif .jxl .pfm");
  EXPECT_EQ(readExtensions(Holds::picture), ".png .jpg .tif .webp .avif .jxl .tga .bmp .pnm");
  EXPECT_EQ(writtenExtensions(), ".hdr .exr .png .jpg .ktx2 .ktx .dds");
  EXPECT_EQ(writtenExtensions(Holds::texture, " or "), ".ktx2, .ktx or .dds");
  EXPECT_EQ(readFormatNames(),
            "Radiance HDR, OpenEXR, PNG, JPEG, KTX2, KTX, DDS, TIFF, WebP, AVIF, JPEG XL, TGA, BMP, PNM or PFM");
}

TEST(ImageFormat, TheExtensionTellsWhatIsWritten) {
  EXPECT_EQ(*formatToWrite("b/a.EXR", {Holds::light}), ImageFormatId::exr);
  EXPECT_EQ(*formatToWrite("a.jpeg", {Holds::light, Holds::picture}), ImageFormatId::jpeg);
  const auto message = [](const char* path, std::initializer_list<Holds> wanted) {
    const auto refused = formatToWrite(path, wanted);
    EXPECT_FALSE(refused) << path;
    return refused ? "" : refused.error().message;
  };
  for (const char* path : {"x.tif", "x.pfm", "x.gif", "x.hdr.gz"})
    EXPECT_EQ(message(path, {Holds::light, Holds::picture}),
              path + std::string(": is not a format that Mirrorball writes; use .hdr or .exr for linear light, .png or "
                                 ".jpg for pictures"));
  EXPECT_EQ(message("x.dds", {Holds::picture}), "x.dds: would hold textures; use .png or .jpg");
  EXPECT_EQ(message("x", {Holds::texture}), "x: has no extension to tell its format by; use .ktx2, .ktx or .dds");
}

TEST(ImageFormat, PrimariesThatAFileCannotStateAreRefused) {
  const auto message = [](const char* path, OutputPrimaries primaries, std::initializer_list<Holds> wanted) {
    const auto refused = checkStatesPrimaries(path, primaries, wanted);
    return refused ? "" : refused.error().message;
  };
  const std::initializer_list<Holds> any{Holds::light, Holds::picture, Holds::texture};
  for (const char* path : {"a.exr", "a.hdr", "a.ktx2"})
    for (const OutputPrimaries primaries : {OutputPrimaries::p3, OutputPrimaries::rec2020, OutputPrimaries::acescg})
      EXPECT_EQ(message(path, primaries, any), "");
  EXPECT_EQ(message("a.png", OutputPrimaries::p3, any), "");
  EXPECT_EQ(message("a.jpg", OutputPrimaries::rec709, any), "");
  for (const std::string path : {"a.jpg", "a.dds", "a.ktx"})
    EXPECT_EQ(message(path.c_str(), OutputPrimaries::p3, any),
              path +
                  ": cannot state other primaries than Rec.709's; write .hdr, .exr, .png or .ktx2, or leave the "
                  "primaries as they are");
  EXPECT_EQ(message("a.png", OutputPrimaries::acescg, {Holds::light, Holds::picture}),
            "a.png: holds what a display shows, and ACEScg is linear light; write .hdr or .exr, or leave the "
            "primaries as they are");
}

}  // namespace
}  // namespace mirrorball
