// Wrong usage: one clear line each, which names the option as it is typed and says what is right; exit code 2.

#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Adds `words` to the command line of a small picture or map, which must be refused; returns the line.
class BadOptionTest : public RenderCliTest {
 protected:
  std::string refuseRender(const std::string& words) const {
    return refuse(2, withUsual("render none -e white -o out.png " + words, {"--size 8x8"}));
  }
  std::string refuseConvert(const std::string& words) const {
    return refuse(2, withUsual("convert white -o out.exr " + words, {"--to cube", "--size 4"}));
  }
};

TEST_F(BadOptionTest, AColourWithoutItsHashIsNoGrey) {
  EXPECT_THAT(refuseRender("--background 336699"), HasSubstr("'#336699'"));
}

TEST_F(BadOptionTest, NothingTurnsInOnePicture) { EXPECT_THAT(refuseRender("--turn model"), HasSubstr("--frames")); }

TEST_F(BadOptionTest, SixFacesAreNoPanorama) {
  succeed("convert uv --to cube --size 8 -o cube.ktx2");
  EXPECT_THAT(refuse(1, "convert cube.ktx2 --from equirect --to sphere -o out.exr"), HasSubstr("six faces"));
  EXPECT_THAT(refuse(1, "info cube.ktx2 --from sphere"), HasSubstr("cube or eac"));
}

TEST_F(BadOptionTest, AnUnknownOptionSuggestsTheNearest) {
  EXPECT_THAT(refuseRender("--siez 4x4"), AllOf(HasSubstr("--siez"), HasSubstr("did you mean --size?")));
  EXPECT_THAT(refuseRender("--envrotation=3"), AllOf(HasSubstr("--envrotation"), HasSubstr("--env-rotation")));
  EXPECT_THAT(refuseRender("--siz 4x4"), HasSubstr("--size")) << "an option is not abbreviated";
  EXPECT_THAT(refuseRender("--zzzzzzzz"), AllOf(HasSubstr("--zzzzzzzz"), HasSubstr("--help")));
  EXPECT_THAT(refuseConvert("--lay-out faces"), HasSubstr("--layout"));
  EXPECT_THAT(refuse(2, "info white --dirction 1,0,0"), HasSubstr("--direction"));
  EXPECT_THAT(refuseRender("-x"), HasSubstr("-x"));
}

TEST_F(BadOptionTest, BehindTwoDashesAllAreArguments) {
  write("-dash.exr", smoothPanorama());
  EXPECT_THAT(succeed("info -- -dash.exr"), HasSubstr("-dash.exr\n"));
  succeed("convert --to cube --size 8 -o out.exr -- -dash.exr");
  EXPECT_THAT(refuse(2, "info --"), HasSubstr("name an input map"));
}

TEST_F(BadOptionTest, AFileWithADashIsNamedByItsFolder) {
  write("-dash.exr", smoothPanorama());
  for (const std::string command : {"info", "convert -o out.exr", "render -o out.png", "info white"})
    EXPECT_THAT(refuse(2, command + " -dash.exr"), HasSubstr("for the file of that name say ./-dash.exr")) << command;
  succeed("info ./-dash.exr");
  EXPECT_THAT(refuse(2, "info --dash.exr"), AllOf(HasSubstr("no option --dash.exr"), Not(HasSubstr("./"))));
}

TEST_F(BadOptionTest, AnEmptyNameIsNone) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(refuse(2, Words{"render", "none", "--env", "", "-o", "a.png"}),
            "--env needs a file name; it was given '', which is empty");
  EXPECT_THAT(refuse(2, Words{"convert", "white", "--to", "", "-o", "a.exr"}), HasSubstr("--to needs a value"));
  EXPECT_EQ(refuse(2, Words{"convert", "", "-o", "a.exr"}), "IN was given '', which is empty; name an input map");
  EXPECT_THAT(refuse(2, Words{"render", "", "-o", "a.png"}), HasSubstr("MODEL was given '', which is empty; "));
}

TEST_F(BadOptionTest, ACameraIsANameOrAngles) {
  for (const std::string name : {"nan", "inf", "front"})
    EXPECT_EQ(refuse(2, "render sphere -e white --size 8x8 -o a.png --camera " + name),
              "the model has no cameras of its own, so none is named '" + name +
                  "'; give --camera AZIMUTH,ELEVATION, as in --camera 30,15");
}

TEST_F(BadOptionTest, ACameraSeesAsFarAsFloatsTellDepthsApart) {
  const std::string line = "render sphere -e white --size 8x8 -o a.png ";
  for (const std::string options : {"--camera 0,0,1e30", "--target 1e30,0,0", "--camera 0,0,1e30 --reference",
                                    "--target 0,1.1e6,0 --camera 0,0,3 --orthographic 2"})
    EXPECT_THAT(refuse(2, line + options), AllOf(HasSubstr("the camera is "), HasSubstr("radii away from the model")))
        << options;
  succeed(line + "--camera 0,0,9e5");
}

TEST_F(BadOptionTest, AFilmIsMadeOfPictures) {
  EXPECT_THAT(refuse(2, "render none -e white -o turn.mp4"),
              AllOf(HasSubstr("--frames 90 -o turn_%04d.png"), HasSubstr("ffmpeg")));
}

TEST_F(BadOptionTest, AnAddressIsNotFetched) {
  EXPECT_THAT(refuse(1, "convert https://example.org/a.hdr --to cube -o out.exr"),
              HasSubstr("https://example.org/a.hdr: nothing is downloaded; curl -L https://example.org/a.hdr | "));
  EXPECT_THAT(refuse(1, "render http://example.org/a.glb -e white -o out.png"), HasSubstr("nothing is downloaded"));
}

TEST_F(BadOptionTest, StandardInputIsOneFile) {
  EXPECT_THAT(refuse(2, "render - -e - -o out.png"), HasSubstr("- is given 2 times, and standard input is one file"));
}

TEST_F(BadOptionTest, AnUnknownCommandSuggestsTheRightOnes) {
  EXPECT_THAT(refuse(2, "rendr"), AllOf(HasSubstr("rendr"), HasSubstr("render")));
  EXPECT_THAT(refuse(2, "--verison"), AllOf(HasSubstr("--verison"), HasSubstr("--version")));
  EXPECT_THAT(refuse(2, std::vector<std::string>{}), AllOf(HasSubstr("render"), HasSubstr("--help")));
}

TEST_F(BadOptionTest, TooManyArgumentsOrTooFew) {
  EXPECT_THAT(refuse(2, "render none sphere -e white -o out.png"), HasSubstr("'sphere'"));
  EXPECT_THAT(refuse(2, "reference all"), HasSubstr("'all'"));
  EXPECT_THAT(refuse(2, "render none convert"), HasSubstr("'convert'")) << "one command at a time";
  EXPECT_THAT(refuse(2, "info"), HasSubstr("FILE"));
  EXPECT_THAT(refuse(2, "convert --to cube -o out.exr"), HasSubstr("IN"));
  EXPECT_THAT(refuse(2, "convert white -o out.exr"), AllOf(HasSubstr("--to"), HasSubstr("equirect|sphere")));
  EXPECT_THAT(refuse(2, "convert white --to cube"), HasSubstr("-o"));
  EXPECT_THAT(refuseRender("--env-rotation"), HasSubstr("--env-rotation"));
}

TEST_F(BadOptionTest, AnOptionIsNoValue) {
  EXPECT_THAT(refuse(2, "render sphere -e white --background -o y.png"),
              AllOf(HasSubstr("--background needs a value: env|blur|COLOR|transparent"), HasSubstr("'-o'")));
  EXPECT_THAT(refuseRender("--set --exposure 1"),
              AllOf(HasSubstr("--set needs a value: KEY=VALUE"), HasSubstr("'--exposure'")));
  EXPECT_THAT(refuse(2, "convert white --to -o out.exr"), HasSubstr("--to needs a value: PROJECTION"));
  EXPECT_THAT(refuse(2, "convert white --to cube -o --size 8"), HasSubstr("--output needs a file name"));
  EXPECT_THAT(refuse(2, "info white --direction --json"), HasSubstr("--direction needs a value: X,Y,Z"));
}

TEST_F(BadOptionTest, ANegativeNumberIsAValue) {
  succeed(
      "render sphere -e white --size 8x8 -o out.png --camera -30,10 --exposure -1 --set bump_height=-0.5 "
      "--target -1,-2,-.5 --light -1,2,3,1,1,1 --env-rotation -10,-20");
  succeed("convert white --to cube --size 4 -o out.exr --rotate -90 --face-order -x+x+y-y+z-z --centre -1,0,0");
}

TEST_F(BadOptionTest, WhatCountsOnceIsNotGivenTwice) {
  EXPECT_THAT(refuseRender("--output a.png"), HasSubstr("--output is given twice, as 'out.png' and as 'a.png'"));
  EXPECT_THAT(refuseRender("--rotate 1 --env-rotation 2"), HasSubstr("--env-rotation is given twice"));
  EXPECT_THAT(refuseRender("--fov 20 --fov 30 --fov 40"), HasSubstr("--fov is given 3 times"));
  EXPECT_THAT(refuseRender("--orthographic 2 --orthographic 3"), HasSubstr("--orthographic is given twice"));
  EXPECT_THAT(refuseConvert("--size 8 --size 8"), HasSubstr("--size is given twice"));
  EXPECT_THAT(refuse(2, "bake white -o out --levels 2 --levels 3"), HasSubstr("--levels is given twice"));
  EXPECT_THAT(refuse(2, "capture none --at 0,0,0 --at 1,1,1 -o out.exr"), HasSubstr("--at is given twice"));
  EXPECT_THAT(refuse(2, "info white --from cube --from cube"), HasSubstr("--from is given twice"));
  EXPECT_THAT(refuse(2, "photo white -o a.exr --circle 1,1,1 --circle 1,1,2"), HasSubstr("--circle is given twice"));
  EXPECT_THAT(refuse(2, "reference --format man --format bash"), HasSubstr("--format is given twice"));
  succeed("render none -e white --size 8x8 -o out.png --quiet --quiet --set ior=1.4 --set ior=1.5");
}

TEST_F(BadOptionTest, ANumberOutOfRangeIsToldWithBothLimits) {
  for (const std::string number : {"1e35", "1e-35", "-1"})
    EXPECT_THAT(refuseConvert("--scale-light " + number), HasSubstr("(1e-30 … 1e+30)")) << number;
  EXPECT_THAT(refuseRender("--target 1e35,0,0"), HasSubstr("in world units (-1e+30 … 1e+30)"));
  EXPECT_THAT(refuseRender("--light 1e35,0,0,1,1,1"), HasSubstr("in world units and radiance (-1e+30 … 1e+30)"));
  EXPECT_THAT(refuseRender("--light 1,2,3"), Not(HasSubstr("1e+30"))) << "no number is too large";
  EXPECT_THAT(refuseRender("--camera 0,91"), HasSubstr("-90 to 90 degrees"));
  EXPECT_THAT(refuseRender("--camera 0,0,0"), HasSubstr("above 0, in model radii"));
  EXPECT_THAT(refuseRender("--background 1,2,1e7"), HasSubstr("R,G,B (0 … 1000000)"));
  EXPECT_THAT(refuseConvert("--max-memory 1e40"), HasSubstr("1e40"));
  EXPECT_THAT(refuse(2, "info white --threads 99999"), HasSubstr("(0 … 1024)"));
}

TEST_F(BadOptionTest, AWrongNameListsTheRightOnes) {
  const std::string material = refuseRender("--material glas");
  EXPECT_THAT(material, AllOf(HasSubstr("'glas'"), HasSubstr("did you mean 'glass'?")));
  for (const std::string_view name : materialNames()) EXPECT_THAT(material, HasSubstr(name));
  const std::string parameter = refuseRender("--set metalic=1");
  EXPECT_THAT(parameter, AllOf(HasSubstr("'metalic'"), HasSubstr("did you mean 'metallic'?")));
  for (const Option<Material>& right : materialParameters()) EXPECT_THAT(parameter, HasSubstr(right.text.name));
  EXPECT_THAT(refuseRender("--set bump=orang"), AllOf(HasSubstr("'orang'"), HasSubstr("none, orange")));
  EXPECT_THAT(refuseConvert("--to sphre"),
              AllOf(HasSubstr("'sphere'"), HasSubstr("equirect, sphere, angular, cube, ball")));
  EXPECT_THAT(refuseConvert("--layout cross"), HasSubstr("faces, hcross, vcross, hstrip, vstrip, 3x2"));
  EXPECT_THAT(refuseConvert("--from bowl"),
              AllOf(HasSubstr("equirect, sphere, angular, cube, ball"), HasSubstr("faces, hcross")));
}

// The sentence names the option once, and reads as one.
TEST_F(BadOptionTest, AWrongChoiceListsTheRightOnes) {
  EXPECT_THAT(refuseRender("--tone-map agxx"), AllOf(HasSubstr("'agxx'"), HasSubstr("did you mean 'agx'?"),
                                                     HasSubstr("agx, aces, neutral, reinhard, linear")));
  for (const std::string words :
       {"--tone-map agxx", "--mapping cube", "--reflect-at pixel", "--fresnel no", "--texgen cylinder"})
    EXPECT_THAT(refuseRender(words), AllOf(HasSubstr(words.substr(2, words.find(' ') - 2)), Not(HasSubstr("--no "))));
}

TEST_F(BadOptionTest, AWrongNumberIsToldWithWhatIsRight) {
  struct Case {
    const char* words;
    const char* right;
  };
  for (const Case& wrong : {Case{"--size 0x10", "WIDTHxHEIGHT"},
                            Case{"--size 10x", "WIDTHxHEIGHT"},
                            Case{"--size 20000x10", "16384"},
                            Case{"--size -4x4", "WIDTHxHEIGHT"},
                            Case{"--samples 0", "1 … 4096"},
                            Case{"--samples 1.5", "whole number"},
                            Case{"--fov 0", "1 … 170"},
                            Case{"--fov nan", "1 … 170"},
                            Case{"--fov inf", "1 … 170"},
                            Case{"--fov 35deg", "1 … 170"},
                            Case{"--camera 1", "2 to 3 numbers"},
                            Case{"--camera 1,2,3,4", "2 to 3 numbers"},
                            Case{"--camera 1,100", "-90 to 90"},
                            Case{"--camera 1,2,0", "above 0"},
                            Case{"--target 1,2", "3 numbers"},
                            Case{"--texture-matrix 1,0,0,1", "16 numbers"},
                            Case{"--orthographic -1", "0 … 10000"},
                            Case{"--exposure 1000", "-30 … 30"},
                            Case{"--env-intensity -1", "0 …"},
                            Case{"--background green", "#rrggbb"},
                            Case{"--background #12345", "#rrggbb"},
                            Case{"--background 1,-1,0", "#rrggbb"},
                            Case{"--light 1,2,3", "6 numbers"},
                            Case{"--light 1,2,3,nan,1,1", "6 numbers"},
                            Case{"--frames -1", "whole number"},
                            Case{"--frames 2.5", "whole"}}) {
    const std::string words = wrong.words;
    const std::string option = words.substr(0, words.find(' '));
    const std::string value = words.substr(words.find(' ') + 1);
    EXPECT_THAT(refuseRender(words), AllOf(HasSubstr(option + " "), HasSubstr(wrong.right))) << words;
  }
  for (const std::string size : {"-3", "40000", "1.5", "wide"})
    EXPECT_THAT(refuseConvert("--size " + size), AllOf(HasSubstr("--size "), HasSubstr("0 … 32768")));
  for (const std::string direction : {"0,0,0", "1,2", "a,b,c", "1,2,nan"})
    EXPECT_THAT(refuse(2, "info white --direction " + direction), HasSubstr("--direction "));
}

TEST_F(BadOptionTest, AWrongParameterIsToldWithItsRange) {
  EXPECT_THAT(refuseRender("--set metallic=2"), AllOf(HasSubstr("metallic"), HasSubstr("0 … 1"), HasSubstr("'2'")));
  EXPECT_THAT(refuseRender("--set metallic"), HasSubstr("metallic=0"));
  EXPECT_THAT(refuseRender("--set metallic="), HasSubstr("metallic"));
  EXPECT_THAT(refuseRender("--set base_color=1,2"), HasSubstr("base_color"));
  EXPECT_THAT(refuseRender("--set double_sided=maybe"), HasSubstr("yes or no"));
}

TEST_F(BadOptionTest, AWrongParameterOfTheSkyIsToldToo) {
  const auto refuseSky = [&](const std::string& sky) { return refuse(2, "info sky:" + sky); };
  EXPECT_THAT(refuseSky("elevatoin=3"), AllOf(HasSubstr("'elevation'"), HasSubstr("turbidity")));
  EXPECT_THAT(refuseSky("elevation=100"), AllOf(HasSubstr("elevation"), HasSubstr("0 … 90")));
  EXPECT_THAT(refuseSky("elevation"), AllOf(HasSubstr("elevation="), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(refuse(2, "info white:elevation=3"), HasSubstr("takes no parameters"));
}

TEST_F(BadOptionTest, AnOptionAfterTheEndOfOptionsIsToldToStandBefore) {
  EXPECT_THAT(refuse(2, "render -- sphere --size 8x8 -o a.png"), HasSubstr("stands after --"));
}

TEST_F(BadOptionTest, ALightMayBeRepeatedEightTimes) {
  std::string words;
  for (int light = 0; light < 8; ++light) words += " --light 0,0,5,1,1,1";
  succeed("render none -e white --size 8x8 -o eight.png" + words);
  EXPECT_THAT(refuseRender(words + " --light 0,0,5,1,1,1"), AllOf(HasSubstr("--light"), HasSubstr("8 times")));
}

}  // namespace
}  // namespace mirrorball::testing
