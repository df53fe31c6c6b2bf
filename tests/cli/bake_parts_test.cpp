// bake --only makes some parts of a set.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class BakePartsTest : public CliTest {
 protected:
  BakePartsTest() { write("map.exr", smoothPanoramaWithLamp()); }

  /// The largest difference of two cubes, of the brighter of the two values.
  static float difference(const ImageSet& a, const ImageSet& b) {
    float largest = 0.0f;
    for (int level = 0; level < a.levels(); ++level)
      for (int face = 0; face < 6; ++face)
        for (std::size_t i = 0; i < a.at(level, face).samples().size(); ++i) {
          const float x = a.at(level, face).samples()[i];
          const float y = b.at(level, face).samples()[i];
          largest = std::max(largest, std::abs(x - y) / std::max({x, y, 1e-3f}));
        }
    return largest;
  }
};

constexpr const char* kWhole = "bake map.exr -o whole --size 32 --irradiance-size 8 --brdf-size 8 --format float32";

TEST_F(BakePartsTest, OnlyWhatIsAskedForIsWritten) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"specular --size 8", {"manifest.json", "specular.ktx2"}},
      {"irradiance --irradiance-size 8", {"irradiance.ktx2", "manifest.json"}},
      {"harmonics", {"manifest.json", "sh.h", "sh.json"}},
      {"brdf --brdf-size 8", {"brdf.ktx2", "manifest.json"}},
      {"lobe-rows", {"lobe_rows.json", "lobe_rows.ktx2", "manifest.json"}},
      {"skybox --skybox-size 8", {"manifest.json", "skybox.ktx2"}},
      {"harmonics,irradiance", {"irradiance.ktx2", "manifest.json", "sh.h", "sh.json"}},
      {"irradiance --irradiance-size 8 --for unity", {"irradiance.dds", "manifest.json"}},
      {"irradiance --irradiance-size 8 --split", {"irradiance.ktx2", "lamps.glb", "lamps.json", "manifest.json"}},
      {"skybox --skybox-size 8 --for filament", {"manifest.json", "out_skybox.ktx"}},
      {"specular,harmonics --size 16 --for filament", {"manifest.json", "out_ibl.ktx", "sh.txt"}},
      {"lobe-rows --for three", {"lobe_rows.ktx2", "manifest.json"}}};
  for (const auto& [parts, names] : cases) {
    succeed("bake map.exr -o out/ --only " + parts);
    std::vector<std::string> written;
    for (const auto& entry : std::filesystem::directory_iterator(path("out")))
      written.push_back(entry.path().filename());
    std::ranges::sort(written);
    EXPECT_EQ(written, names) << parts;
    std::filesystem::remove_all(path("out"));
  }
}

// The maps are those of the whole set, within what prefiltering is exact to.
TEST_F(BakePartsTest, AMapIsThatOfTheWholeSet) {
  succeed(kWhole);
  succeed("bake map.exr -o out --only irradiance,harmonics --irradiance-size 8 --format float32");
  EXPECT_LT(difference(texture("out/irradiance.ktx2"), texture("whole/irradiance.ktx2")), 1e-4f);
  const auto whole = jsonIn("whole/sh.json")["radiance"];
  const auto part = jsonIn("out/sh.json")["radiance"];
  ASSERT_EQ(part.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(part[i][1].get<double>(), whole[i][1].get<double>(), 1e-4 * whole[0][1].get<double>());
  succeed("bake map.exr -o chain --only specular --size 32 --format float32");
  EXPECT_LT(difference(texture("chain/specular.ktx2"), texture("whole/specular.ktx2")), 1e-4f);
  const nlohmann::json manifest = jsonIn("out/manifest.json");
  EXPECT_EQ(manifest["irradiance"]["size"], 8);
  EXPECT_EQ(manifest["faces"], jsonIn("whole/manifest.json")["faces"]);
  EXPECT_FALSE(manifest.contains("specular"));
  EXPECT_FALSE(manifest.contains("brdf"));
}

TEST_F(BakePartsTest, WhatIsNotAskedForIsNotComputed) {
  const auto stages = [&](const std::string& parts) {
    return run("bake map.exr -o out --timings --only " + parts).err;
  };
  const std::string irradiance = stages("irradiance");
  EXPECT_THAT(irradiance, HasSubstr("irradiance: cube"));
  EXPECT_THAT(irradiance, AllOf(Not(HasSubstr("prefilter")), Not(HasSubstr("BRDF")), Not(HasSubstr("lobes"))));
  EXPECT_THAT(stages("brdf --brdf-size 8"), AllOf(HasSubstr("BRDF table"), Not(HasSubstr("analyse"))));
  EXPECT_THAT(stages("skybox"), AllOf(HasSubstr("skybox: convert"), Not(HasSubstr("analyse"))));
  EXPECT_THAT(stages("specular --size 8"), AllOf(HasSubstr("prefilter"), Not(HasSubstr("irradiance"))));
}

TEST_F(BakePartsTest, OneTextureHoldsOneCube) {
  succeed(kWhole);
  succeed("bake map.exr -o light.ktx2 --only irradiance --irradiance-size 8 --format float32");
  EXPECT_EQ(texture("light.ktx2").levels(), 1);
  EXPECT_LT(difference(texture("light.ktx2"), texture("whole/irradiance.ktx2")), 1e-4f);
  succeed("bake map.exr -o sky.ktx2 --only skybox --skybox-size 8");
  EXPECT_EQ(texture("sky.ktx2").at(0, 0).width(), 8);
  succeed("bake map.exr -o chain.ktx2 --only specular --size 16");
  EXPECT_EQ(texture("chain.ktx2").levels(), 3);
  EXPECT_THAT(refuse(2, "bake map.exr -o one.ktx2 --only irradiance,specular"),
              HasSubstr("one texture holds specular, irradiance or skybox, not irradiance,specular; name a folder"));
  EXPECT_THAT(refuse(2, "bake map.exr -o one.ktx2 --only brdf"), HasSubstr("not brdf"));
  EXPECT_THAT(refuse(2, "bake map.exr -o one.ktx2 --only irradiance --split"), HasSubstr("--split is for what lies"));
}

TEST_F(BakePartsTest, ManyEnvironmentsEachHaveThem) {
  write("other.exr", smoothPanorama());
  succeed("bake map.exr other.exr -o out --only irradiance --irradiance-size 4");
  EXPECT_THAT(files(), ElementsAre("map.exr", "other.exr", "out/", "out/map/", "out/map/irradiance.ktx2",
                                   "out/map/manifest.json", "out/other/", "out/other/irradiance.ktx2",
                                   "out/other/manifest.json"));
}

TEST_F(BakePartsTest, ContradictionsAreRefused) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"--only specular,light", "--only: no part of a baked set is named 'light' (there are: specular, irradiance,"},
      {"--only irradiance --size 64", "--size describes what --only leaves out"},
      {"--only irradiance --brdf-size 64", "--brdf-size describes what --only leaves out"},
      {"--only irradiance --distribution phong", "--distribution describes what --only leaves out"},
      {"--only specular --irradiance-size 8", "--irradiance-size describes what --only leaves out"},
      {"--only specular --skybox", "--skybox describes what --only leaves out"},
      {"--only brdf --split", "--split describes what --only leaves out"},
      {"--only brdf --rotate 20", "--rotate describes what --only leaves out"},
      {"--only harmonics --format half", "--format describes what --only leaves out"},
      {"--only lobe-rows --lobe-rows 0", "leave one of the two out"},
      {"--only lobe-rows --distribution charlie", "rows of lobes are known for ggx only"},
      {"--only irradiance --for filament", "--only irradiance: Filament has a BRDF table of its own"},
      {"--only irradiance,specular --for three", "finds irradiance in the last level; leave out"},
      {"--only specular --for babylon", "Babylon.js reads one .env with all in it"},
      {"--only harmonics --for gltf", "reads one .glb with all in it"}};
  for (const std::string program : {"filament", "three"})
    EXPECT_THAT(refuse(2, "bake map.exr --only irradiance -o light.ktx2 --for " + program),
                HasSubstr("has a BRDF table of its own"));
  for (const auto& [options, line] : cases)
    EXPECT_THAT(refuse(2, "bake map.exr -o out " + options), HasSubstr(line)) << options;
  EXPECT_THAT(refuse(2, "bake map.exr -o light.env --for babylon --only specular"), HasSubstr("leave --only out"));
}

// A part can be made again, finer or in another format, without making all the others.
TEST_F(BakePartsTest, OtherPartsOfTheSameSetStay) {
  succeed(kWhole);
  const Bytes chain = bytes("whole/specular.ktx2");
  succeed("bake map.exr -o whole --only irradiance --irradiance-size 16 --extension dds");
  EXPECT_EQ(bytes("whole/specular.ktx2"), chain);
  EXPECT_THAT(files(), IsSupersetOf({"whole/irradiance.dds", "whole/brdf.ktx2", "whole/sh.json"}));
  EXPECT_THAT(files(), Not(Contains("whole/irradiance.ktx2")));
  const nlohmann::json manifest = jsonIn("whole/manifest.json");
  EXPECT_EQ(manifest["irradiance"]["file"], "irradiance.dds");
  EXPECT_EQ(manifest["irradiance"]["size"], 16);
  EXPECT_EQ(manifest["specular"]["file"], "specular.ktx2");
  EXPECT_EQ(manifest["harmonics"]["file"], "sh.json");
  succeed("bake map.exr -o whole --only brdf --brdf-size 8");
  EXPECT_EQ(jsonIn("whole/manifest.json")["faces"], manifest["faces"]);
}

// The light is known by its texels, whatever the input is called.
TEST_F(BakePartsTest, TheSameLightMayHaveAnotherName) {
  succeed(kWhole);
  const std::vector<std::string> before = files();
  std::filesystem::copy(path("map.exr"), path("copy.exr"));
  for (const std::string input : {"./map.exr", "copy.exr", "map.exr --rotate 0", "map.exr --scale-light 1"}) {
    succeed("bake -o whole --irradiance-size 4 --only irradiance " + input);
    EXPECT_THAT(files(), IsSupersetOf(before)) << input;
    EXPECT_TRUE(jsonIn("whole/manifest.json").contains("specular")) << input;
  }
  succeed("bake map.exr -o split --split --size 16 --irradiance-size 8 --brdf-size 8");
  succeed("bake ./map.exr -o split --split --only irradiance --irradiance-size 4");
  EXPECT_THAT(files(), IsSupersetOf({"split/specular.ktx2", "split/lamps.json", "split/sh.json"}));
  EXPECT_TRUE(jsonIn("split/manifest.json").contains("lamps"));
}

TEST_F(BakePartsTest, PartsOfOtherLightAreRefusedAndNothingIsRemoved) {
  write("other.exr", smoothPanorama());
  succeed(kWhole);
  for (const std::string line :
       {"other.exr", "map.exr --rotate 90", "map.exr --split", "map.exr --scale-light 2", "studio"})
    EXPECT_THAT(refuse(2, "bake -o whole --irradiance-size 4 --only irradiance " + line),
                HasSubstr("whole: holds parts of another light; bake all of it again without --only, or name another "
                          "folder"))
        << line;
  EXPECT_THAT(refuse(2, "bake map.exr -o whole --only irradiance --for unity --extension ktx2"),
              HasSubstr("whole: holds cubes whose faces are arranged in another way"));
  EXPECT_THAT(run("bake other.exr -o whole --only irradiance --timings").err,
              AllOf(HasSubstr("another light"), Not(HasSubstr("analyse"))));
  // After a note of how much light the limit takes.
  const Outcome limited = run("bake map.exr -o whole --only irradiance --clamp-light 0.5");
  EXPECT_EQ(limited.exit_code, 2);
  EXPECT_THAT(limited.err, HasSubstr("another light"));
  // Files of one name may get other content.
  write("map.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "bake map.exr -o whole --only irradiance"), HasSubstr("another light"));
  succeed(kWhole);
  succeed("bake other.exr -o whole --only irradiance --irradiance-size 4");
}

TEST_F(BakePartsTest, LampsOfOneLightAreNoneOfAnother) {
  succeed("bake map.exr -o split --split --size 16 --irradiance-size 8 --brdf-size 8");
  for (const std::string line : {"map.exr", "map.exr --split --max-size 1", "map.exr --split --min-share 0.5"})
    EXPECT_THAT(refuse(2, "bake -o split --only specular --size 16 " + line), HasSubstr("another light")) << line;
}

// Built-in light has no texels before it is looked up.
TEST_F(BakePartsTest, BuiltInLightIsKnownByItsValues) {
  succeed("bake studio -o out --only specular --size 8");
  succeed("bake studio -o out --only irradiance --irradiance-size 4");
  EXPECT_TRUE(jsonIn("out/manifest.json").contains("specular"));
  for (const std::string line : {"sunset", "studio --scale-light 2", "studio --rotate 20"})
    EXPECT_THAT(refuse(2, "bake -o out --only irradiance " + line), HasSubstr("another light")) << line;
}

// Neither the BRDF table nor rows of lobes depend on an environment.
TEST_F(BakePartsTest, TablesStayBesideAnyLight) {
  write("other.exr", smoothPanorama());
  succeed("bake map.exr -o out --only brdf,lobe-rows --brdf-size 8");
  EXPECT_FALSE(jsonIn("out/manifest.json").contains("light_hash"));
  succeed("bake other.exr -o out --only irradiance --irradiance-size 4");
  EXPECT_THAT(files(), IsSupersetOf({"out/brdf.ktx2", "out/lobe_rows.json", "out/lobe_rows.ktx2"}));
  nlohmann::json before = jsonIn("out/manifest.json");
  EXPECT_EQ(before["source"], "other.exr");
  EXPECT_TRUE(before.contains("brdf"));
  succeed("bake map.exr -o out --only brdf --brdf-size 4 --extension dds");
  nlohmann::json after = jsonIn("out/manifest.json");
  EXPECT_EQ(after["brdf"]["file"], "brdf.dds");
  for (const char* const key : {"source", "light_hash", "faces", "irradiance", "lobe_rows"})
    EXPECT_EQ(after[key], before[key]) << key;
  EXPECT_THAT(files(), Not(Contains("out/brdf.ktx2")));
}

TEST_F(BakePartsTest, AManifestWithoutAHashIsOfAnotherLight) {
  succeed(kWhole);
  nlohmann::json manifest = jsonIn("whole/manifest.json");
  manifest.erase("light_hash");
  write("whole/manifest.json", manifest.dump());
  EXPECT_THAT(refuse(2, "bake map.exr -o whole --only irradiance"), HasSubstr("another light"));
  succeed("bake map.exr -o whole --only brdf --brdf-size 4");
  EXPECT_THAT(files(), IsSupersetOf({"whole/specular.ktx2", "whole/sh.json"}));
}

// What a folder holds is then not known, and so nothing is removed.
TEST_F(BakePartsTest, AManifestThatCannotBeReadIsRefused) {
  succeed(kWhole);
  const std::string deep(200000, '[');
  for (const std::string& manifest :
       {std::string("[1, 2]"), std::string("no JSON"), std::string(), deep, deep + std::string(200000, ']'),
        R"({"specular": )" + deep + std::string(200000, ']') + "}"}) {
    write("whole/manifest.json", manifest);
    EXPECT_THAT(refuse(1, "bake map.exr -o whole --only irradiance"),
                AllOf(HasSubstr("whole/manifest.json: does not describe a set"), HasSubstr("without --only")));
    succeed("bake map.exr -o whole --size 16 --irradiance-size 4 --brdf-size 4");
  }
  write("whole/manifest.json", std::string(2000000, ' '));
  EXPECT_THAT(refuse(1, "bake map.exr -o whole --only irradiance"), HasSubstr("whole/manifest.json"));
}

// A folder in the place of one of its files makes a set fail after others were written.
TEST_F(BakePartsTest, WhatStaysIsInAManifestAlsoIfTheRestFails) {
  succeed(kWhole);
  nlohmann::json before = jsonIn("whole/manifest.json");
  const Bytes chain = bytes("whole/specular.ktx2");
  std::filesystem::remove(path("whole/sh.h"));
  std::filesystem::create_directories(path("whole/sh.h/in_the_way"));
  const Outcome outcome = run("bake map.exr -o whole --only irradiance,harmonics --irradiance-size 4");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  nlohmann::json after = jsonIn("whole/manifest.json");
  for (const char* const key : {"source", "light_hash", "faces", "specular", "brdf", "lobe_rows"})
    EXPECT_EQ(after[key], before[key]) << key;
  EXPECT_FALSE(after.contains("irradiance"));
  EXPECT_FALSE(after.contains("harmonics"));
  EXPECT_EQ(bytes("whole/specular.ktx2"), chain);
  std::filesystem::remove_all(path("whole/sh.h"));
  succeed("bake map.exr -o whole --only irradiance,harmonics --irradiance-size 4");
  EXPECT_EQ(jsonIn("whole/manifest.json")["specular"], before["specular"]);
}

}  // namespace
}  // namespace mirrorball::testing
