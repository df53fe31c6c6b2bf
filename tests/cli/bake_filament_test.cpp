// bake --for filament: the folder that Filament's cmgen would make, and what its reader and its shaders find there.

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class BakeFilamentTest : public CliTest {
 protected:
  /// sh.txt as Filament's programs read it (filamentapp, IBL::loadFromDirectory).
  FilamentHarmonics harmonicsIn(const std::string& name) const {
    const Bytes text = bytes(name);
    std::istringstream lines(std::string(text.begin(), text.end()));
    FilamentHarmonics harmonics;
    for (glm::vec3& row : harmonics) {
      std::string line;
      std::getline(lines, line);
      EXPECT_EQ(std::sscanf(line.c_str(), "(%f,%f,%f)", &row.x, &row.y, &row.z), 3) << line;
    }
    return harmonics;
  }
};

/// Light of three bands: of it Filament's polynomial leaves nothing out.
Image threeBands() {
  Image map(128, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) {
      const glm::vec3 d = directionAt(Projection::equirect, {0, (glm::vec2(x, y) + 0.5f) / glm::vec2(128, 64)});
      map.texel(x, y)[0] = 1.0f + 0.4f * d.x - 0.3f * d.y * d.z;
      map.texel(x, y)[1] = 0.8f - 0.3f * d.y + 0.2f * (d.x * d.x - d.y * d.y);
      map.texel(x, y)[2] = 0.6f + 0.2f * d.z * d.z + 0.3f * d.x * d.y - 0.1f * d.z * d.x;
    }
  return map;
}

TEST_F(BakeFilamentTest, TheFolderIsCmgens) {
  write("map.exr", smoothPanorama());
  succeed("bake map.exr --for filament -o sets/room/");
  EXPECT_THAT(files(), ElementsAre("map.exr", "sets/", "sets/room/", "sets/room/manifest.json",
                                   "sets/room/room_ibl.ktx", "sets/room/room_skybox.ktx", "sets/room/sh.txt"));
  const ImageSet levels = texture("sets/room/room_ibl.ktx");
  ASSERT_EQ(levels.levels(), 5);
  EXPECT_EQ(levels.at(0, 0).width(), 256);
  EXPECT_EQ(levels.at(4, 5).width(), 16);
  for (const std::string file : {"room_ibl.ktx", "room_skybox.ktx"})
    EXPECT_THAT(succeed("info sets/room/" + file), HasSubstr("KTX1, b10g11r11 ufloat"));
  // As fine as a panorama of 32 rows.
  EXPECT_EQ(texture("sets/room/room_skybox.ktx").at(0, 0).width(), 16);
  EXPECT_EQ(jsonIn("sets/room/manifest.json")["skybox"]["size"], 16);
}

TEST_F(BakeFilamentTest, TheFilesAreNamedByTheFolderHoweverItIsWritten) {
  std::filesystem::create_directories(path("hall/room"));
  succeed("bake white --for filament --size 32 -o hall/room/..");
  EXPECT_THAT(files(), AllOf(Contains("hall/hall_ibl.ktx"), Contains("hall/hall_skybox.ktx")));
}

TEST_F(BakeFilamentTest, TheHarmonicsAreTheIrradianceOverPi) {
  write("map.exr", threeBands());
  succeed("bake map.exr --for filament --size 32 --rotate 30 -o room");
  succeed("bake map.exr --format float32 --size 32 --irradiance-size 16 --brdf-size 2 --rotate 30 -o ours");
  const ImageSet irradiance = texture("ours/irradiance.ktx2");
  const FilamentHarmonics harmonics = harmonicsIn("room/sh.txt");
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const glm::vec3 n = directionAt(Projection::cube, {face, (glm::vec2(x, y) + 0.5f) / 16.0f});
        // surface_light_indirect.fs, Irradiance_SphericalHarmonics.
        const glm::vec3 light = harmonics[0] + harmonics[1] * n.y + harmonics[2] * n.z + harmonics[3] * n.x +
                                harmonics[4] * (n.y * n.x) + harmonics[5] * (n.y * n.z) +
                                harmonics[6] * (3.0f * n.z * n.z - 1.0f) + harmonics[7] * (n.z * n.x) +
                                harmonics[8] * (n.x * n.x - n.y * n.y);
        const glm::vec3 expected = rgbAt(irradiance.at(0, face), x, y);
        EXPECT_LT(glm::length(light - expected), 1e-4f * glm::length(expected)) << face << ": " << x << ", " << y;
      }
}

TEST_F(BakeFilamentTest, TheTextureHasTheSameHarmonics) {
  write("map.exr", threeBands());
  succeed("bake map.exr --for filament --size 32 -o room");
  succeed("bake map.exr --for filament --size 32 -o alone.ktx");
  const FilamentHarmonics written = harmonicsIn("room/sh.txt");
  for (const std::string file : {"room/room_ibl.ktx", "alone.ktx"}) {
    const nlohmann::json info = nlohmann::json::parse(succeed("info --json " + file));
    ASSERT_EQ(info["filament_harmonics"].size(), 9u) << file;
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(info["filament_harmonics"][i][c].get<float>(), written[i][static_cast<int>(c)], 1e-6f) << file;
    EXPECT_THAT(succeed("info " + file), HasSubstr("harmonics    Filament's, of irradiance / pi: 1 0."));
  }
  EXPECT_EQ(texture("alone.ktx").at(1, 3).samples()[7], texture("room/room_ibl.ktx").at(1, 3).samples()[7]);
  succeed("bake map.exr --size 32 -o ours.ktx");
  EXPECT_THAT(succeed("info ours.ktx"), Not(HasSubstr("harmonics")));
}

// lod = M r (2 - r), perceptualRoughnessToLod in surface_light_indirect.fs, with M the last level.
TEST_F(BakeFilamentTest, TheLevelsHaveTheRoughnessThatTheShaderLooksUp) {
  for (const auto& [size, count] : std::vector<std::pair<int, int>>{{256, 5}, {64, 3}, {32, 2}, {16, 5}, {100, 3}}) {
    succeed("bake white --for filament --size " + std::to_string(size) + " -o room");
    const nlohmann::json levels = jsonIn("room/manifest.json")["specular"]["levels"];
    ASSERT_EQ(levels.size(), std::size_t(count)) << size;
    ASSERT_EQ(texture("room/room_ibl.ktx").levels(), count);
    for (int level = 0; level < count; ++level) {
      const double roughness = levels[std::size_t(level)]["perceptual_roughness"];
      EXPECT_NEAR((count - 1) * roughness * (2.0 - roughness), level, 1e-5) << size;
    }
  }
}

// Filament reads cubes by world directions, which are ours.
TEST_F(BakeFilamentTest, TheWayRoundIsTheEnvironments) {
  succeed("bake uv --for filament --size 64 -o room");
  for (const std::string file : {"room/room_ibl.ktx", "room/room_skybox.ktx"}) {
    const ImageSet cube = texture(file);
    EXPECT_EQ(orientationOfName(cube.at(0, 4)), "mirrored") << file;
    for (int level = 0; level < cube.levels(); ++level) {
      EXPECT_GT(texelTowards(cube, level, {1, 0, 0}).x, texelTowards(cube, level, {-1, 0, 0}).x) << file;
      EXPECT_GT(texelTowards(cube, level, {0, 1, 0}).y, texelTowards(cube, level, {0, -1, 0}).y) << file;
      EXPECT_GT(texelTowards(cube, level, {0, 0, 1}).z, texelTowards(cube, level, {0, 0, -1}).z) << file;
    }
  }
}

TEST_F(BakeFilamentTest, LightThatTheFormatDoesNotHoldIsLoweredAndTold) {
  Image map(64, 32, 3, 0.5f);
  for (int c = 0; c < 3; ++c) map.texel(20, 10)[c] = 3e6f;
  write("sun.exr", map);
  const Outcome outcome = run("bake sun.exr --for filament --size 64 -o room");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("room/room_ibl.ktx: "), HasSubstr("of the light is lost")));
  succeed("bake sun.exr --for filament --size 64 --format float32 -o room");
  EXPECT_THAT(succeed("info room/room_ibl.ktx"), HasSubstr("r32g32b32a32 sfloat"));
}

TEST_F(BakeFilamentTest, PicturesAreCmgensToo) {
  succeed("bake white --for filament --extension hdr --size 32 -o room");
  EXPECT_THAT(files(),
              ElementsAre("room/", "room/m0_nx.hdr", "room/m0_ny.hdr", "room/m0_nz.hdr", "room/m0_px.hdr",
                          "room/m0_py.hdr", "room/m0_pz.hdr", "room/m1_nx.hdr", "room/m1_ny.hdr", "room/m1_nz.hdr",
                          "room/m1_px.hdr", "room/m1_py.hdr", "room/m1_pz.hdr", "room/manifest.json", "room/sh.txt",
                          "room/skybox_nx.hdr", "room/skybox_ny.hdr", "room/skybox_nz.hdr", "room/skybox_px.hdr",
                          "room/skybox_py.hdr", "room/skybox_pz.hdr"));
}

TEST_F(BakeFilamentTest, WhatFilamentHasNoUseForIsRefused) {
  const std::string line = "bake white --for filament -o room ";
  for (const std::string option :
       {"--brdf-size 64", "--irradiance-size 16", "--sh-degree 3", "--brdf-extension exr", "--lobe-rows 4"})
    EXPECT_THAT(refuse(2, line + option), AllOf(HasSubstr(option.substr(0, option.find(' '))),
                                                HasSubstr("Filament has a BRDF table of its own")));
  EXPECT_THAT(refuse(2, line + "--extension ktx2"),
              HasSubstr("Filament reads .ktx, no .ktx2; leave the extension to it"));
  EXPECT_THAT(refuse(2, line + "--format e5b9g9r9"),
              HasSubstr("Filament reads b10g11r11, half, float32 and bc6h, no e5b9g9r9"));
}

// What only one of the two sets has goes with the set that had it.
TEST_F(BakeFilamentTest, SetsOfBothKindsReplaceEachOther) {
  succeed("bake white --size 8 --irradiance-size 4 --brdf-size 8 --skybox-size 8 -o room");
  const std::vector<std::string> ours = files();
  EXPECT_THAT(ours, Contains("room/sh.json"));
  write("room/notes.txt", std::string("the user's own"));
  succeed("bake white --for filament --size 32 -o room");
  EXPECT_THAT(files(), ElementsAre("room/", "room/manifest.json", "room/notes.txt", "room/room_ibl.ktx",
                                   "room/room_skybox.ktx", "room/sh.txt"));
  std::filesystem::remove(path("room/notes.txt"));
  succeed("bake white --size 8 --irradiance-size 4 --brdf-size 8 --skybox-size 8 -o room");
  EXPECT_EQ(files(), ours);
}

}  // namespace
}  // namespace mirrorball::testing
