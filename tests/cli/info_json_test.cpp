// info for programs, for many files, for tables, and for files that are no maps.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using InfoJsonTest = CliTest;

TEST_F(InfoJsonTest, AMapIsAnObject) {
  Image map(8, 4, 3, 2.0f);
  map.texel(3, 1)[0] = 5.0f;
  write("map.exr", map);
  const json said = json::parse(succeed("info map.exr --json"));
  EXPECT_EQ(said["file"], "map.exr");
  EXPECT_EQ(said["kind"], "map");
  EXPECT_EQ(said["format"], "OpenEXR, float, ZIP");
  EXPECT_EQ(said["colour"], "linear, Rec.709");
  EXPECT_EQ(said["projection"], "equirect");
  EXPECT_EQ(said["form"], "equirect");
  EXPECT_EQ(said["told_by"], "its shape, 2:1");
  EXPECT_EQ(said["size"], json::array({8, 4}));
  EXPECT_EQ(said["covered"], 1.0);
  EXPECT_EQ(said["bad_texels"]["count"], 0);
  EXPECT_EQ(said["min"], json::array({2.0, 2.0, 2.0}));
  EXPECT_EQ(said["max"], json::array({5.0, 2.0, 2.0}));
  EXPECT_EQ(said["brightest"]["radiance"], json::array({5.0, 2.0, 2.0}));
  EXPECT_EQ(said["brightest"]["direction"].size(), 3u);
  EXPECT_EQ(said["mean"].size(), 3u);
  EXPECT_FALSE(said.contains("direction"));
}

// The numbers that InfoTest.SaysWhereADirectionLies derives.
TEST_F(InfoJsonTest, ADirectionIsFoundInEveryProjection) {
  const json said = json::parse(succeed("info uv --json --direction -0.84,0.23,0.49"));
  EXPECT_TRUE(said["projection"].is_null());
  const json& direction = said["direction"];
  EXPECT_NEAR(direction["unit"][0].get<double>(), -0.84059, 1e-5);
  EXPECT_EQ(direction["places"]["cube"]["image"], 1);
  EXPECT_EQ(direction["places"]["cube"]["texel"], json::array({405, 185}));
  EXPECT_EQ(direction["places"]["equirect"]["texel"], json::array({1363, 436}));
  EXPECT_EQ(direction["places"]["equirect"]["size"], json::array({2048, 1024}));
  EXPECT_NEAR(direction["places"]["sphere"]["uv"][1].get<double>(), 1.0 - 0.5667, 1e-4) << "v grows downwards";
  EXPECT_EQ(direction["places"].size(), 10u);
  EXPECT_NEAR(direction["radiance"][1].get<double>(), 0.6, 1e-6);
  const json behind = json::parse(succeed("info uv --json --direction 0,0,-1"));
  EXPECT_EQ(behind["direction"]["places"]["hemioctahedral"]["covered"], false);
}

TEST_F(InfoJsonTest, ManyAreAnArrayAndABadOneIsAnObjectToo) {
  write("map.exr", Image(8, 4, 3, 2.0f));
  write("bad.exr", std::string("no map"));
  const Outcome outcome = run("info map.exr bad.exr white --json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: bad.exr: is not an image"),
                                 EndsWith("mirrorball: 1 of 3 inputs could not be read\n")));
  const json said = json::parse(outcome.out);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0]["file"], "map.exr");
  EXPECT_THAT(said[1]["error"].get<std::string>(), StartsWith("bad.exr: "));
  EXPECT_EQ(said[2]["file"], "white");
  EXPECT_EQ(run("info bad.exr --json").out, "") << "of one file the error is all there is";
}

TEST_F(InfoJsonTest, ManyAreToldOneAfterTheOther) {
  write("a.exr", Image(8, 4, 3, 2.0f));
  write("b.exr", Image(4, 4, 3, 2.0f));
  const std::string said = succeed("info a.exr b.exr");
  EXPECT_EQ(said, succeed("info a.exr") + "\n" + succeed("info b.exr"));
  EXPECT_THAT(succeed("info a.exr b.exr --direction 0,0,1"),
              AllOf(StartsWith("a.exr\ndirection "), HasSubstr("\nb.exr\n")));
}

TEST_F(InfoJsonTest, ABrdfTableIsKnown) {
  for (const std::string extension : {"ktx2", "exr", "dds"}) {
    succeed("bake white -o " + extension + " --size 8 --brdf-size 8 --brdf-channels 2 --brdf-extension " + extension);
    const std::string file = extension + "/brdf." + extension;
    const std::string said = succeed("info " + file);
    EXPECT_THAT(said, AllOf(HasSubstr("what         BRDF table of bake"), HasSubstr("size         8x8\n"),
                            HasSubstr("microfacets  ggx\n"), HasSubstr("axes         linear: ")))
        << extension;
    const json object = json::parse(succeed("info " + file + " --json"));
    EXPECT_EQ(object["kind"], "brdf_table") << extension;
    EXPECT_EQ(object["channels"], 2) << extension;
    EXPECT_EQ(object["distribution"], "ggx") << extension;
    EXPECT_EQ(object["axes"], "linear") << extension;
    EXPECT_EQ(object["size"], json::array({8, 8})) << extension;
  }
  succeed("bake white -o warped --size 8 --brdf-size 8 --distribution phong --brdf-axes warped --extension dds");
  const json warped = json::parse(succeed("info warped/brdf.dds --json"));
  EXPECT_EQ(warped["distribution"], "phong");
  EXPECT_EQ(warped["axes"], "warped");
  EXPECT_EQ(warped["channels"], 3);
  EXPECT_EQ(json::parse(succeed("info warped/specular.dds --json"))["kind"], "map");
}

TEST_F(InfoJsonTest, LobeRowsAreKnown) {
  for (const int lobes : {2, 4, 6}) {
    const std::string count = std::to_string(lobes);
    succeed("bake white -o out --size 8 --brdf-size 8 --lobe-rows " + count);
    const std::string width = std::to_string(24 * lobes);
    EXPECT_THAT(succeed("info out/lobe_rows.ktx2"),
                AllOf(HasSubstr("what         rows of " + count + " lobes of bake, no map of light"),
                      HasSubstr("size         " + width + "x24\n")));
    const json object = json::parse(succeed("info out/lobe_rows.ktx2 --json"));
    EXPECT_EQ(object["kind"], "lobe_rows");
    EXPECT_EQ(object["lobes"], lobes);
    EXPECT_EQ(object["size"], json::array({24 * lobes, 24}));
  }
}

TEST_F(InfoJsonTest, AModelIsNamedWithTheCommandThatShowsIt) {
  write("duck.glb", std::string("glTF and so on"));
  write("duck.stl", std::string("solid duck"));
  EXPECT_THAT(refuse(1, "info duck.glb"), HasSubstr("duck.glb: its header reaches byte 20"));
  EXPECT_THAT(refuse(1, "convert duck.glb --to cube -o out.exr"),
              HasSubstr("duck.glb: is a glTF model, no map; try `mirrorball render duck.glb`"));
  EXPECT_THAT(refuse(1, "convert duck.stl --to cube -o out.exr"), HasSubstr("is an STL model"));
  EXPECT_THAT(refuse(1, "bake duck.glb -o out"), HasSubstr("is a glTF model"));
}

using InfoRenderTest = RenderCliTest;

TEST_F(InfoRenderTest, AndAMapThatIsGivenAsAModelToo) {
  write("room.hdr", Image(8, 4, 3, 2.0f));
  EXPECT_THAT(refuse(1, "render room.hdr -o out.png"),
              HasSubstr("room.hdr: is a picture, no model; for the light in it try `mirrorball render -e room.hdr`"));
  write("duck.glb", std::string("glTF and so on"));
  EXPECT_THAT(refuse(1, "render none -e duck.glb -o out.png"), HasSubstr("is a glTF model, no map"));
}

}  // namespace
}  // namespace mirrorball::testing
