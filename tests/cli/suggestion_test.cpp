// What is said of words that are none of ours, but mean one: never a wrong one.

#include <string>
#include <vector>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

struct Meant {
  const char* line;
  const char* hint;
};

class SuggestionTest : public CliTest {
 protected:
  void expectHints(const std::vector<Meant>& lines) const {
    for (const auto& [line, hint] : lines) EXPECT_THAT(refuse(2, line), HasSubstr(hint)) << line;
  }
};

TEST_F(SuggestionTest, AnOptionOfAnotherProgramIsKnown) {
  expectHints({{"convert a.hdr --projection cube -o b.ktx2", "did you mean --to?"},
               {"convert a.hdr --type=cubemap -o b.ktx2", "did you mean --to?"},
               {"convert a.hdr --resolution 512 -o b.ktx2", "did you mean --size?"},
               {"convert a.hdr --dstFaceSize 512 -o b.ktx2", "did you mean --size?"},
               {"convert a.hdr --genmipmap -o b.ktx2", "did you mean --mips?"},
               {"convert a.hdr --mip-level 2 -o b.exr", "did you mean --level?"},
               {"bake a.hdr --mipCount 5 -o b", "did you mean --levels?"},
               {"bake a.hdr --deploy b", "did you mean --output?"},
               {"render --resolution 64x64", "did you mean --size?"},
               {"render --envmap a.hdr", "did you mean --env?"},
               {"render --environment a.hdr", "did you mean --env?"},
               {"render --hdri-file=a.hdr", "did you mean --env?"},
               {"render --anti_aliasing 4", "did you mean --samples?"},
               {"render --background-color 1,1,1", "did you mean --background?"},
               {"render --camera-position 0,0,4", "did you mean --camera?"},
               {"capture --camera-position 0,0,4", "did you mean --at?"}});
}

TEST_F(SuggestionTest, AParameterOfMaterialsIsSet) {
  expectHints({{"render --roughness 0.3", "did you mean --set perceptual_roughness=?"},
               {"capture --roughness 0.3", "did you mean --set perceptual_roughness=?"},
               {"render --ior 1.5", "did you mean --set ior=?"},
               {"render --base-color 1,0,0", "did you mean --set base_color=?"},
               {"render --color 1,0,0", "did you mean --set base_color=?"},
               {"render --texture a.png", "did you mean --set base_color_map=?"}});
}

TEST_F(SuggestionTest, AParameterMayBeMisspelt) {
  expectHints({{"render --roughnes 0.3", "did you mean --set perceptual_roughness= or --ground-roughness?"},
               {"render --metalnes 1", "did you mean --set metallic=?"},
               {"render --transmision 1", "did you mean --set transmission=?"},
               {"render --basecolour 1,0,0", "did you mean --set base_color=?"},
               {"render --exposur 1", "did you mean --exposure?"},
               {"render --sampels 4", "did you mean --samples?"}});
  EXPECT_THAT(refuse(2, "render --scale 2"), Not(HasSubstr("_scale")));
}

TEST_F(SuggestionTest, AnInputHasNoOption) {
  expectHints({{"convert --input a.hdr -o b.exr", "name it without an option: mirrorball convert IN…"},
               {"convert -i a.hdr -o b.exr", "name it without an option: mirrorball convert IN…"},
               {"bake b.hdr --env a.hdr -o b", "name it without an option: mirrorball bake ENV…"},
               {"info b.hdr --environment a.hdr", "name it without an option: mirrorball info FILE…"},
               {"render --model a.glb", "name it without an option: mirrorball render [MODEL]"}});
}

TEST_F(SuggestionTest, WhatNothingMeansIsNotSuggested) {
  for (const std::string line :
       {"convert a.hdr --json", "bake a.hdr --projection cube", "bake a.hdr --roughness 1", "bake a.hdr --exposure 1",
        "reference --input a", "reference --env a", "render --wireframe", "info a.hdr --size 3", "render --flip both"})
    EXPECT_THAT(refuse(2, line), AllOf(StartsWith("there is no option --"), Not(HasSubstr("did you mean")),
                                       Not(HasSubstr("without an option"))))
        << line;
}

TEST_F(SuggestionTest, WhatThereIsNotIsTold) {
  expectHints({{"render --aperture 2.8", "pictures are in focus at all distances"},
               {"render --motion-blur 1", "motion blur is not simulated"}});
}

TEST_F(SuggestionTest, AMaterialsParameterMayHaveAnothersName) {
  expectHints({{"render --set metalness=1", "did you mean 'metallic'?"},
               {"render --set Albedo=1", "did you mean 'base_color'?"},
               {"render --set ao-map=a.png", "did you mean 'occlusion_map'?"}});
}

TEST_F(SuggestionTest, AMisspeltValueIsSuggested) {
  EXPECT_THAT(refuse(1, "info sutdio"), HasSubstr("did you mean 'studio'?"));
  EXPECT_THAT(refuse(1, "info sky.hdr"), AllOf(HasSubstr("no such file"), Not(HasSubstr("did you mean"))));
}

TEST_F(SuggestionTest, ACommandIsMeantByAnotherWord) {
  expectHints({{"show a.glb", "did you mean 'render'?"},
               {"resize a.hdr", "did you mean 'convert'?"},
               {"prefilter a.hdr", "did you mean 'bake'?"},
               {"identify a.hdr", "did you mean 'info'?"},
               {"--size 8x8 render", "the command comes before its options: --size is one of render, convert, bake"},
               {"--quiet", "the command comes before its options"}});
  EXPECT_THAT(refuse(2, "paint a.hdr"), AllOf(HasSubstr("'paint'"), Not(HasSubstr("did you mean"))));
  write("a.hdr", std::string("light"));
  EXPECT_THAT(refuse(2, "a.hdr"), AllOf(StartsWith("'a.hdr' is a file; "), HasSubstr("render, convert, bake")));
}

TEST_F(SuggestionTest, ALongOptionHasTwoDashes) {
  // Else -output would be -o with the value "utput".
  expectHints({{"render -output a.png", "'-output': options of more than one letter have two dashes: --output"},
               {"convert a.hdr -size=8 -o b.exr", "'-size': options of more than one letter have two dashes: --size"}});
  // And -o=a.png would be a file of the name "=a.png".
  expectHints({{"render -o=a.png", "'-o=a.png': after a letter no = stands; say -o a.png or --output=a.png"},
               {"render -e=studio -o a.png", "say -e studio or --env=studio"}});
}

TEST_F(SuggestionTest, AWordTooManyIsToldWhereItBelongs) {
  write("a.hdr", std::string("light"));
  expectHints(
      {{"render teapot gold", "did you mean --material gold?"},
       {"render teapot studio", "for its light say -e studio"},
       {"render teapot a.hdr", "for its light say -e a.hdr"},
       {"render teapot b.png", "to write it say -o b.png"},
       {"render torus knot", "one model is drawn at a time; a glTF file may hold several"},
       {"render teapot --fov 40 20", "numbers of one option have commas between"},
       {"convert a.hdr --to cube --rotate 90 20 -o b.exr", "there are 2 inputs (a.hdr, 20)"},
       {"convert a b c d --to cube -o b.exr", "there are 4 inputs (a, b, c, …)"},
       {"convert a.jpg b.jpg -o b.exr", "`mirrorball photo` merges exposures of a mirror ball"},
       {"bake a.hdr b.hdr -o b.ktx2", "there are 2 inputs (a.hdr, b.hdr)"},
       {"convert a.hdr --mips=maybe -o b.ktx2", "--mips is there or not, and takes no value"},
       {"help rendr", "did you mean 'render'?"},
       {"help rendr x", "did you mean 'render'?"},
       {"help render alll", "'alll' was not expected; say mirrorball help render, or mirrorball help render all"},
       {"help render all more", "'more' was not expected; say mirrorball help render"},
       {"help render teapot -o b.png", "'teapot' was not expected"},
       {"help materials extra", "'extra' was not expected; say mirrorball help materials"}});
  EXPECT_EQ(succeed("version"), succeed("--version"));
}

TEST_F(SuggestionTest, AMisspeltAliasIsSuggestedToo) {
  expectHints({{"convert uv --to equirectangluar -o a.exr", "did you mean 'equirectangular'?"},
               {"info uv --from lat-lnog", "did you mean 'lat-long'?"},
               {"convert uv --to cueb -o a.exr", "did you mean 'cube'?"},
               {"convert uv --filter lineer -o a.exr", "did you mean 'linear'?"}});
}

TEST_F(SuggestionTest, ALayoutIsNoProjection) {
  expectHints({{"convert uv --to hcross -o a.exr", "that is a layout of cubes; say --to cube --layout hcross"},
               {"capture none --at 0,0,0 --to Faces -o a.exr", "say --to cube --layout faces"}});
}

using SuggestionRenderTest = RenderCliTest;

// A model's name may follow an option whose value may be missing.
TEST_F(SuggestionRenderTest, OnlyANumberIsTheValueOfOrthographic) {
  const std::string line = "render -e white --size 16x16 --background 0 --samples 1 ";
  succeed(line + "sphere --orthographic -o a.png");
  for (const std::string words :
       {"--orthographic sphere -o b.png", "--orthographic=0 sphere -o b.png", "--orthographic 0 sphere -o b.png"}) {
    succeed(line + words);
    EXPECT_TRUE(bytes("a.png") == bytes("b.png")) << words;
  }
  EXPECT_THAT(refuse(2, line + "sphere --orthographic -3 -o b.png"), HasSubstr("0 … 10000"));
}

TEST_F(SuggestionRenderTest, ASizeMayHaveACapitalX) {
  succeed("render none -e white --size 16X8 -o a.png");
  EXPECT_EQ(image("a.png").height(), 8);
}

TEST_F(SuggestionRenderTest, AMisspeltEnvironmentOrParameterIsSuggested) {
  EXPECT_THAT(refuse(1, "render sphere -e sutdio --size 8x8 -o a.png"), HasSubstr("did you mean 'studio'?"));
  EXPECT_THAT(refuse(2, "render sphere --set rougness=0.3 --size 8x8 -o a.png"),
              HasSubstr("did you mean 'perceptual_roughness'?"));
  EXPECT_THAT(refuse(2, "render sphere --background transparant --size 8x8 -o a.png"),
              HasSubstr("did you mean 'transparent'?"));
}

}  // namespace
}  // namespace mirrorball::testing
