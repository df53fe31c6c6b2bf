// Maps in .ktx2, .ktx and .dds: the light of the same map in pictures, its mip levels,
// and what of it a format can hold.

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::array<const char*, 6> kTextureEndings{"px", "nx", "py", "ny", "pz", "nz"};

/// The greatest difference of two images' colours, as a share of the brightest channel of each texel.
float relativeDifference(const Image& image, const Image& exact) {
  float max = 0.0f;
  for (int y = 0; y < exact.height(); ++y)
    for (int x = 0; x < exact.width(); ++x) {
      const glm::vec3 light = rgbAt(exact, x, y);
      const glm::vec3 difference = glm::abs(rgbAt(image, x, y) - light);
      max = std::max(max, std::max({difference.x, difference.y, difference.z}) / std::max({light.x, light.y, light.z}));
    }
  return max;
}

/// ∫ L dω over one level of a cube.
glm::dvec3 fluxOf(const ImageSet& cube, int level) {
  glm::dvec3 flux(0.0);
  for (int face = 0; face < 6; ++face) {
    const Image& image = cube.at(level, face);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        flux += glm::dvec3(rgbAt(image, x, y)) *
                double(texelSolidAngle(Projection::cube, glm::ivec2(image.width()), {x, y}));
  }
  return flux;
}

/// The plain mean of the four texels that texel (x, y) of the next level covers.
glm::vec3 meanOfFour(const Image& image, int x, int y) {
  return (rgbAt(image, 2 * x, 2 * y) + rgbAt(image, 2 * x + 1, 2 * y) + rgbAt(image, 2 * x, 2 * y + 1) +
          rgbAt(image, 2 * x + 1, 2 * y + 1)) /
         4.0f;
}

class ConvertTextureTest : public CliTest {
 protected:
  void SetUp() override { write("map.exr", smoothPanorama()); }
};

TEST_F(ConvertTextureTest, ACubeHoldsTheSixFaces) {
  succeed("convert map.exr --to cube --size 16 --layout faces -o face.exr");
  for (const std::string file : {"cube.ktx2", "cube.ktx", "cube.dds"}) {
    succeed("convert map.exr --to cube --size 16 --format float32 -o " + file);
    const ImageSet cube = texture(file);
    EXPECT_EQ(cube.levels(), 1) << file;
    ASSERT_EQ(cube.faces(), 6) << file;
    for (int face = 0; face < 6; ++face) {
      const Image picture = image("face_" + std::string(kTextureEndings[std::size_t(face)]) + ".exr");
      ASSERT_EQ(cube.at(0, face).width(), 16);
      EXPECT_EQ(relativeDifference(cube.at(0, face), picture), 0.0f) << file << ", face " << face;
    }
  }
}

// Half floats have 11 bits of mantissa and b10g11r11 has 7, of blue 6, the leading one counted; rounding is off by half
// a step. e5b9g9r9 has 9 bits, without a leading one, under the exponent of the brightest channel.
TEST_F(ConvertTextureTest, EachFormatKeepsItsPrecision) {
  struct Format {
    const char* name;
    const char* shown;
    float precision;
  };
  succeed("convert map.exr --to equirect --size 16 -o exact.exr");
  for (const Format& format :
       {Format{"auto", "r16g16b16a16 sfloat", 1.0f / 2048.0f}, Format{"half", "r16g16b16a16 sfloat", 1.0f / 2048.0f},
        Format{"float32", "r32g32b32a32 sfloat", 0.0f}, Format{"b10g11r11", "b10g11r11 ufloat", 1.0f / 64.0f},
        Format{"e5b9g9r9", "e5b9g9r9 ufloat", 1.0f / 512.0f}})
    for (const std::string extension : {"ktx2", "dds"}) {
      const std::string file = "map." + extension;
      succeed("convert map.exr --to equirect --size 16 --format " + std::string(format.name) + " -o " + file);
      EXPECT_THAT(succeed("info --from equirect " + file), HasSubstr(format.shown));
      const float off = relativeDifference(texture(file).at(0, 0), image("exact.exr"));
      EXPECT_LE(off, format.precision) << format.name;
      EXPECT_GE(off, format.precision / 4.0f) << format.name << " is more exact than it can be";
    }
}

TEST_F(ConvertTextureTest, EveryProjectionIsTheSameInATexture) {
  for (const std::string_view name : projectionNames()) {
    const std::string to = "convert map.exr --size 16 --to " + std::string(name);
    if (faceCount(*projectionNamed(name)) == 6) continue;
    succeed(to + " -o map_picture.exr");
    succeed(to + " --format float32 -o map.ktx2");
    const Image picture = image("map_picture.exr");
    const Image inside = texture("map.ktx2").at(0, 0);
    ASSERT_EQ(inside.width(), picture.width()) << name;
    ASSERT_EQ(inside.height(), picture.height()) << name;
    int others = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) others += rgbaAt(inside, x, y) != rgbaAt(picture, x, y);
    EXPECT_EQ(others, 0) << name;
  }
}

TEST_F(ConvertTextureTest, WeightedMipLevelsKeepTheFlux) {
  for (const std::string file : {"cube.ktx2", "cube.ktx", "cube.dds"}) {
    succeed("convert map.exr --to cube --size 16 --mips --format float32 -o " + file);
    const ImageSet cube = texture(file);
    ASSERT_EQ(cube.levels(), 5) << "16 8 4 2 1";
    const glm::dvec3 flux = fluxOf(cube, 0);
    for (int level = 1; level < 5; ++level) {
      EXPECT_EQ(cube.at(level, 5).width(), 16 >> level);
      EXPECT_LT(glm::length(fluxOf(cube, level) - flux) / glm::length(flux), 1e-6) << "level " << level;
    }
  }
}

TEST_F(ConvertTextureTest, BoxMipLevelsAreMeansOfFour) {
  succeed("convert map.exr --to cube --size 16 --mips --mip box --format float32 -o box.ktx2");
  succeed("convert map.exr --to cube --size 16 --mips --mip solid-angle --format float32 -o weighted.ktx2");
  succeed("convert map.exr --to cube --size 16 --mips --format float32 -o usual.ktx2");
  const ImageSet box = texture("box.ktx2");
  ASSERT_EQ(box.levels(), 5);
  for (int level = 1; level < 5; ++level)
    for (int face = 0; face < 6; ++face)
      for (int y = 0; y < 16 >> level; ++y)
        for (int x = 0; x < 16 >> level; ++x)
          EXPECT_LT(glm::length(rgbAt(box.at(level, face), x, y) - meanOfFour(box.at(level - 1, face), x, y)), 1e-6f);
  EXPECT_TRUE(bytes("usual.ktx2") == bytes("weighted.ktx2"));
  EXPECT_FALSE(bytes("usual.ktx2") == bytes("box.ktx2"));
}

TEST_F(ConvertTextureTest, APanoramasMipLevelsGoDownToOneTexel) {
  succeed("convert map.exr --to equirect --mips -o map.ktx2");
  const ImageSet map = texture("map.ktx2");
  ASSERT_EQ(map.levels(), 7) << "64x32 down to 1x1";
  EXPECT_EQ(map.at(5, 0).width(), 2);
  EXPECT_EQ(map.at(6, 0).height(), 1);
  EXPECT_THAT(succeed("info map.ktx2"), HasSubstr("KTX2, r16g16b16a16 sfloat, 7 mip levels"));
}

TEST_F(ConvertTextureTest, ZstandardMakesTheFileSmallerAndNothingElse) {
  for (const std::string mips : {"", " --mips"}) {
    const std::string to = "convert map.exr --to cube --size 32 --format float32" + mips + " -o ";
    succeed(to + "plain.ktx2");
    succeed(to + "small.ktx2 --zstd 19");
    EXPECT_LT(bytes("small.ktx2").size(), bytes("plain.ktx2").size());
    EXPECT_THAT(succeed("info small.ktx2"), HasSubstr("Zstandard"));
    const ImageSet plain = texture("plain.ktx2");
    const ImageSet small = texture("small.ktx2");
    ASSERT_EQ(small.levels(), plain.levels());
    for (int level = 0; level < plain.levels(); ++level)
      for (int face = 0; face < 6; ++face) EXPECT_EQ(maxDifference(small.at(level, face), plain.at(level, face)), 0.0);
  }
}

// The way there is another one: a plain texture is written while it is converted, the others as a whole.
TEST_F(ConvertTextureTest, LightBeyondHalfFloatsIsKeptInFloatsWithARemark) {
  Image bright = smoothPanorama();
  bright.texel(20, 10)[1] = 1e6f;
  write("bright.hdr", bright);
  for (const std::string output : {"a.ktx2", "b.dds", "c.ktx2 --mips", "d.ktx2 --zstd 3", "e.dds --as-seen", "f.ktx"}) {
    const std::string file = output.substr(0, output.find(' '));
    const Outcome outcome = run("convert bright.hdr --to cube --size 64 -o " + output);
    EXPECT_EQ(outcome.exit_code, 0) << output;
    EXPECT_EQ(outcome.err, "mirrorball: note: " + file +
                               ": holds light that half floats do not; written in 32-bit floats; --format "
                               "half is half as large, and cuts what is brighter than 65504\n");
    EXPECT_THAT(succeed("info " + file), HasSubstr("r32g32b32a32 sfloat"));
    float max = 0.0f;
    const ImageSet images = texture(file);
    for (int face = 0; face < 6; ++face)
      for (const float sample : images.at(0, face).samples()) max = std::max(max, sample);
    EXPECT_GT(max, 5e5f) << output;
  }
}

TEST_F(ConvertTextureTest, TooDarkForHalfFloatsIsTold) {
  write("dark.exr", Image(64, 32, 3, 1e-9f));
  const std::string told = "is so dark that half floats hold few of its digits; --format float32 holds them all";
  // By pieces, with mip levels, and a picture.
  for (const std::string words :
       {"-o out.ktx2", "--mips -o out.ktx2", "--to cube --size 8 -o out.dds", "--format half -o out.exr"})
    EXPECT_THAT(run("convert dark.exr " + words).err, AllOf(HasSubstr("mirrorball: note: out."), HasSubstr(told)))
        << words;
  for (const std::string words : {"--format float32 -o out.ktx2", "-o out.exr"}) succeed("convert dark.exr " + words);
  write("night.exr", [] {
    Image night(64, 32, 3, 1e-9f);
    for (int x = 0; x < 64; ++x) night.texel(x, 3)[1] = 0.01f;
    return night;
  }());
  succeed("convert night.exr -o out.ktx2");
}

TEST_F(ConvertTextureTest, LevelsThatAreLeftOutAreTold) {
  succeed("convert uv --to cube --size 16 --mips -o levels.ktx2");
  EXPECT_EQ(run("convert levels.ktx2 -o out.dds").err,
            "mirrorball: note: levels.ktx2: of its 5 mip levels only the first is taken; --mips takes all\n");
  succeed("convert levels.ktx2 --mips -o out.dds");
  succeed("convert levels.ktx2 --level 1 -o out.dds");
}

// The last but one of all half floats: interpolation may lift 65504 itself by a rounding error.
TEST_F(ConvertTextureTest, LightWithinHalfFloatsNeedsNoRemark) {
  write("bright.exr", Image(8, 4, 3, 65472.0f));
  succeed("convert bright.exr --to cube --size 4 -o bright.ktx2");
  EXPECT_THAT(succeed("info bright.ktx2"), AllOf(HasSubstr("r16g16b16a16 sfloat"), HasSubstr("to 65472 65472 65472")));
}

TEST_F(ConvertTextureTest, ANamedFormatThatDoesNotHoldTheLightSaysHowMuchIsLost) {
  write("bright.exr", Image(8, 4, 3, 1e6f));
  for (const std::string format : {"half", "b10g11r11", "e5b9g9r9", "bc6h"})
    for (const std::string output : {"out.ktx2", "out.dds", "out.ktx2 --mips"}) {
      const std::string file = output.substr(0, output.find(' '));
      const Outcome outcome = run("convert bright.exr --to cube --size 4 --format " + format + " -o " + output);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_THAT(outcome.err, AllOf(HasSubstr("note: " + file + ": "), HasSubstr("% of the light is lost"))) << format;
      const ImageSet images = texture(file);
      for (int level = 0; level < images.levels(); ++level) EXPECT_NEAR(images.at(level, 3).texel(0, 0)[0], 65000, 600);
    }
}

TEST_F(ConvertTextureTest, LightIsScaledAndClamped) {
  write("bright.exr", Image(8, 4, 3, 1e6f));
  succeed("convert bright.exr --to cube --size 4 --format half --scale-light 0.01 -o out.ktx2");
  EXPECT_EQ(texture("out.ktx2").at(0, 2).texel(1, 1)[1], 1e4f);
  const Outcome outcome = run("convert bright.exr --to cube --scale-light 0.01 --clamp-light 100 -o out.ktx2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("the limit takes 99 % of the light (--clamp-light)"));
  EXPECT_EQ(texture("out.ktx2").at(0, 2).texel(1, 1)[1], 100.0f);
  for (const std::string command : {"bake bright.exr --size 16 -o", "convert bright.exr --to equirect -o"}) {
    EXPECT_THAT(run(command + " out.ktx2 --clamp-light 50").err, HasSubstr("takes 100 % of the light")) << command;
    EXPECT_NEAR(texture("out.ktx2").at(0, 0).texel(0, 0)[0], 50.0f, 0.5f) << command;
  }
}

// What convert made of a texture is what it makes of the same map in a picture. DDS does not say which cube it is; a
// cube without a word is ours.
TEST_F(ConvertTextureTest, TexturesComeInAgain) {
  succeed("convert map.exr --to cube --size 32 -o cube.exr");
  succeed("convert cube.exr --to equirect --size 32 -o from_picture.exr");
  for (const std::string output : {"cube.ktx2", "cube.ktx", "cube.dds", "cube.ktx2 --zstd 3", "cube.ktx2 --mips",
                                   "cube.ktx --mips", "cube.dds --mips"}) {
    succeed("convert map.exr --to cube --size 32 --format float32 -o " + output);
    succeed("convert " + output.substr(0, output.find(' ')) + " --to equirect --size 32 -o again.exr");
    EXPECT_TRUE(bytes("again.exr") == bytes("from_picture.exr")) << output;
  }
}

TEST_F(ConvertTextureTest, Ktx1IsRead) {
  const Image picture = smoothPanorama();
  Bytes file = ktx1Header({.format = 0x1907, .internal_format = 0x8815, .width = 64, .height = 32});
  appendU32(file, 64 * 32 * 12, false);
  for (const float sample : picture.samples()) appendU32(file, std::bit_cast<std::uint32_t>(sample), false);
  write("map.ktx", file);
  EXPECT_THAT(succeed("info map.ktx"), HasSubstr("KTX1, r32g32b32 sfloat"));
  for (const std::string input : {"map.ktx", "map.exr"})
    succeed("convert " + input + " --to cube --size 16 -o from_" + input.substr(4) + ".exr");
  EXPECT_TRUE(bytes("from_ktx.exr") == bytes("from_exr.exr"));
}

}  // namespace
}  // namespace mirrorball::testing
