// Pictures of integers as phones and other programs write them: the remarks on them, and what light they become.

#include <algorithm>
#include <string>

#include "cli/cli_testing.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/image/upright.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A JPEG that says that it must be turned.
Bytes turnedBy(const Bytes& jpeg, std::uint8_t orientation) {
  const Bytes exif{'E',  'x', 'i', 'f', 0, 0, 'I', 'I', 42,          0, 8, 0, 0, 0, 1, 0,
                   0x12, 1,   3,   0,   1, 0, 0,   0,   orientation, 0, 0, 0, 0, 0, 0, 0};
  const Bytes segment = jpegSegment(kApp1, exif);
  Bytes bytes = jpeg;
  bytes.insert(bytes.begin() + 2, segment.begin(), segment.end());
  return bytes;
}

class OddPictureTest : public CliTest {
 protected:
  /// Of one colour, as a JPEG.
  Bytes flatJpeg(int width, int height, glm::vec3 light) const {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c) image.texel(x, y)[c] = light[c];
    write("flat.jpg", image);
    return bytes("flat.jpg");
  }

  /// The same light in a file of Display P3.
  Bytes flatP3(int width, int height, glm::vec3 light) const {
    const glm::vec3 p3 = glm::inverse(*rec709FromPrimaries(kDisplayP3)) * light;
    return jpegWithProfile(flatJpeg(width, height, p3), iccDisplayP3());
  }
};

const glm::vec3 kOrange(0.6f, 0.3f, 0.2f);

TEST_F(OddPictureTest, AMapThatEndsEarlyIsReadAsFarAsItGoes) {
  succeed("convert uv --to equirect --size 64 -o whole.jpg");
  const Bytes whole = bytes("whole.jpg");
  write("cut.jpg", Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() / 2)));
  const Outcome outcome = run("convert cut.jpg --to equirect -o cut.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, ::testing::ContainsRegex("^mirrorball: note: cut.jpg: ends before its last row: the [0-9]+ "
                                                    "rows that are missing are black\n$"));
  succeed("convert whole.jpg --to equirect -o whole.exr");
  const Image cut = image("cut.exr"), all = image("whole.exr");
  for (int x = 0; x < cut.width(); ++x) {
    EXPECT_EQ(cut.texel(x, 2)[1], all.texel(x, 2)[1]);
    EXPECT_EQ(cut.texel(x, cut.height() - 1)[1], 0.0f);
  }
  write("cut.jpg", Bytes(whole.begin(), whole.begin() + 640));
  EXPECT_THAT(refuse(1, "info cut.jpg"), HasSubstr("is a damaged JPEG"));
}

// Half a panorama, as Hugin cuts away the empty margins.
TEST_F(OddPictureTest, ATiffIsInItsPlaceOnItsCanvas) {
  const TiffForm form{.width = 32,
                      .height = 16,
                      .bits = 32,
                      .kind = SAMPLEFORMAT_IEEEFP,
                      .whole = glm::uvec2(64, 32),
                      .position = {16.0f / 150.0f, 8.0f / 150.0f}};
  write("cropped.tif", tiffFile(form, bytesOfNumbers(std::vector<float>(32 * 16 * 3, 0.5f))));
  const Outcome outcome = run("convert cropped.tif --to equirect -o whole.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("cropped.tif: holds 32x16 of the 64x32 texels of its full image: what lies outside is "
                        "black, and lights nothing; --from equirect:fill=smooth"));
  const Image whole = image("whole.exr");
  ASSERT_EQ(whole.width(), 64);
  EXPECT_EQ(whole.texel(16, 8)[1], 0.5f);
  EXPECT_EQ(whole.texel(47, 23)[1], 0.5f);
  EXPECT_EQ(whole.texel(15, 8)[1], 0.0f);
  EXPECT_EQ(whole.texel(47, 24)[1], 0.0f);
  EXPECT_THAT(run("info cropped.tif").out, HasSubstr("64x32 (its full image)"));
}

TEST_F(OddPictureTest, APanoramaHeldUpsideDownIsUpright) {
  succeed("convert uv --to equirect --size 64 -o up.jpg");
  const Image8 stored = *decodeTexture(bytes("up.jpg"));
  for (const int orientation : {3, 8}) {
    // What brings a picture upright that was turned the other way: 8 undoes 6.
    const Image8 turned = upright(Image8(stored), orientation == 3 ? 3 : 6);
    ASSERT_TRUE(savePicture(path("turned.jpg"), turned, {}));
    write("held.jpg", turnedBy(bytes("turned.jpg"), static_cast<std::uint8_t>(orientation)));
    const Outcome outcome = run("convert held.jpg --to equirect -o held.exr");
    EXPECT_EQ(outcome.err, "mirrorball: note: held.jpg: turned upright, as its EXIF says (orientation " +
                               std::to_string(orientation) + ")\n");
    const Image held = image("held.exr");
    ASSERT_EQ(held.width(), stored.width());
    for (int y = 0; y < held.height(); y += 3)
      for (int x = 0; x < held.width(); x += 3)
        ASSERT_NEAR(srgb8FromLinear(held.texel(x, y)[0]), stored.texel(x, y)[0], 12) << x << ' ' << y;
  }
  write("held.jpg", turnedBy(flatJpeg(8, 16, kOrange), 6));
  const Outcome heights = run("surface held.jpg --to normal -o normal.exr");
  EXPECT_THAT(heights.err, HasSubstr("held.jpg: turned upright, as its EXIF says (orientation 6)"));
  EXPECT_EQ(image("normal.exr").width(), 16);
}

TEST_F(OddPictureTest, PhonesPhotographsOfABallAreConverted) {
  write("p3.jpg", flatP3(64, 64, kOrange));
  const Outcome outcome = run("photo p3.jpg --circle 32,32,28 --size 32 -o map.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("note: p3.jpg: its colours are not sRGB's: sRGB, primaries of the file (Display "
                                     "P3): converted\n"));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image("map.exr").texel(32, 16)[c], kOrange[c], 0.01f);
}

// As raw converters write them. A camera's curve would be recovered from too few shades here.
TEST_F(OddPictureTest, ASeriesOfLinearCodesIsMergedWithoutAResponse) {
  const auto linearTiff = [](float exposure) {
    TiffForm form{.width = 64, .height = 64, .bits = 16};
    form.profile = iccMatrixProfile(
        "Linear", {{{0.51512, 0.24120, -0.00105}, {0.29198, 0.69225, 0.04189}, {0.15710, 0.06657, 0.78407}}},
        iccValue("para", {1.0}, {0}));
    const glm::vec3 p3 = exposure * (glm::inverse(*rec709FromPrimaries(kDisplayP3)) * kOrange);
    std::vector<std::uint16_t> codes;
    for (int i = 0; i < 64 * 64 * 3; ++i)
      codes.push_back(static_cast<std::uint16_t>(65535.0f * std::min(p3[i % 3], 1.0f)));
    return tiffFile(form, bytesOfNumbers(codes));
  };
  write("bright.tif", linearTiff(1.0f));
  write("dark.tif", linearTiff(0.125f));
  const Outcome outcome = run("photo bright.tif dark.tif --exposures 1,1/8 --circle 32,32,28 --size 32 -o map.exr");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image("map.exr").texel(32, 16)[c], kOrange[c], 0.01f);
}

TEST_F(OddPictureTest, AProfileThatIsNotAppliedIsReported) {
  write("a.jpg", jpegWithProfile(flatJpeg(32, 16, kOrange), iccProfile("Camera RGB")));
  const Outcome outcome = run("info a.jpg");
  EXPECT_THAT(outcome.out, HasSubstr("colour       sRGB assumed: its ICC profile (Camera RGB) is not applied"));
  EXPECT_THAT(outcome.err, HasSubstr("note: a.jpg: has an ICC profile (Camera RGB) without a matrix"));
}

class OddTextureTest : public RenderCliTest {};

TEST_F(OddTextureTest, BaseColoursAreConvertedAndRoughnessIsNot) {
  Image p3(8, 8, 3), rec709(8, 8, 3);
  const glm::vec3 stored = glm::inverse(*rec709FromPrimaries(kDisplayP3)) * kOrange;
  for (int i = 0; i < 64; ++i)
    for (int c = 0; c < 3; ++c) {
      p3.samples()[std::size_t(3 * i + c)] = stored[c];
      rec709.samples()[std::size_t(3 * i + c)] = kOrange[c];
    }
  write("flat.jpg", p3);
  write("p3.jpg", jpegWithProfile(bytes("flat.jpg"), iccDisplayP3()));
  write("rec709.jpg", rec709);
  const std::string scene = "render sphere -e uv --size 24x24 --set metallic=0 ";
  const Outcome outcome = run(scene + "--set base_color_map=p3.jpg -o p3.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("p3.jpg: its colours are not sRGB's: sRGB, primaries of the file (Display P3): "
                                     "converted"));
  succeed(scene + "--set base_color_map=rec709.jpg -o rec709.png");
  const Image8 a = *decodeTexture(bytes("p3.png")), b = *decodeTexture(bytes("rec709.png"));
  for (std::size_t i = 0; i < a.samples().size(); ++i) ASSERT_NEAR(a.samples()[i], b.samples()[i], 3) << i;
  // Numbers are what they are.
  const Outcome numbers = run(scene + "--set roughness_map=p3.jpg -o rough.png");
  EXPECT_EQ(numbers.exit_code, 0);
  EXPECT_THAT(numbers.err, ::testing::Not(HasSubstr("its colours")));
  EXPECT_THAT(numbers.err,
              HasSubstr("p3.jpg: states a colour space (sRGB, Display P3), which does not count for numbers: "
                        "they are read as they are stored"));
}

}  // namespace
}  // namespace mirrorball::testing
