// bake of several environments at once.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StartsWith;

using BakeManyTest = CliTest;

constexpr const char* kSmallSets = " --size 8 --irradiance-size 4 --brdf-size 4";

TEST_F(BakeManyTest, EachGetsAFolderWithWhatItGetsAlone) {
  write("room.exr", smoothPanorama());
  succeed("bake room.exr white -o out/" + std::string(kSmallSets));
  succeed("bake room.exr -o alone" + std::string(kSmallSets));
  for (const std::string file : {"specular.ktx2", "irradiance.ktx2", "brdf.ktx2", "lobe_rows.ktx2", "lobe_rows.json",
                                 "sh.json", "sh.h", "manifest.json"}) {
    EXPECT_TRUE(bytes("out/room/" + file) == bytes("alone/" + file)) << file;
    EXPECT_TRUE(std::filesystem::exists(path("out/white/" + file))) << file;
  }
}

TEST_F(BakeManyTest, ADotInANameIsPartOfIt) {
  write("room.v2.exr", smoothPanorama());
  write("hall.exr", smoothPanorama());
  succeed("bake room.v2.exr hall.exr --size 8 --brdf-size 4 -o out");
  EXPECT_THAT(files(), IsSupersetOf({"out/hall/manifest.json", "out/room.v2/manifest.json"}));
}

TEST_F(BakeManyTest, ABadOneIsToldOfAndTheOthersGoOn) {
  write("bad.exr", std::string("no map"));
  const Outcome outcome = run("bake bad.exr white -o out" + std::string(kSmallSets));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: bad.exr: is not an image"),
                                 HasSubstr("mirrorball: 1 of 2 inputs could not be baked; the others are in out\n")));
  EXPECT_THAT(files(), AllOf(IsSupersetOf({"out/white/manifest.json"}), Not(Contains("out/bad/"))));
}

TEST_F(BakeManyTest, WhatCannotBeIsToldBeforeAnythingIsMade) {
  write("room.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "bake room.exr white -o out.ktx2"), HasSubstr("give -o a folder"));
  EXPECT_THAT(refuse(2, "bake room.exr ./room.exr -o out"), HasSubstr("would both become out/room"));
  EXPECT_THAT(refuse(2, "bake room.exr white -o out --extension png"), HasSubstr("'png'"));
}

TEST_F(BakeManyTest, TheTableHasTheExtensionOfTheCubes) {
  succeed("bake white -o out --extension dds" + std::string(kSmallSets));
  EXPECT_THAT(files(), AllOf(IsSupersetOf({"out/specular.dds", "out/irradiance.dds", "out/brdf.dds"}),
                             Not(Contains("out/brdf.ktx2"))));
  succeed("bake white -o other --extension dds --brdf-extension exr" + std::string(kSmallSets));
  EXPECT_THAT(files(), IsSupersetOf({"other/specular.dds", "other/brdf.exr"}));
}

}  // namespace
}  // namespace mirrorball::testing
