// compare: its numbers, thresholds and refusals.

#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "formula/color.h"

namespace mirrorball::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class CompareTest : public CliTest {
 protected:
  /// Two plain pictures, as linear light that is exactly a code of 8 bits.
  void writeGreys(const std::string& a, int code_a, const std::string& b, int code_b) const {
    const auto lightOf = [](int code) { return formula::linearFromSrgb1(static_cast<float>(code) / 255.0f); };
    write(a, Image(24, 16, 3, lightOf(code_a)));
    write(b, Image(24, 16, 3, lightOf(code_b)));
  }
};

TEST_F(CompareTest, PicturesAreComparedByTheirCodes) {
  writeGreys("a.png", 153, "b.png", 102);
  const json said = json::parse(succeed("compare a.png b.png --json"));
  EXPECT_EQ(said["test"], "a.png");
  EXPECT_EQ(said["reference"], "b.png");
  EXPECT_EQ(said["kind"], "picture");
  EXPECT_EQ(said["size"], json::array({24, 16}));
  EXPECT_NEAR(said["metrics"]["rmse"].get<double>(), 0.2, 1e-6);
  EXPECT_NEAR(said["metrics"]["psnr"].get<double>(), 20.0 * std::log10(5.0), 1e-4);
  EXPECT_NEAR(said["metrics"]["ssim"].get<double>(), (2 * 0.6 * 0.4 + 1e-4) / (0.36 + 0.16 + 1e-4), 1e-6);
  EXPECT_GT(said["metrics"]["flip"].get<double>(), 0.1);
  EXPECT_TRUE(said["metrics"]["alpha"].is_null());
  EXPECT_EQ(said["worst"]["pixel"], json::array({0, 0}));
  EXPECT_EQ(said["thresholds"], json::array());
  EXPECT_FALSE(said.contains("display"));
}

TEST_F(CompareTest, TheTableSaysWhichWayIsBetterAndWhereTheWorstPixelIs) {
  Image image(24, 16, 3, 0.5f);
  write("b.exr", image);
  image.texel(20, 11)[1] = 1e5f;
  write("a.exr", image);
  const std::string said = succeed("compare a.exr b.exr --tone-map aces --exposure=-2");
  EXPECT_THAT(said, StartsWith("a.exr against b.exr\n  images    light of 24x16\n  RMSE "));
  EXPECT_THAT(said, HasSubstr("lower is better; of radiance"));
  EXPECT_THAT(said, HasSubstr("higher is better; as tone mapped (aces, -2 stops)"));
  EXPECT_THAT(said, HasSubstr("pixel (20, 11): 0.5 1e+05 0.5 against 0.5 0.5 0.5"));
  EXPECT_THAT(said, HasSubstr("HDR-FLIP, 0 to 1, 67.02 pixels per degree, 2 exposures from"));
  EXPECT_THAT(said, HasSubstr("\n  PSNR "));
  EXPECT_THAT(said, Not(HasSubstr("alpha")));
}

TEST_F(CompareTest, LightTellsItsExposuresAndDisplay) {
  write("a.exr", smoothPanorama());
  const json said = json::parse(succeed("compare a.exr a.exr --json --ppd 30"));
  EXPECT_EQ(said["kind"], "light");
  EXPECT_EQ(said["metrics"]["rmse"], 0.0);
  EXPECT_TRUE(said["metrics"]["psnr"].is_null()) << "infinite";
  EXPECT_EQ(said["metrics"]["ssim"], 1.0);
  EXPECT_EQ(said["metrics"]["flip"], 0.0);
  EXPECT_EQ(said["flip"]["pixels_per_degree"], 30.0);
  EXPECT_GE(said["flip"]["exposures"]["count"], 2);
  EXPECT_LT(said["flip"]["exposures"]["start"], said["flip"]["exposures"]["stop"]);
  EXPECT_EQ(said["display"]["tone_map"], "neutral");
  EXPECT_THAT(succeed("compare a.exr a.exr"), HasSubstr("infinite"));
}

TEST_F(CompareTest, AThresholdThatIsBrokenIsExitCode1AndOneLine) {
  writeGreys("a.png", 153, "b.png", 102);
  succeed("compare a.png b.png --threshold rmse=0.21 --threshold psnr=13 --threshold alpha=0");
  const Outcome broken = run("compare a.png b.png --threshold rmse=0.1 --threshold psnr=30 --threshold flip=1");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_EQ(broken.err,
            "mirrorball: a.png against b.png: RMSE is 0.2 (at most 0.1), PSNR is 13.98 dB (at least 30.00 dB)\n");
  EXPECT_THAT(broken.out, HasSubstr("RMSE")) << "the numbers are told all the same";
  const Outcome for_programs = run("compare a.png b.png --threshold SSIM=0.99 --threshold flip=1 --json");
  EXPECT_EQ(for_programs.exit_code, 1);
  const json said = json::parse(for_programs.out);
  EXPECT_EQ(said["thresholds"][0], json({{"metric", "ssim"}, {"value", 0.99}, {"kept", false}}));
  EXPECT_EQ(said["thresholds"][1]["kept"], true);
  succeed("compare a.png a.png --threshold psnr=1000 --threshold rmse=0");
}

TEST_F(CompareTest, WhatIsNoThresholdIsWrongUsage) {
  writeGreys("a.png", 153, "b.png", 102);
  EXPECT_THAT(refuse(2, "compare a.png b.png --threshold ssm=0.9"),
              AllOf(HasSubstr("did you mean 'ssim'?"), HasSubstr("rmse, relmse, psnr, ssim, flip, alpha")));
  for (const std::string written : {"flip", "flip=", "flip=wide", "=3", "flip=nan"})
    EXPECT_THAT(refuse(2, "compare a.png b.png --threshold " + written), HasSubstr("threshold")) << written;
  EXPECT_THAT(refuse(2, "compare a.png"), HasSubstr("name the reference too"));
  EXPECT_THAT(refuse(2, "compare"), HasSubstr("mirrorball compare A B"));
  refuse(2, "compare a.png b.png --ppd 2");
  EXPECT_THAT(refuse(2, "compare a.png b.png --exposure 1"), HasSubstr("a.png is a picture for a display already"));
  EXPECT_THAT(refuse(2, "compare a.png b.png --scale 1"), HasSubstr("add --heat-map or --sheet"));
  EXPECT_THAT(refuse(2, "compare a.png b.png --map flip --scale 1 --sheet s.png"), HasSubstr("goes from 0 to 1"));
}

TEST_F(CompareTest, ResizeBringsTheFirstToTheSecondsSize) {
  write("large.exr", Image(30, 20, 3, 0.5f));
  write("small.exr", Image(12, 8, 3, 0.25f));
  const Outcome outcome = run("compare large.exr small.exr --resize --json");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "mirrorball: note: large.exr: resized from 30x20 to 12x8\n");
  EXPECT_THAT(outcome.out, HasSubstr("\"rmse\": 0.25"));
  EXPECT_EQ(succeed("compare small.exr small.exr --resize"), succeed("compare small.exr small.exr"));
}

TEST_F(CompareTest, SizesAndKindsThatDifferAreTold) {
  writeGreys("a.png", 153, "b.png", 102);
  write("small.png", Image(12, 16, 3, 0.5f));
  write("light.exr", Image(24, 16, 3, 0.5f));
  EXPECT_EQ(refuse(1, "compare a.png small.png"),
            "a.png against small.png: their sizes differ, 24x16 and 12x16; bring them to one size first, or --resize "
            "the first");
  EXPECT_EQ(refuse(1, "compare a.png light.exr"),
            "a.png is a picture for a display (PNG, 8 bit) and light.exr is linear light (OpenEXR, float, ZIP); their "
            "numbers mean different things: compare two of a kind");
  EXPECT_THAT(refuse(1, "compare a.png none.png"), StartsWith("none.png: "));
}

TEST_F(CompareTest, BadTexelsAreCountedAndRepairedOnDemand) {
  Image bad(24, 16, 3, 0.5f);
  write("b.exr", bad);
  bad.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  bad.texel(9, 2)[1] = std::numeric_limits<float>::infinity();
  write("a.exr", bad);
  for (const std::string files : {"a.exr b.exr", "b.exr a.exr"})
    EXPECT_EQ(refuse(1, "compare " + files),
              "a.exr: 2 texels are NaN or infinite, the first at (3, 1); --repair replaces them by their neighbours");
  const Outcome repaired = run("compare a.exr b.exr --repair --threshold rmse=0");
  EXPECT_EQ(repaired.exit_code, 0) << repaired.err;
  EXPECT_EQ(repaired.err,
            "mirrorball: note: a.exr: 2 texels are NaN or infinite, the first at (3, 1); compared as the "
            "mean of their neighbours\n");
}

TEST_F(CompareTest, CoverageIsAMetricOfItsOwn) {
  Image image(24, 16, 4, 1.0f);
  write("opaque.png", image);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 12; ++x) image.texel(x, y)[3] = 0.0f;
  write("half.png", image);
  const Outcome outcome = run("compare half.png opaque.png --json");
  EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: note: "), HasSubstr("alpha")));
  EXPECT_NEAR(json::parse(outcome.out)["metrics"]["alpha"].get<double>(), std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(json::parse(outcome.out)["metrics"]["rmse"].get<double>(), std::sqrt(0.5), 1e-6) << "over black";
  EXPECT_EQ(run("compare half.png opaque.png --threshold alpha=0.5").exit_code, 1);
  succeed("compare half.png half.png --quiet --threshold alpha=0");
}

TEST_F(CompareTest, OnePixelHasAllButSsim) {
  write("a.png", Image(1, 1, 3, 1.0f));
  write("b.png", Image(1, 1, 3, 0.0f));
  EXPECT_THAT(succeed("compare a.png b.png"), HasSubstr("its window of 11x11 pixels does not fit"));
  const json said = json::parse(succeed("compare a.png b.png --json --threshold flip=0.97"));
  EXPECT_TRUE(said["metrics"]["ssim"].is_null());
  EXPECT_NEAR(said["metrics"]["flip"].get<double>(), 0.967388, 1e-6) << "black against white, as published";
  EXPECT_THAT(run("compare a.png b.png --threshold ssim=0.5").err, EndsWith("leave its threshold out\n"));
}

TEST_F(CompareTest, OneOfThemMayComeFromStandardInput) {
  writeGreys("a.png", 153, "b.png", 102);
  const std::string said = succeed("compare - b.png", {.input = bytes("a.png")});
  EXPECT_THAT(said, StartsWith("standard input against b.png\n"));
  EXPECT_EQ(said.substr(said.find('\n')),
            succeed("compare a.png b.png").substr(std::string("a.png against b.png").size()));
}

TEST_F(CompareTest, AnyNumberOfThreadsGivesTheSameNumbers) {
  write("a.exr", noisyPanorama());
  write("b.exr", Image(512, 256, 3, 0.5f));
  EXPECT_EQ(succeed("compare a.exr b.exr --json --threads 1"), succeed("compare a.exr b.exr --json --threads 3"));
}

}  // namespace
}  // namespace mirrorball::testing
