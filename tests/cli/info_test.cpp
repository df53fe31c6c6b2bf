// What `info` prints.

#include <limits>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/codec/tiff/tiff_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using InfoTest = CliTest;

// The formats that are read only; what is in them is the codecs' tests' business.
TEST_F(InfoTest, EveryFormatIsAMap) {
  const Bytes texels(4 * 2 * 3, 255);
  const std::string plain(texels.begin(), texels.end());
  write("map.tif", tiffFile({.width = 4, .height = 2}, texels));
  write("map.webp", encodedWebp(Image8(4, 2, 3, 255), 101));
  write("map.tga", tgaFile({.width = 4, .height = 2}, texels));
  write("map.bmp", bmpFile({.width = 4, .height = 2}, texels));
  write("map.ppm", "P6 4 2 255\n" + plain);
  std::string floats = "Pf 4 2 1\n";
  for (int texel = 0; texel < 4 * 2; ++texel) floats += std::string("\x3f\x80\0\0", 4);  // 1, high byte first
  write("map.pfm", floats);
  for (const auto& [name, format] : {std::pair("map.tif", "TIFF, 8 bit"),
                                     {"map.webp", "WebP, lossless"},
                                     {"map.tga", "TGA, 24 bit"},
                                     {"map.bmp", "BMP, 24 bit"},
                                     {"map.ppm", "PPM, 0 to 255"},
                                     {"map.pfm", "PFM, big-endian"}}) {
    const std::string said = succeed(std::string("info ") + name);
    EXPECT_THAT(said, HasSubstr(std::string("format       ") + format + "\n"));
    EXPECT_THAT(said, HasSubstr("projection   equirect (recognised by its shape, 2:1)\n"));
    succeed(std::string("convert ") + name + " --to equirect --size 2 -o " + name + ".exr");
    EXPECT_EQ(image(std::string(name) + ".exr").samples()[0], 1.0f) << name;
  }
}

// Texel (1, 0) of a panorama of 4 × 2: u = 1.5/4, v = 0.5/2, so the longitude is 135° and the latitude from +Y 45°;
// d = (sin 45° sin 135°, cos 45°, −sin 45° cos 135°) = (½, 0.70711, ½).
TEST_F(InfoTest, SaysWhatAFileIs) {
  Image map(4, 2, 3, 0.5f);
  for (int channel = 0; channel < 3; ++channel) map.texel(1, 0)[channel] = 4.0f;
  map.texel(2, 1)[2] = 0.25f;
  write("map.exr", map);
  const std::string said = succeed("info map.exr");
  EXPECT_TRUE(said.starts_with("map.exr\n")) << said;
  EXPECT_THAT(said, HasSubstr("format       OpenEXR, float"));
  EXPECT_THAT(said, HasSubstr("size         4x2\n"));
  EXPECT_THAT(said, HasSubstr("projection   equirect (recognised by its shape, 2:1)\n"));
  EXPECT_THAT(said, HasSubstr("bad texels   none\n"));
  EXPECT_THAT(said, HasSubstr("range        0.5 0.5 0.25 to 4 4 4\n"));
  // All eight texels of two rows have the same solid angle: (7 · 0.5 + 4) / 8, and less an eighth of 0.25 in blue.
  EXPECT_THAT(said, HasSubstr("mean         0.9375 0.9375 0.90625 over the sphere\n"));
  EXPECT_THAT(said, HasSubstr("brightest    4 4 4 from direction 0.5 0.70711 0.5\n"));
}

TEST_F(InfoTest, SaysWhatColourAFileStatesAndWhatWasDone) {
  write("map.exr", Image(4, 2, 3, 0.5f));
  EXPECT_THAT(succeed("info map.exr"), HasSubstr("colour       linear, Rec.709\n"));
  write("map.png", Image(4, 2, 3, 0.5f));
  EXPECT_THAT(succeed("info map.png"), HasSubstr("colour       sRGB\n"));
  std::string texels;
  for (int i = 0; i < 8; ++i) texels += "\x80\x80\x80\x81";
  write(
      "wide.hdr",
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nPRIMARIES=.708 .292 .17 .797 .131 .046 .3127 .329\n\n-Y 2 +X 4\n" + texels);
  EXPECT_THAT(succeed("info wide.hdr"),
              HasSubstr("colour       linear, primaries of the file (Rec.2020): converted\n"));
  write("xyz.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 4\n" + texels);
  EXPECT_THAT(succeed("info xyz.hdr"), HasSubstr("colour       CIE XYZ: converted\n"));
  EXPECT_THAT(succeed("info white"), HasSubstr("colour       linear, Rec.709\n"));
}

TEST_F(InfoTest, SaysWhatABuiltInIs) {
  const std::string said = succeed("info white");
  EXPECT_THAT(said, HasSubstr("format       built in\n"));
  EXPECT_THAT(said, HasSubstr("range        1 1 1 to 1 1 1\n"));
  EXPECT_THAT(said, HasSubstr("mean         1 1 1 over the sphere\n"));
}

// The example of the lecture's third text, {−0.84, 0.23, 0.49}, worked out by hand.
//   cube      x is the longest and negative: face −X, sc = z, tc = −y, |ma| = 0.84:
//             s = (0.49 / 0.84 + 1) / 2 = 0.79167, t = (−0.23 / 0.84 + 1) / 2 = 0.36310;
//             of 512 texels ⌊405.33⌋ and ⌊185.90⌋
// The unit vector is (−0.84059, 0.23016, 0.49034), for |d| = 0.99930.
//   equirect  u = atan2(−0.84, −0.49) / 2π = 239.744° / 360° = 0.66595; v = acos(0.23016)
//             / π = 76.694° / 180° = 0.42608
//   sphere    m = 2 √(0.84059² + 0.23016² + 1.49034²) = 3.45295: s = ½ − 0.84059 / m = 0.25656,
//             t = ½ + 0.23016 / m = 0.56666, which is upwards: row ⌊(1 − t) 1024⌋ = 443
//   angular   θ / 2π = 60.637° / 360° = 0.16844, along (−0.84059, 0.23016) / 0.87153: u = 0.33755, v = 0.45552
TEST_F(InfoTest, SaysWhereADirectionLies) {
  const std::string said = succeed("info uv --direction -0.84,0.23,0.49");
  EXPECT_THAT(said, HasSubstr("unit -0.84059 0.23016 0.49034\n"));
  EXPECT_THAT(said, HasSubstr("cube         face -X, (s, t) = (0.7917, 0.3631), texel (405, 185) of 512x512\n"));
  EXPECT_THAT(said, HasSubstr("equirect     (u, v) = (0.6660, 0.4261), texel (1363, 436) of 2048x1024\n"));
  EXPECT_THAT(said, HasSubstr("sphere       (s, t) = (0.2566, 0.5667), texel (262, 443) of 1024x1024\n"));
  EXPECT_THAT(said, HasSubstr("angular      (u, v) = (0.3375, 0.4555), texel (345, 466) of 1024x1024\n"));
  EXPECT_THAT(said, HasSubstr("radiance     0.05 0.6 0.62\n")) << "-X is cyan";
}

// The texel that info names is the one that holds the direction's light, in the files that convert writes.
TEST_F(InfoTest, ADirectionIsNotAlmostZero) {
  EXPECT_THAT(succeed("info white --direction 0,1,-4e-8"), HasSubstr("unit 0 1 0\n"));
}

TEST_F(InfoTest, TheTexelItNamesIsTheOneInTheFile) {
  Image panorama(64, 32, 3, 0.0f);
  // Texel (42, 13): longitude 239.06°, latitude 75.94° from +Y: d = (−0.83199, 0.24298, 0.49874).
  panorama.texel(42, 13)[0] = 1.0f;
  write("map.exr", panorama);
  const std::string said = succeed("info map.exr --direction -0.83199,0.24298,0.49874");
  EXPECT_THAT(said, HasSubstr("texel (42, 13) of 64x32\n"));
  EXPECT_THAT(said, HasSubstr("face -X"));
  EXPECT_THAT(said, HasSubstr("texel (12, 5) of 16x16\n"));
  EXPECT_THAT(said, HasSubstr("radiance     0.99")) << "five digits do not quite meet the texel's centre";
  succeed("convert map.exr --to cube --layout faces --size 16 -o cube.exr");
  const Image face = image("cube_nx.exr");
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_LE(face.texel(x, y)[0], face.texel(12, 5)[0]);
  EXPECT_GT(face.texel(12, 5)[0], 0.2f);
}

TEST_F(InfoTest, CountsBadTexelsAndRefusesNothing) {
  Image map(8, 4, 3, 2.0f);
  map.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  map.texel(5, 2)[2] = std::numeric_limits<float>::infinity();
  write("map.exr", map);
  const std::string said = succeed("info map.exr");
  EXPECT_THAT(said, HasSubstr("bad texels   2 texels are NaN or infinite, the first at (3, 1)\n"));
  EXPECT_THAT(said, HasSubstr("range        2 2 2 to 2 2 2\n"));
  EXPECT_THAT(said, HasSubstr("mean         2 2 2 over the sphere\n"));
}

TEST_F(InfoTest, ReadsWhatOtherProgramsWrote) {
  for (const char* name : {"lightroom_14b.hdr", "chinese_garden_1k.hdr", "courtyard.exr", "studio.exr"}) {
    if (!share(name)) GTEST_SKIP() << name << " is not there";
    const std::string said = succeed(std::string("info ") + name);
    EXPECT_THAT(said, HasSubstr("projection   equirect")) << name;
    EXPECT_THAT(said, HasSubstr("bad texels   none\n")) << name;
    EXPECT_THAT(said, Not(HasSubstr("nan"))) << name;
  }
}

TEST_F(InfoTest, AFileMayHaveSpacesAndUmlautsInItsName) {
  write("ein schöner Tag.exr", Image(4, 2, 3, 1.0f));
  EXPECT_THAT(succeed(std::vector<std::string>{"info", "ein schöner Tag.exr"}), HasSubstr("ein schöner Tag.exr\n"));
}

}  // namespace
}  // namespace mirrorball::testing
