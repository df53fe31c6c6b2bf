// BC6H in .ktx2 and .dds, UASTC HDR in .ktx2: how near they come to the light of real panoramas, what they do not hold,
// and every command that reads or writes them.

#include <cmath>
#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Calls `visit(sample, expected)` for red, green and blue of every texel of the first level.
template <typename Visit>
void forEachColor(const ImageSet& images, const ImageSet& exact, const Visit& visit) {
  for (int face = 0; face < exact.faces(); ++face)
    for (int y = 0; y < exact.at(0, face).height(); ++y)
      for (int x = 0; x < exact.at(0, face).width(); ++x)
        for (int c = 0; c < 3; ++c)
          visit(double(rgbAt(images.at(0, face), x, y)[c]), double(rgbAt(exact.at(0, face), x, y)[c]));
}

/// docs/conventions/files.md's: the root of the mean of squared errors,
/// each relative to the sum of the sample and the mean of all.
double relativeError(const ImageSet& images, const ImageSet& exact) {
  double sum = 0.0;
  double count = 0.0;
  forEachColor(exact, exact, [&](double, double light) {
    sum += light;
    ++count;
  });
  const double mean = sum / count;
  double squares = 0.0;
  forEachColor(images, exact, [&](double found, double light) {
    const double off = (found - light) / (std::max(light, 0.0) + mean);
    squares += off * off;
  });
  return std::sqrt(squares / count);
}

using ConvertBlocksTest = CliTest;

TEST_F(ConvertBlocksTest, RealPanoramasKeepTheirLight) {
  struct Panorama {
    const char* name;
    double max_of_bc6h;
    double max_of_uastc_hdr;
  };
  for (const Panorama& panorama :
       {Panorama{"chinese_garden_1k.hdr", 0.008, 0.009}, Panorama{"lightroom_14b.hdr", 0.002, 0.002},
        Panorama{"courtyard.exr", 0.012, 0.014}, Panorama{"studio.exr", 0.006, 0.006}}) {
    if (!share(panorama.name)) GTEST_SKIP() << panorama.name << " is not there";
    const std::string convert = std::string("convert ") + panorama.name + " --to cube";
    succeed(convert + " --format float32 -o exact.ktx2");
    const auto errorOf = [&](const std::string& format) {
      EXPECT_EQ(run(convert + " --format " + format + " -o cube.ktx2").exit_code, 0);
      return relativeError(texture("cube.ktx2"), texture("exact.ktx2"));
    };
    EXPECT_LE(errorOf("bc6h"), panorama.max_of_bc6h) << panorama.name;
    EXPECT_LE(errorOf("uastc_hdr"), panorama.max_of_uastc_hdr) << panorama.name;
  }
}

/// Converted strip by strip, as a whole for its mip levels or for Zstandard: the same texels in every file.
TEST_F(ConvertBlocksTest, EveryFileHasTheSameTexels) {
  write("map.exr", smoothPanorama());
  const std::string convert = "convert map.exr --to cube --size 30 --format bc6h -o ";
  succeed(convert + "plain.ktx2");
  const ImageSet plain = texture("plain.ktx2");
  for (const std::string output :
       {"cube.dds", "cube.ktx2 --mips", "cube.dds --mips", "cube.ktx2 --zstd 3", "cube.ktx2 --zstd 3 --mips"}) {
    succeed(convert + output);
    const std::string file = output.substr(0, output.find(' '));
    EXPECT_THAT(succeed("info " + file), HasSubstr(file == "cube.dds" ? "DDS, bc6h ufloat" : "KTX2, bc6h ufloat"));
    const ImageSet cube = texture(file);
    EXPECT_EQ(cube.levels(), output.ends_with("--mips") ? 5 : 1);
    int others = 0;
    forEachColor(cube, plain, [&](double found, double light) { others += found != light; });
    EXPECT_EQ(others, 0) << output;
  }
}

TEST_F(ConvertBlocksTest, ComesInAgain) {
  write("map.exr", smoothPanorama());
  succeed("convert map.exr --to cube --size 32 -o exact.exr");
  for (const std::string file : {"cube.ktx2", "cube.ktx", "cube.dds"}) {
    succeed("convert map.exr --to cube --size 32 --format bc6h -o " + file);
    succeed("convert " + file + " --to cube --size 32 -o again.exr");
    EXPECT_LT(meanDifference(image("again.exr"), image("exact.exr")), 0.004) << file;
  }
}

TEST_F(ConvertBlocksTest, TheWholeChainIsBaked) {
  write("map.exr", smoothPanorama());
  succeed("bake map.exr --size 32 --brdf-size 16 --format bc6h -o baked");
  EXPECT_THAT(succeed("info baked/specular.ktx2"), HasSubstr("bc6h ufloat"));
  EXPECT_THAT(succeed("info baked/irradiance.ktx2"), HasSubstr("bc6h ufloat"));
  succeed("bake map.exr --size 32 --format float32 -o exact.ktx2");
  const ImageSet exact = texture("exact.ktx2");
  const ImageSet baked = texture("baked/specular.ktx2");
  ASSERT_EQ(baked.levels(), exact.levels());
  EXPECT_LT(relativeError(baked, exact), 0.005);
  // A table of shares would lose too much.
  EXPECT_THAT(std::string(reinterpret_cast<const char*>(bytes("baked/manifest.json").data()),
                          bytes("baked/manifest.json").size()),
              HasSubstr("r16g16b16a16 sfloat"));
}

TEST_F(ConvertBlocksTest, WhatItDoesNotHoldIsSaid) {
  Image map(8, 4, 3, 1.0f);
  map.texel(3, 2)[1] = -0.5f;
  write("negative.exr", map);
  for (const std::string output : {"out.ktx2", "out.dds", "out.ktx2 --zstd 1"})
    for (const std::string format : {"bc6h", "b10g11r11", "e5b9g9r9"}) {
      const Outcome outcome = run("convert negative.exr --to equirect --size 4 --format " + format + " -o " + output);
      EXPECT_EQ(outcome.exit_code, 0);
      EXPECT_THAT(outcome.err, AllOf(HasSubstr(output.substr(0, output.find(' ')) + ": 1 value is negative"),
                                     HasSubstr("taken as 0")));
      EXPECT_LT(texture(output.substr(0, output.find(' '))).at(0, 0).texel(3, 2)[1], 1e-4f);
    }
  // Beside its disc a sphere map has alpha 0.
  EXPECT_THAT(run("convert negative.exr --to sphere --size 8 --format bc6h -o out.dds").err, HasSubstr("no alpha"));
  EXPECT_THAT(refuse(2, "convert negative.exr --to cube --format bc6h -o out.exr"),
              AllOf(StartsWith("out.exr: "), HasSubstr("bc6h")));

  write("bright.exr", Image(8, 4, 3, 65505.0f));
  for (const std::string output : {"new.ktx2", "new.dds", "new.ktx2 --mips", "new.ktx2 --zstd 1"})
    EXPECT_THAT(run("convert bright.exr --to cube --size 4 --format bc6h -o " + output).err,
                AllOf(HasSubstr("bc6h holds 0 to 65504"), HasSubstr("of the light is lost")));
  map.texel(3, 2)[1] = std::nanf("");
  write("nan.exr", map);
  EXPECT_THAT(refuse(1, "convert nan.exr --to cube --format bc6h -o new.ktx2"), HasSubstr("--repair"));
}

TEST_F(ConvertBlocksTest, UastcHdrIsKtx2s) {
  write("map.exr", smoothPanorama());
  const std::string convert = "convert map.exr --to cube --size 30 --format uastc_hdr -o ";
  succeed(convert + "plain.ktx2");
  EXPECT_THAT(succeed("info plain.ktx2"), HasSubstr("KTX2, uastc hdr 4x4"));
  const ImageSet plain = texture("plain.ktx2");
  for (const std::string options : {" --mips", " --zstd 3", " --zstd 3 --mips"}) {
    succeed(convert + "cube.ktx2" + options);
    int others = 0;
    forEachColor(texture("cube.ktx2"), plain, [&](double found, double light) { others += found != light; });
    EXPECT_EQ(others, 0) << options;
  }
  for (const std::string file : {"cube.dds", "cube.ktx", "cube.exr"})
    EXPECT_THAT(refuse(2, convert + file), AllOf(StartsWith(file + ": cannot hold uastc_hdr"), HasSubstr(".ktx2")));
  succeed("bake map.exr --size 32 --brdf-size 16 --format uastc_hdr -o baked");
  EXPECT_THAT(succeed("info baked/specular.ktx2"), HasSubstr("uastc hdr 4x4, 4 mip levels"));
  EXPECT_THAT(refuse(2, "bake map.exr --for filament --size 32 --format uastc_hdr -o of_filament"),
              HasSubstr("Filament reads"));

  write("bright.exr", Image(8, 4, 3, 65505.0f));
  EXPECT_THAT(run("convert bright.exr --to cube --size 4 --format uastc_hdr -o new.ktx2").err,
              AllOf(HasSubstr("uastc_hdr holds 0 to 65504"), HasSubstr("of the light is lost")));
  Image negative(8, 4, 3, 1.0f);
  negative.texel(3, 2)[1] = -0.5f;
  write("negative.exr", negative);
  EXPECT_THAT(run("convert negative.exr --to equirect --size 4 --format uastc_hdr -o new.ktx2").err,
              AllOf(HasSubstr("1 value is negative"), HasSubstr("taken as 0")));
  negative.texel(3, 2)[1] = std::nanf("");
  write("nan.exr", negative);
  EXPECT_THAT(refuse(1, "convert nan.exr --to cube --format uastc_hdr -o nan.ktx2"), HasSubstr("--repair"));
}

TEST_F(ConvertBlocksTest, ACutFileIsOneError) {
  write("map.exr", smoothPanorama());
  for (const std::string file : {"cube.ktx2", "cube.ktx", "cube.dds"}) {
    succeed("convert map.exr --to cube --size 32 --format bc6h -o " + file);
    Bytes cut = bytes(file);
    cut.resize(cut.size() - 1);
    write("cut_" + file, cut);
    EXPECT_THAT(refuse(1, "info cut_" + file), AllOf(StartsWith("cut_" + file), HasSubstr("truncated")));
  }
}

using RenderBlocksTest = RenderCliTest;

TEST_F(RenderBlocksTest, LightsAModel) {
  write("map.exr", smoothPanorama());
  succeed("convert map.exr --to cube --size 64 --format bc6h -o map.dds");
  for (const std::string input : {"map.exr", "map.dds"})
    succeed("render sphere --material mirror -e " + input + " --size 64x48 -o of_" + input.substr(4) + ".exr");
  EXPECT_LT(meanDifference(image("of_dds.exr"), image("of_exr.exr")), 0.01);
}

}  // namespace
}  // namespace mirrorball::testing
