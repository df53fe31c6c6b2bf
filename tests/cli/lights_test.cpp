// lights finds lamps, and takes them out of a map; bake --split does that, too.

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

/// A grey map with a sun of one texel: row 60 of 128 is a little above the horizon, and column 128 straight ahead.
class LightsTest : public CliTest {
 protected:
  LightsTest() {
    Image map(512, 256, 3, 0.5f);
    std::fill_n(map.texel(256, 100), 3, 3e4f);
    map.texel(256, 100)[2] = 1e4f;
    write("map.exr", map);
    write("grey.exr", Image(64, 32, 3, 0.5f));
  }
};

TEST_F(LightsTest, ATableTellsOfEachLamp) {
  const std::string said = succeed("lights map.exr");
  EXPECT_THAT(said, AllOf(StartsWith("map.exr: 1 lamp with "), HasSubstr(" 1   "), EndsWith("\n")));
  EXPECT_EQ(succeed("lights grey.exr"), "grey.exr: no lamp outshines the rest with 1 % of the light or more\n");
  EXPECT_THAT(succeed("lights white --min-share 0.2"), HasSubstr("with 20 % of the light"));
}

TEST_F(LightsTest, ProgramsGetTheSame) {
  const Json said = Json::parse(succeed("lights map.exr --json"));
  EXPECT_EQ(said["file"], "map.exr");
  ASSERT_EQ(said["lights"].size(), 1u);
  const Json& lamp = said["lights"][0];
  EXPECT_NEAR(lamp["direction"][2].get<double>(), 0.944, 0.01);
  EXPECT_NEAR(lamp["irradiance"][0].get<double>() / lamp["irradiance"][2].get<double>(), 3.0, 1e-4);
  EXPECT_NEAR(lamp["angular_size"].get<double>(), 0.8, 0.2);
  EXPECT_EQ(lamp["is_lower_bound"], false);
  EXPECT_GE(lamp["outline"].size(), 4u);
  EXPECT_NEAR(lamp["share"].get<double>(), 0.39, 0.01);
  EXPECT_EQ(Json::parse(succeed("lights grey.exr --json"))["lights"], Json::array());
}

TEST_F(LightsTest, TwoOutputsHaveTwoNames) {
  for (const char* outputs : {"-o one.png --split one.png", "--split rest.exr --lamps lamps.json --lamps lamps.json"}) {
    EXPECT_THAT(refuse(2, std::string("lights map.exr ") + outputs), HasSubstr("is named for two outputs"));
  }
}

TEST_F(LightsTest, AnInterruptionLeavesNothing) {
  Image map(4096, 2048, 3, 0.5f);
  std::fill_n(map.texel(2000, 700), 3, 3e5f);
  write("large.exr", map);
  const std::vector<std::string> before = files();
  const std::string line = "lights large.exr --split rest.exr --lamps lamps.json --lamps lamps.glb -o lamps.png";
  for (const int pause_ms : {0, 100, 400}) {
    Program program({.arguments = Arguments(line).words, .folder = path(""), .cores = 1});
    program.waitUntilItCatchesInterrupts();
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    program.interrupt();
    EXPECT_EQ(program.wait().signal, SIGINT) << "after " << pause_ms << " ms";
    EXPECT_EQ(files(), before) << "after " << pause_ms << " ms";
  }
}

TEST_F(LightsTest, AClippedSunIsALowerBound) {
  Image map(256, 128, 3, 0.01f);
  for (int y = 30; y < 33; ++y)
    for (int x = 60; x < 63; ++x) std::fill_n(map.texel(x, y), 3, 1.0f);
  write("photo.png", map);
  EXPECT_THAT(succeed("lights photo.png"), AllOf(HasSubstr(">= "), HasSubstr("it is at least so much")));
  EXPECT_EQ(Json::parse(succeed("lights photo.png --json"))["lights"][0]["is_lower_bound"], true);
}

TEST_F(LightsTest, APictureHasTheOutlines) {
  succeed("lights map.exr -o lamps.png");
  const Image picture = image("lamps.png");
  EXPECT_EQ(picture.height(), 256);
  int marks = 0;
  for (int y = 80; y < 120; ++y)
    for (int x = 230; x < 290; ++x) marks += picture.texel(x, y)[1] > 0.9f && picture.texel(x, y)[0] < 0.2f ? 1 : 0;
  EXPECT_GT(marks, 20);
  EXPECT_THAT(refuse(2, "lights map.exr -o lamps.exr"), HasSubstr("--split"));
}

TEST_F(LightsTest, SplitWritesTheRestAndTheLamps) {
  const std::string said = succeed("lights map.exr --split rest.exr --for godot");
  EXPECT_THAT(said, AllOf(HasSubstr("taken out: 1 lamp"), HasSubstr("from one direction")));
  EXPECT_THAT(files(), IsSupersetOf({"rest.exr", "rest_lamps.gd", "rest_lamps.glb", "rest_lamps.json"}));
  const Image rest = image("rest.exr");
  for (const float sample : rest.samples()) EXPECT_NEAR(sample, 0.5f, 1e-4f);
  const Json lamps = Json::parse(bytes("rest_lamps.json"));
  ASSERT_EQ(lamps["lights"].size(), 1u);
  const Bytes gltf = bytes("rest_lamps.glb");
  const Json scene = Json::parse(gltf.begin() + 20, gltf.end());
  const Json& light = scene["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_EQ(light["type"], "directional");
  EXPECT_NEAR(light["intensity"].get<double>(), lamps["lights"][0]["irradiance"][0].get<double>(), 1e-5);
  // What a node's turn makes of +Z is the way to the lamp.
  const Json& turn = scene["nodes"][0]["rotation"];
  const double x = turn[0], y = turn[1], z = turn[2], w = turn[3];
  EXPECT_NEAR(2.0 * (x * z + w * y), lamps["lights"][0]["direction"][0].get<double>(), 1e-5);
  EXPECT_NEAR(2.0 * (y * z - w * x), lamps["lights"][0]["direction"][1].get<double>(), 1e-5);
  EXPECT_NEAR(1.0 - 2.0 * (x * x + y * y), lamps["lights"][0]["direction"][2].get<double>(), 1e-5);
}

TEST_F(LightsTest, EachProgramHasItsAxesAndUnits) {
  const Json lamp =
      Json::parse(succeed("lights map.exr --split rest.exr --json --lamps a.three.js --lamps a.babylon.js "
                          "--lamps a.gd --lamps a.py"))["lights"][0];
  const auto text = [&](const char* name) {
    const Bytes read = bytes(name);
    return std::string(read.begin(), read.end());
  };
  const std::string intensity = lamp["irradiance"][0].dump();
  const std::string up = lamp["direction"][1].dump();
  const std::string ahead = lamp["direction"][2].dump();
  EXPECT_THAT(text("a.three.js"),
              AllOf(HasSubstr(", " + up + ", " + ahead + ").multiplyScalar"), HasSubstr("), " + intensity)));
  EXPECT_THAT(text("a.babylon.js"),
              AllOf(HasSubstr(", -" + up + ", -" + ahead + "), scene"), HasSubstr("intensity = " + intensity)));
  EXPECT_THAT(text("a.gd"), AllOf(HasSubstr(", " + up + ", " + ahead + "), \"color\""), HasSubstr("irradiance / PI")));
  EXPECT_THAT(text("a.py"), AllOf(HasSubstr(", -" + ahead + ", " + up + "), ("), HasSubstr("), " + intensity)));
  EXPECT_THAT(refuse(2, "lights map.exr --split other.exr --lamps a.fbx"), HasSubstr(".glb"));
}

TEST_F(LightsTest, OptionsThatChangeNothingAreRefused) {
  EXPECT_THAT(refuse(2, "lights map.exr --for three"), AllOf(StartsWith("--for "), HasSubstr("add --split")));
  EXPECT_THAT(refuse(2, "lights map.exr --max-size 3"), HasSubstr("add --split"));
  EXPECT_THAT(refuse(2, "lights map.exr --split map.exr"), HasSubstr("map.exr"));
  EXPECT_THAT(refuse(2, "bake map.exr -o set --max-size 3"), HasSubstr("add --split"));
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.ktx2 --split"), HasSubstr("--split"));
}

TEST_F(LightsTest, BakeSplitsTooAndTurnsTheLamps) {
  const std::string small = " --size 16 --irradiance-size 64 --brdf-size 8 --lobe-rows 0 ";
  succeed("bake map.exr -o whole" + small);
  succeed("bake map.exr -o set --split --rotate 90" + small);
  EXPECT_THAT(files(), IsSupersetOf({"set/lamps.glb", "set/lamps.json"}));
  const Json lamps = Json::parse(bytes("set/lamps.json"));
  ASSERT_EQ(lamps["lights"].size(), 1u);
  EXPECT_NEAR(lamps["lights"][0]["direction"][0].get<double>(), 0.944, 0.01) << "from +Z to +X";
  const Json manifest = Json::parse(bytes("set/manifest.json"));
  EXPECT_EQ(manifest["lamps"]["files"], Json::array({"lamps.glb", "lamps.json"}));
  EXPECT_EQ(manifest["lamps"]["count"], 1);
  // The map and its lamp light a surface that faces it as the whole map does: irradiance / pi.
  const float rest = texelTowards(texture("set/irradiance.ktx2"), 0, {1, 0, 0}).x;
  const float whole = texelTowards(texture("whole/irradiance.ktx2"), 0, {0, 0, 1}).x;
  const auto of_lamp = float(lamps["lights"][0]["irradiance"][0].get<double>() * 0.944 / 3.14159265);
  EXPECT_NEAR(rest, 0.5f, 0.01f);
  EXPECT_NEAR((rest + of_lamp) / whole, 1.0f, 0.03f);
  // An older set's lamps go with it.
  succeed("bake map.exr -o set" + small);
  EXPECT_THAT(files(), ::testing::Not(::testing::Contains("set/lamps.glb")));
}

/// The lamps that --json lists.
Json lampsIn(const std::string& json) { return Json::parse(json)["lights"]; }

TEST_F(LightsTest, ScaledLampsHaveTheFactorTimesTheirLight) {
  const Json before = lampsIn(succeed("lights map.exr --json"));
  const Json printed = Json::parse(succeed("lights map.exr --scale 2 -o twice.exr --json"));
  EXPECT_EQ(printed["scale"], 2.0);
  EXPECT_EQ(printed["lights"], before) << "as they were";
  const Json after = lampsIn(succeed("lights twice.exr --json"));
  ASSERT_EQ(after.size(), before.size());
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(
        after[0]["irradiance"][std::size_t(c)].get<double>() / before[0]["irradiance"][std::size_t(c)].get<double>(),
        2.0, 1e-3);
  const Image map = image("map.exr");
  const Image twice = image("twice.exr");
  EXPECT_NEAR(twice.texel(256, 100)[0], 6e4f, 60.0f);
  for (int x = 0; x < 512; x += 7) EXPECT_EQ(rgbAt(twice, x, 20), rgbAt(map, x, 20));
  EXPECT_THAT(succeed("lights map.exr --scale 0.5 -o half.exr"), StartsWith("map.exr: scaled by 0.5, before: 1 lamp"));
}

TEST_F(LightsTest, ScaledBy0TheyAreGone) {
  succeed("lights map.exr --scale 0 -o dark.exr");
  EXPECT_EQ(lampsIn(succeed("lights dark.exr --json")), Json::array());
  EXPECT_NEAR(image("dark.exr").texel(256, 100)[0], 0.5f, 1e-3f);
}

TEST_F(LightsTest, AScaledMapKeepsItsForm) {
  succeed("convert map.exr --to cube --layout vcross --size 64 -o cross.exr");
  succeed("convert map.exr --to cube --size 64 -o cube.ktx2");
  succeed("convert map.exr --to octahedral --size 128 -o octahedral.exr");
  for (const std::string name : {"cross.exr", "cube.ktx2", "octahedral.exr"}) {
    const std::string output = "scaled_" + name;
    const Json before = lampsIn(succeed("lights --json " + name));
    succeed("lights --scale 3 " + name + " -o " + output);
    const auto form = [&](const std::string& file) { return Json::parse(succeed("info --json " + file))["form"]; };
    EXPECT_EQ(form(output), form(name));
    const Json after = lampsIn(succeed("lights --json " + output));
    ASSERT_EQ(after.size(), before.size()) << name;
    EXPECT_NEAR(after[0]["illuminance"].get<double>() / before[0]["illuminance"].get<double>(), 3.0, 0.05) << name;
  }
}

TEST_F(LightsTest, WithoutLampsAScaledMapIsWrittenAsItIs) {
  const Outcome outcome = run("lights grey.exr --scale 5 -o same.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("grey.exr: has no lamp to scale; its light is written as it is"));
  for (int x = 0; x < 64; ++x) EXPECT_EQ(rgbAt(image("same.exr"), x, 9), rgbAt(image("grey.exr"), x, 9));
}

TEST_F(LightsTest, OfLightThatAFormatDoesNotHoldARemarkTells) {
  const Outcome outcome = run("lights map.exr --scale 100 -o bright.ktx2 --format half");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("65504"));
  Image far_too_bright(512, 256, 3, 0.5f);
  std::fill_n(far_too_bright.texel(256, 100), 3, 9e35f);
  write("brightest.exr", far_too_bright);
  EXPECT_THAT(refuse(1, "lights brightest.exr --scale 1000 -o out.exr"), HasSubstr("too bright"));
}

TEST_F(LightsTest, WrongScalesAreRefused) {
  for (const char* factor : {"-1", "nan", "inf", "1001", "twice"})
    EXPECT_THAT(refuse(2, std::string("lights map.exr -o out.exr --scale=") + factor), HasSubstr("--scale")) << factor;
  EXPECT_THAT(refuse(2, "lights map.exr --scale 2"), HasSubstr("name it: -o FILE.exr"));
  EXPECT_THAT(refuse(2, "lights map.exr --scale 2 -o out.exr --split rest.exr"), HasSubstr("leave one of the two out"));
  EXPECT_THAT(refuse(2, "lights map.exr --scale 2 -o map.exr"), HasSubstr("map.exr"));
  EXPECT_THAT(refuse(2, "lights map.exr -o out.exr"), HasSubstr("--scale 2 for one with brighter ones"));
}

// What --max and --max-size leave out stays as it is.
TEST_F(LightsTest, OnlyTheLampsThatAreSelectedAreScaled) {
  Image two = image("map.exr");
  std::fill_n(two.texel(50, 100), 3, 1e4f);
  write("two.exr", two);
  succeed("lights two.exr --max 1 --scale 4 -o out.exr");
  EXPECT_NEAR(image("out.exr").texel(256, 100)[0], 12e4f, 120.0f);
  EXPECT_EQ(image("out.exr").texel(50, 100)[0], 1e4f);
  const Outcome none = run("lights two.exr --max-size 0.01 --scale 4 -o none.exr");
  EXPECT_THAT(none.err, HasSubstr("no lamp to scale"));
}

TEST_F(LightsTest, OptionsOfPicturesAreRefusedForScaledLight) {
  for (const char* file : {"out.exr", "out.hdr", "out.ktx2"})
    for (const std::string option : {"--exposure 2", "--tone-map aces"})
      EXPECT_THAT(
          refuse(2, "lights map.exr --scale 2 -o " + std::string(file) + " " + option),
          AllOf(StartsWith(file), HasSubstr("holds light as it is; for " + option.substr(0, option.find(' ')))));
  succeed("lights map.exr --scale 2 -o bright.png --exposure 0.5 --tone-map linear");
  succeed("lights map.exr --scale 2 -o dark.png --exposure -0.5 --tone-map linear");
  EXPECT_NEAR(image("bright.png").texel(9, 9)[0] / image("dark.png").texel(9, 9)[0], 2.0f, 0.1f);
}

TEST_F(LightsTest, AScaledMapMayGoThroughPipes) {
  succeed("lights map.exr --scale 2 -o file.exr");
  const std::vector<std::string> before = files();
  const Start piped{.input = bytes("map.exr")};
  const Outcome outcome = run("lights - --scale 2 -o -.exr", piped);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(Bytes(outcome.out.begin(), outcome.out.end()) == bytes("file.exr"));
  EXPECT_THAT(outcome.err, AllOf(StartsWith("standard input: scaled by 2, before: 1 lamp"), EndsWith("\n")));
  EXPECT_EQ(Json::parse(run("lights - --scale 2 -o -.exr --json", piped).err)["scale"], 2.0);
  EXPECT_EQ(run("lights - --scale 2 -o -.exr --quiet", piped).err, "");
  EXPECT_THAT(run("lights - -o -.png", piped).out, StartsWith("\x89PNG"));
  EXPECT_EQ(files(), before);
  succeed("convert map.exr --to cube --layout faces --size 8 -o cube.exr");
  EXPECT_THAT(refuse(2, "lights cube_px.exr --scale 2 -o -.exr"), HasSubstr("one file"));
}

/// A map of 24 MB as floats, with a sun.
Image largeMap() {
  Image map(2048, 1024, 3, 0.5f);
  std::fill_n(map.texel(1000, 400), 3, 3e5f);
  return map;
}

// Beside the map there is a float for each of its texels, 8 MB.
TEST_F(LightsTest, ScalingTakesNoMoreMemoryThanItMay) {
  write("large.exr", largeMap());
  EXPECT_THAT(refuse(1, "lights large.exr --scale 2 -o out.exr --max-memory 26M"),
              AllOf(StartsWith("large.exr: "), HasSubstr("needs 32 MB"), HasSubstr("26 MB may be used")));
  succeed("lights large.exr --scale 2 -o out.exr --max-memory 33M");
}

using LightsMemoryTest = PeakMemoryTest;

TEST_F(LightsMemoryTest, AMapIsScaledWithoutACopy) {
  write("large.exr", largeMap());
  const std::uint64_t found = run("lights large.exr").peak_memory;
  const Outcome scaled = run("lights large.exr --scale 2 -o out.exr");
  EXPECT_EQ(scaled.exit_code, 0);
  EXPECT_LT(scaled.peak_memory, found + 24 * kMega);
}

}  // namespace
}  // namespace mirrorball::testing
