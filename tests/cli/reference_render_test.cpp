// render --reference: the path tracer from outside.

#include <cmath>
#include <csignal>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using ReferenceRenderTest = CliTest;
using ReferenceAgainstRendererTest = RenderCliTest;

/// Peak signal-to-noise ratio of two pictures of light, each value cut off at white [dB].
double psnr(const Image& a, const Image& b) {
  double squares = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const glm::vec3 difference = glm::min(rgbAt(a, x, y), 1.0f) - glm::min(rgbAt(b, x, y), 1.0f);
      squares += double(glm::dot(difference, difference)) / 3.0;
    }
  return 10.0 * std::log10(double(a.width()) * a.height() / squares);
}

TEST_F(ReferenceRenderTest, WritesAPictureAndSaysHowGoodItIs) {
  const std::string line = "render sphere --reference --size 32x24 --samples 8 -e white -o ";
  EXPECT_THAT(trace(line + "ball.png"),
              ContainsRegex("^8 paths a pixel, standard error at most [0-9.e-]+ of white\n$"));
  trace(line + "again.png");
  EXPECT_EQ(bytes("ball.png"), bytes("again.png"));
  trace(line + "ball.exr --background transparent");
  const Image ball = image("ball.exr");
  EXPECT_EQ(ball.texel(0, 0)[3], 0.0f);
  EXPECT_NEAR(ball.texel(16, 12)[3], 1.0f, 1e-6f);
}

TEST_F(ReferenceRenderTest, StopsWhenThePictureIsGoodEnough) {
  const std::string line = "render sphere --reference --size 24x24 -e studio -o ball.png ";
  const auto pathsOf = [&](const std::string& options) { return std::stoi(trace(line + options)); };
  const int coarse = pathsOf("--noise 0.02"), fine = pathsOf("--noise 0.006");
  EXPECT_GE(coarse, 16);
  EXPECT_GT(fine, 3 * coarse);
  EXPECT_GE(pathsOf("--time 0.2"), 1);
  EXPECT_EQ(pathsOf("--noise 0.5 --samples 4"), 4);
}

// A convex mirror: what an environment map can know is all that there is.
TEST_F(ReferenceAgainstRendererTest, AgreesWhereTheRendererIsExact) {
  succeed("convert studio --to cube --size 256 --format float32 -o room.ktx2");
  const std::string line = "render sphere --material mirror -e room.ktx2 --size 96x96 --samples 64 ";
  succeed(line + "-o drawn.exr");
  trace(line + "--reference --bounces 1 --unoccluded -o traced.exr");
  EXPECT_GE(psnr(image("drawn.exr"), image("traced.exr")), 45.0);
}

// Phong's lights are the same formula in both; on a ball, which casts no shadow on itself where the lights reach it.
TEST_F(ReferenceAgainstRendererTest, PointLightsAreTheSame) {
  write("dark.exr", Image(8, 4, 3, 0.0f));
  const std::string line =
      "render sphere --material plastic --set perceptual_roughness=0.4 -e dark.exr --light 3,4,3,0.8,0.7,0.6 "
      "--light -3,1,2,0.1,0.3,0.6 --size 96x96 --samples 64 ";
  succeed(line + "-o drawn.exr");
  run(line + "--reference --bounces 1 --unoccluded -o traced.exr");
  EXPECT_GE(psnr(image("drawn.exr"), image("traced.exr")), 45.0);
}

// What a thin wall does not reflect of one colour it does not let through of any other.
TEST_F(ReferenceAgainstRendererTest, TintedReflectionsAreTheSame) {
  succeed("convert studio --to cube --size 256 --format float32 -o room.ktx2");
  const std::string line =
      "render sphere -e room.ktx2 --set specular_color=12,5,1 --set perceptual_roughness=0 --set base_color=1 "
      "--set transmission=1 --set thin_walled=yes --size 96x96 --samples 64 ";
  succeed(line + "-o drawn.exr");
  run(line + "--reference --bounces 1 --unoccluded -o traced.exr");
  EXPECT_GE(psnr(image("drawn.exr"), image("traced.exr")), 40.0);
}

/// Squares of a sheet of glass with a front alone: one that faces +Z, and half a unit behind it one that faces −Z.
std::string paneOfTwoSheets() {
  GltfMaker maker;
  maker.accessor(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR");
  return maker.gltf(R"({"attributes":{"POSITION":0},"indices":1,"material":0})",
                    R"("nodes":[{"mesh":0},{"mesh":0,"translation":[0,0,-0.5],"rotation":[0,1,0,0]}],"materials":[)"
                    R"({"pbrMetallicRoughness":{"baseColorFactor":[0.8,0.5,0.3,1],"metallicFactor":0,)"
                    R"("roughnessFactor":0},"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}}])");
}

// A sheet that has no back is not there for an eye behind it, nor for one that sees it through another sheet.
TEST_F(ReferenceAgainstRendererTest, SheetsOfGlassAreTheSameFromBehind) {
  write("pane.gltf", paneOfTwoSheets());
  succeed("convert studio --to cube --size 256 --format float32 -o studio.ktx2");
  const std::string plane =
      "plane --set transmission=1 --set thin_walled=yes --set perceptual_roughness=0 "
      "--set base_color=0.8,0.5,0.3 --set double_sided=";
  for (const std::string& model : {plane + "no", plane + "yes", std::string("pane.gltf")})
    for (const char* camera : {"20,30", "200,-30"}) {
      const std::string line = "render " + model + " -e studio.ktx2 --camera " + camera + " --size 48x48 --samples 64 ";
      succeed(line + "-o drawn.exr");
      run(line + "--reference -o traced.exr");
      EXPECT_GE(psnr(image("drawn.exr"), image("traced.exr")), 35.0) << line;
    }
}

// What lies behind the side of a stone that faces the eye is hidden, and no part of what a pixel sees of the stone.
TEST_F(ReferenceAgainstRendererTest, StonesSeenFromLowAreWhatPathsMeet) {
  const std::string line =
      "render plane --set base_color=0.4 --set height=cobbles --camera 30,10,2.5 --size 40x30 -e sky "
      "--background transparent ";
  trace(line + "--relief exact --reference --samples 64 -o traced.exr");
  const Image traced = image("traced.exr");
  const auto psnrOf = [&](const std::string& relief) {
    succeed(line + "--samples 16 -o drawn.exr --relief " + relief);
    return psnr(image("drawn.exr"), traced);
  };
  EXPECT_GE(psnrOf("linear-binary"), 17.5);
  EXPECT_GE(psnrOf("exact"), 21.0);
}

TEST_F(ReferenceAgainstRendererTest, AnUnlitSurfaceShowsItsColour) {
  const std::string line =
      "render sphere --material glass --set unlit=yes --set base_color=0.125,0.5,1 --light 1,1,9,1,1,1 -e studio "
      "--size 32x32 --samples 4 -o ball.exr";
  for (const char* how : {"", " --reference"}) {
    run(line + how);
    EXPECT_EQ(rgbAt(image("ball.exr"), 16, 16), glm::vec3(0.125f, 0.5f, 1.0f)) << how;
  }
}

TEST_F(ReferenceRenderTest, LayersAreForDenoisers) {
  run("render sphere --material gold --reference --layers --size 32x24 --samples 8 -o ball.exr");
  const Bytes file = bytes("ball.exr");
  const std::string text(file.begin(), file.end());
  for (const char* channel : {"albedo.R", "normal.X", "variance.B"}) EXPECT_THAT(text, HasSubstr(channel));
  EXPECT_EQ(image("ball.exr").channels(), 4);
}

// A prism that mirrors nothing sends each ray one way, which depends on the wavelength and not on the renderer.
TEST_F(ReferenceAgainstRendererTest, AgreesOnTheIndexOfAWavelength) {
  const std::string prism = "render prism --material sf11 --set specular=0 --camera 70,-30 --size 48x36 --samples 16 ";
  const auto drawn = [&](const std::string& wavelength) {
    succeed(prism + "--refraction traced --resolve radiance --wavelength " + wavelength + " -o drawn.exr");
    return image("drawn.exr");
  };
  trace(prism + "--reference --wavelength 400 -o traced.exr");
  const Image traced = image("traced.exr");
  const double violet = psnr(drawn("400"), traced), red = psnr(drawn("700"), traced);
  EXPECT_GT(violet, red + 10.0) << violet << " dB, " << red << " dB";
}

TEST_F(ReferenceRenderTest, WhatDoesNotGoTogetherIsRefused) {
  EXPECT_THAT(refuse(2, "render sphere --bounces 2"), HasSubstr("--bounces is for the reference; add --reference"));
  const std::string line = "render sphere --reference -o ball.png ";
  EXPECT_THAT(refuse(2, line + "--frames 8"), HasSubstr("--frames: the reference makes one picture"));
  EXPECT_THAT(refuse(2, line + "--layers"), HasSubstr("write an .exr"));
  EXPECT_THAT(refuse(2, line + "--noise 0"), HasSubstr("noise"));
  EXPECT_THAT(refuse(2, line + "--time 0"), HasSubstr("time"));
  EXPECT_THAT(refuse(2, line + "--bounces 0"), HasSubstr("bounces"));
  EXPECT_THAT(refuse(2, line + "--unoccluded"), HasSubstr("add --bounces 1"));
  EXPECT_THAT(refuse(2, line + "--wavelength 900"), HasSubstr("380 … 780"));
  EXPECT_THAT(files(), ElementsAre());
}

// The same line with --reference added shows the truth beside a picture.
TEST_F(ReferenceRenderTest, TakesEveryOptionOfThePictureBesideIt) {
  const std::string line = "render sphere --reference --size 8x8 --samples 1 -o ball.png";
  EXPECT_THAT(
      trace(line + " --quality good --blur mip --texture-filter nearest --self-reflection --refraction traced "
                   "--inner-bounces 2 --background blur"),
      StartsWith(
          "mirrorball: note: --blur, --texture-filter, --self-reflection, --quality, --refraction, --inner-bounces and "
          "--background blur change nothing: the reference shows what is right in any case\n1 path a pixel, "));
  EXPECT_THAT(trace(line + " --proxy ground --background transparent"), StartsWith("1 path a pixel, "));
}

TEST_F(ReferenceRenderTest, AnInterruptionLeavesThePictureSoFar) {
  Program program({.arguments = Arguments("render teapot --reference --size 2048x32 --samples 4096 -o pot.png").words,
                   .folder = path(""),
                   .on_terminal = true});
  program.waitUntilShown("reference, standard error");  // of the first pass
  ASSERT_TRUE(program.running()) << "it was done before it could be interrupted";
  program.interrupt();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.signal, SIGINT) << "ended with " << outcome.exit_code;
  EXPECT_THAT(outcome.err, HasSubstr("mirrorball: interrupted; pot.png is the picture so far: "));
  EXPECT_EQ(image("pot.png").width(), 2048);
}

TEST_F(ReferenceRenderTest, ASceneWithoutLightIsBlackAndOneWithoutAModelIsItsEnvironment) {
  write("dark.exr", Image(8, 4, 3, 0.0f));
  trace("render sphere --reference -e dark.exr --size 16x16 --samples 4 -o dark.png");
  EXPECT_EQ(image("dark.png").texel(8, 8)[1], 0.0f);
  trace("render none --reference -e white --size 16x16 --samples 4 -o none.exr");
  EXPECT_NEAR(image("none.exr").texel(8, 8)[1], 1.0f, 1e-5f);
}

}  // namespace
}  // namespace mirrorball::testing
