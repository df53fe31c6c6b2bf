// bake --for three, babylon, playcanvas and gltf: files that web engines load as they are. What the engines show of
// them is tested in tests/browser.

#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class BakeEnginesTest : public CliTest {};

TEST_F(BakeEnginesTest, ThreeGetsAChainThatEndsAt8) {
  succeed("bake white --for three -o out");
  EXPECT_THAT(files(), ElementsAre("out/", "out/lobe_rows.ktx2", "out/manifest.json", "out/specular.ktx2"));
  const ImageSet levels = texture("out/specular.ktx2");
  ASSERT_EQ(levels.levels(), 6);
  EXPECT_EQ(levels.at(5, 0).width(), 8);
  EXPECT_EQ(jsonIn("out/manifest.json")["specular"]["format"], "uastc hdr 4x4");
  EXPECT_EQ(jsonIn("out/manifest.json")["specular"]["levels"][5]["perceptual_roughness"], 1.0);
  EXPECT_THAT(succeed("info out/specular.ktx2"), HasSubstr("axes="));
}

TEST_F(BakeEnginesTest, ThreesFormatIsThatOfItsLoader) {
  succeed("bake white --for three --size 16 -o usual.ktx2");
  succeed("bake white --for three --size 16 --format uastc_hdr -o same.ktx2");
  EXPECT_EQ(bytes("usual.ktx2"), bytes("same.ktx2"));
  succeed("bake white --for three --size 16 --zstd 19 -o small.ktx2");
  EXPECT_LT(bytes("small.ktx2").size(), bytes("usual.ktx2").size());
  succeed("bake white --for three --size 16 --extension dds -o halves");
  EXPECT_EQ(jsonIn("halves/manifest.json")["specular"]["format"], "r16g16b16a16 sfloat");
}

// As text they are for programs that read no KTX2.
TEST_F(BakeEnginesTest, ThreesRowsOfLobesAreATextureAlone) {
  succeed("bake white --for three --size 16 -o out");
  EXPECT_THAT(succeed("info out/lobe_rows.ktx2"), HasSubstr("r16g16b16a16 sfloat"));
  EXPECT_EQ(jsonIn("out/manifest.json")["lobe_rows"]["lobes"], 4);
  EXPECT_FALSE(jsonIn("out/manifest.json")["lobe_rows"].contains("json"));
  succeed("bake white --for three --size 16 --lobe-rows 2 -o out");
  EXPECT_EQ(jsonIn("out/manifest.json")["lobe_rows"]["lobes"], 2);
  for (const std::string option : {"--lobe-rows 0", "--distribution phong"}) {
    succeed("bake white --for three --size 16 " + option + " -o out");
    EXPECT_THAT(files(), ElementsAre("out/", "out/manifest.json", "out/specular.ktx2")) << option;
  }
  EXPECT_THAT(refuse(2, "bake white --for three --lobe-rows 4 -o out.ktx2"), HasSubstr("specular chain only"));
  EXPECT_THAT(refuse(2, "bake white --for playcanvas --lobe-rows 4 -o out"), HasSubstr("looks reflections up once"));
}

TEST_F(BakeEnginesTest, LightThatThreesFormatDoesNotHoldIsTold) {
  Image map(32, 16, 3, 1e5f);
  write("bright.exr", map);
  EXPECT_THAT(run("bake bright.exr --for three --size 16 -o bright").err, HasSubstr("uastc_hdr holds 0 to 65504"));
  for (float& light : map.samples()) light = 1e-7f;
  write("dark.exr", map);
  EXPECT_THAT(run("bake dark.exr --for three --size 16 -o dark").err, HasSubstr("few of its digits"));
}

TEST_F(BakeEnginesTest, ThreesBackgroundIsWrittenIfItIsAskedFor) {
  succeed("bake white --for three --size 16 --skybox-size 8 --format bc6h -o out");
  EXPECT_THAT(files(),
              ElementsAre("out/", "out/lobe_rows.ktx2", "out/manifest.json", "out/skybox.ktx2", "out/specular.ktx2"));
  EXPECT_THAT(refuse(2, "bake white --for three --brdf-size 8 -o out"), HasSubstr("three.js has a BRDF table"));
  EXPECT_THAT(refuse(2, "bake white --for three --format e5b9g9r9 -o out"),
              HasSubstr("three.js reads uastc_hdr, half, float32"));
}

TEST_F(BakeEnginesTest, AnotherMipMappingGivesTheMapsOneByOne) {
  for (const std::string program : {"three", "babylon", "playcanvas"}) {
    succeed("bake white --size 8 --brdf-size 8 --mip-mapping filament --for " + program + " -o " + program);
    EXPECT_THAT(files(), AllOf(Contains(program + "/irradiance.ktx2"), Contains(program + "/brdf.ktx2"),
                               Contains(program + "/sh.json")));
    EXPECT_EQ(jsonIn(program + "/manifest.json")["specular"]["levels"].size(), 2u);
  }
}

TEST_F(BakeEnginesTest, BabylonGetsAnEnvAndADds) {
  succeed("bake white --for babylon --size 32 -o out");
  EXPECT_THAT(files(), ElementsAre("out/", "out/environment.dds", "out/environment.env", "out/manifest.json"));
  EXPECT_EQ(texture("out/environment.dds").levels(), 6);
  EXPECT_EQ(jsonIn("out/manifest.json")["packed"]["file"], "environment.env");
  EXPECT_EQ(jsonIn("out/manifest.json")["specular"]["file"], "environment.dds");
  EXPECT_THAT(jsonIn("out/manifest.json")["specular"]["look_up"], HasSubstr("0.8 log2(w r r)"));
  succeed("bake white --for babylon --size 32 -o alone.env");
  EXPECT_EQ(bytes("alone.env"), bytes("out/environment.env"));
  succeed("bake white --for babylon --size 32 --irradiance-size 8 -o alone.env");
  EXPECT_LT(bytes("alone.env").size(), bytes("out/environment.env").size());
  EXPECT_THAT(refuse(2, "bake white --for babylon --split -o alone.env"), HasSubstr("name a folder"));
}

TEST_F(BakeEnginesTest, PlayCanvasGetsAnAtlas) {
  succeed("bake white --for playcanvas --size 64 -o out");
  EXPECT_THAT(files(), ElementsAre("out/", "out/environment.png", "out/manifest.json"));
  EXPECT_EQ(image("out/environment.png").width(), 512);
  EXPECT_EQ(jsonIn("out/manifest.json")["specular"]["levels"].size(), 6u);
  EXPECT_FALSE(jsonIn("out/manifest.json")["specular"].contains("file"));
}

TEST_F(BakeEnginesTest, GltfGetsALight) {
  succeed("bake white --for gltf --size 32 -o out");
  EXPECT_THAT(files(), ElementsAre("out/", "out/environment.glb", "out/manifest.json"));
  succeed("bake white --for gltf --size 32 --mip-mapping linear -o even.glb");
  EXPECT_THAT(files(), Contains("even.glb"));
}

TEST_F(BakeEnginesTest, WhatAFileDoesNotHoldIsTold) {
  Image map(32, 16, 3, 1.0f);
  for (int c = 0; c < 3; ++c) map.texel(20, 5)[c] = 1e5f;
  write("sun.exr", map);
  EXPECT_THAT(run("bake sun.exr --for babylon --size 16 -o out").err,
              AllOf(HasSubstr("environment.env: the format ends at 255"),
                    HasSubstr("% of the light is lost; --scale-light or")));
  EXPECT_THAT(run("bake sun.exr --for playcanvas --size 32 -o out").err, HasSubstr("the format ends at 64"));
}

TEST_F(BakeEnginesTest, ChainsThatAProgramCannotReadAreRefused) {
  EXPECT_THAT(refuse(2, "bake white --for babylon --size 100 -o out"), HasSubstr("power of two, not 100; ask for 64"));
  EXPECT_THAT(refuse(2, "bake white --for babylon --levels 3 -o out"), HasSubstr("a chain of 9 levels, not of 3"));
  EXPECT_THAT(refuse(2, "bake white --for playcanvas --size 16 -o out"), HasSubstr("ask for larger ones"));
  EXPECT_THAT(refuse(2, "bake white --for playcanvas --skybox -o out"), HasSubstr("finds the rest in its atlas"));
  EXPECT_THAT(refuse(2, "bake white --for babylon -o out.png"), HasSubstr(".env"));
}

TEST_F(BakeEnginesTest, OptionsThatAFileDoesNotReadAreRefused) {
  for (const std::string line : {"-o x.env --for babylon --format float32", "-o out --for playcanvas --format float32",
                                 "-o out --for gltf --zstd 3", "-o x.png --for playcanvas --zstd 3"})
    EXPECT_THAT(refuse(2, "bake white --size 32 " + line), HasSubstr(" is for textures, and .")) << line;
  EXPECT_THAT(refuse(2, "bake white --for gltf --irradiance-size 8 -o out"),
              HasSubstr("three bands of irradiance only"));
  EXPECT_THAT(refuse(2, "bake white --for babylon --extension exr -o out"),
              HasSubstr("--extension: --for babylon writes .env and .dds; leave it out"));
  EXPECT_THAT(refuse(2, "bake white --for babylon --split -o x.env"),
              HasSubstr("x.env: is one file with all in it, and --split is for what lies beside it; name a folder"));
  EXPECT_THAT(refuse(2, "bake white --for babylon --irradiance-size 8 -o x.ktx2"), HasSubstr("specular chain only"));
  for (const std::string program : {"", " --for three", " --for playcanvas"})
    EXPECT_THAT(refuse(2, "bake white -o x.env" + program), HasSubstr(".env is --for babylon")) << program;
  EXPECT_THAT(files(), ElementsAre());
  succeed("bake white --for babylon --size 32 --format float32 -o out");
  EXPECT_THAT(succeed("info out/environment.dds"), HasSubstr("r32g32b32a32 sfloat"));
}

TEST_F(BakeEnginesTest, ChainsThatCannotHaveMoreLevelsAreNotAdvisedToTakeThem) {
  EXPECT_THAT(run("bake white --size 1 -o x.ktx2").err,
              AllOf(HasSubstr("level 0 only"), HasSubstr("a larger --size mends it"), Not(HasSubstr("--levels"))));
}

TEST_F(BakeEnginesTest, AnOlderSetOfAnotherProgramGoes) {
  succeed("bake white --for babylon --size 16 -o out");
  write("out/environment.txt", std::string("the user's own"));
  succeed("bake white --for playcanvas --size 32 -o out");
  EXPECT_THAT(files(), ElementsAre("out/", "out/environment.png", "out/environment.txt", "out/manifest.json"));
}

}  // namespace
}  // namespace mirrorball::testing
