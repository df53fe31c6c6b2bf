// What bake's files hold when asked for otherwise than by default.

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class BakeChoicesTest : public CliTest {};

constexpr const char* kSmall = "bake white -o out --size 8 --irradiance-size 4 --brdf-size 16 ";

TEST_F(BakeChoicesTest, ATableOfTwoChannelsHasNoThird) {
  succeed(std::string(kSmall));
  const Image three = texture("out/brdf.ktx2").at(0, 0);
  EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["format"], "r16g16b16a16 sfloat");
  for (const std::string extension : {"ktx2", "dds"}) {
    succeed(kSmall + std::string("--brdf-channels 2 --brdf-extension ") + extension);
    EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["format"], "r16g16 sfloat");
    EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["channels"].size(), 2u);
    EXPECT_THAT(succeed("info out/brdf." + extension), HasSubstr("r16g16 sfloat"));
    const Image two = texture("out/brdf." + extension).at(0, 0);
    for (int y = 0; y < 16; ++y)
      EXPECT_EQ(rgbAt(two, 5, y), glm::vec3(three.texel(5, y)[0], three.texel(5, y)[1], 0.0f)) << extension;
  }
}

TEST_F(BakeChoicesTest, TheTableIsStoredAsTheCubesAre) {
  succeed(kSmall + std::string("--brdf-channels 2 --format float32"));
  EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["format"], "r32g32 sfloat");
  EXPECT_EQ(bytes("out/brdf.ktx2")[12], 103) << "VK_FORMAT_R32G32_SFLOAT";
  // A table of 6 bits would be of no use.
  succeed(kSmall + std::string("--format b10g11r11"));
  EXPECT_EQ(jsonIn("out/manifest.json")["specular"]["format"], "b10g11r11 ufloat");
  EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["format"], "r16g16b16a16 sfloat");
  const std::size_t plain = bytes("out/brdf.ktx2").size();
  succeed(kSmall + std::string("--zstd 9"));
  EXPECT_LT(bytes("out/brdf.ktx2").size(), plain);
  EXPECT_EQ(texture("out/brdf.ktx2").at(0, 0).width(), 16);
}

TEST_F(BakeChoicesTest, APictureOfTheTableHasThreeChannels) {
  succeed(kSmall + std::string("--brdf-channels 2 --brdf-extension exr --distribution charlie"));
  const nlohmann::json brdf = jsonIn("out/manifest.json")["brdf"];
  EXPECT_EQ(brdf["format"], "three channels of 32-bit floats");
  EXPECT_EQ(brdf["distribution"], "charlie");
  const Image table = image("out/brdf.exr");
  EXPECT_EQ(table.channels(), 3);
  EXPECT_GT(table.texel(8, 8)[0], 0.0f);
  EXPECT_EQ(table.texel(8, 8)[2], 0.0f);
  succeed(kSmall + std::string("--brdf-extension exr --format half"));
  EXPECT_EQ(jsonIn("out/manifest.json")["brdf"]["format"], "three channels of half floats");
}

TEST_F(BakeChoicesTest, AnEngineHasItsOwnMipMapping) {
  const auto mappingOf = [&](const std::string& options) {
    EXPECT_EQ(run(std::string(kSmall) + options).exit_code, 0) << options;
    return jsonIn("out/manifest.json")["specular"]["mip_mapping"].get<std::string>();
  };
  EXPECT_EQ(mappingOf(""), "filament");
  EXPECT_EQ(mappingOf("--for unity"), "unity");
  EXPECT_EQ(mappingOf("--for unreal"), "unreal");
  EXPECT_EQ(mappingOf("--for godot"), "frostbite");
  EXPECT_EQ(mappingOf("--for directx"), "filament");
  EXPECT_EQ(mappingOf("--for unity --mip-mapping filament"), "filament");
  EXPECT_EQ(mappingOf("--mip-mapping linear --for unreal"), "linear");
}

// What their importers take of cubes: docs/engines.
TEST_F(BakeChoicesTest, AnEngineHasTexturesThatItImports) {
  for (const std::string program : {"unreal", "unity", "godot"}) {
    succeed(kSmall + ("--quiet --for " + program));
    const ImageSet chain = texture("out/specular.dds");
    EXPECT_EQ(chain.faces(), 6) << program;
    EXPECT_THAT(succeed("info out/specular.dds"), HasSubstr("r16g16b16a16 sfloat")) << program;
    // Godot refuses a chain that ends before 1 x 1.
    EXPECT_EQ(chain.at(chain.levels() - 1, 0).width(), program == "godot" ? 1 : 4) << program;
    EXPECT_EQ(texture("out/irradiance.dds").faces(), 6) << program;
    EXPECT_EQ(texture("out/brdf.dds").at(0, 0).width(), 16) << program;
  }
  EXPECT_THAT(refuse(2, kSmall + std::string("--for unreal --format bc6h")),
              HasSubstr("Unreal Engine reads half and float32, no bc6h"));
  EXPECT_THAT(refuse(2, kSmall + std::string("--for godot --format b10g11r11")), HasSubstr("no b10g11r11"));
  succeed(kSmall + std::string("--for godot --format bc6h"));
  succeed(kSmall + std::string("--for unreal --extension ktx2 --format bc6h"));
  EXPECT_EQ(texture("out/specular.ktx2").faces(), 6);
}

TEST_F(BakeChoicesTest, TheLevelsHaveTheRoughnessThatTheEngineLooksUp) {
  const Outcome outcome = run("bake white -o out --size 32 --irradiance-size 4 --brdf-size 2 --for unity");
  EXPECT_THAT(outcome.err, HasSubstr("Unity looks for roughness 1 in level 6, and this chain has it in level 3"));
  succeed("bake white -o six --size 64 --levels 7 --irradiance-size 4 --brdf-size 2 --for unity");
  const nlohmann::json levels = jsonIn("out/manifest.json")["specular"]["levels"];
  ASSERT_EQ(levels.size(), 4u);
  for (int level = 1; level < 4; ++level) {
    const double roughness = levels[std::size_t(level)]["perceptual_roughness"];
    EXPECT_NEAR(3.0 * roughness * (1.7 - 0.7 * roughness), level, 1e-5);
  }
}

// By 90 degrees texels come to lie where other texels were.
TEST_F(BakeChoicesTest, RotationTurnsEveryMap) {
  write("map.exr", smoothPanorama());
  const std::string chain = "bake map.exr --size 16 --format float32 ";
  const std::string command = chain + "--irradiance-size 8 --brdf-size 2 --sh-degree 4 ";
  succeed(command + "-o ours");
  for (const auto& [rotate, target_from_source] : std::vector<std::pair<std::string, glm::mat3>>{
           {"90", {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}, {"0,90", {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}}) {
    succeed(command + "-o turned --rotate " + rotate);
    succeed(chain + "-o turned.ktx2 --rotate " + rotate);
    EXPECT_EQ(texture("turned.ktx2").at(1, 3).samples()[5], texture("turned/specular.ktx2").at(1, 3).samples()[5]);
    for (const std::string file : {"specular.ktx2", "irradiance.ktx2"}) {
      const ImageSet before = texture("ours/" + file);
      const ImageSet after = texture("turned/" + file);
      for (int level = 0; level < before.levels(); ++level)
        for (int face = 0; face < 6; ++face)
          for (int x = 0; x < before.at(level, 0).width(); ++x) {
            const glm::vec2 uv = (glm::vec2(x, 1) + 0.5f) / float(before.at(level, 0).width());
            const glm::vec3 direction = directionAt(Projection::cube, {face, uv});
            const glm::vec3 light = rgbAt(before.at(level, face), x, 1);
            EXPECT_LT(glm::distance(texelTowards(after, level, target_from_source * direction), light), 1e-3f)
                << file << " by " << rotate << " level " << level;
          }
    }
    // Harmonics 1, 2 and 3 are y, z and x.
    const auto coefficients = [&](const std::string& folder, const std::string& form) {
      glm::vec3 red;
      for (int axis = 0; axis < 3; ++axis)
        red[axis] = jsonIn(folder + "/sh.json")[form][std::size_t((axis + 2) % 3 + 1)][0];
      return red;
    };
    for (const std::string form : {"radiance", "irradiance_windowed"})
      EXPECT_LT(glm::distance(coefficients("turned", form), target_from_source * coefficients("ours", form)), 1e-4f);
    EXPECT_EQ(jsonIn("turned/manifest.json")["rotate_deg"].size(), rotate == "90" ? 1u : 2u);
  }
}

TEST_F(BakeChoicesTest, LevelsAreAsManyAsAskedFor) {
  for (const int count : {1, 2, 5}) {
    succeed("bake white -o out --size 16 --irradiance-size 4 --brdf-size 2 --levels " + std::to_string(count));
    EXPECT_EQ(texture("out/specular.ktx2").levels(), count);
    const nlohmann::json levels = jsonIn("out/manifest.json")["specular"]["levels"];
    ASSERT_EQ(levels.size(), std::size_t(count));
    EXPECT_EQ(levels[0]["perceptual_roughness"], 0.0);
    EXPECT_EQ(levels.back()["perceptual_roughness"], count > 1 ? 1.0 : 0.0);
  }
  EXPECT_EQ(texture("out/specular.ktx2").at(4, 5).width(), 1);
  EXPECT_THAT(refuse(2, "bake white -o out --size 16 --levels 6"), HasSubstr("has at most 5"));
}

TEST_F(BakeChoicesTest, AChainOfOneLevelIsTold) {
  const Outcome outcome = run("bake white -o chain.ktx2 --size 7");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("level 0 only"), HasSubstr("--levels")));
  EXPECT_EQ(texture("chain.ktx2").levels(), 1);
  succeed("bake white -o chain.ktx2 --size 7 --levels 1");
  succeed("bake white -o chain.ktx2 --size 8");
}

TEST_F(BakeChoicesTest, MapsOfAnOlderSetDoNotLieBesideTheNewOnes) {
  succeed(std::string(kSmall) + "--extension dds --brdf-extension exr");
  EXPECT_THAT(files(), IsSupersetOf({"out/brdf.exr", "out/irradiance.dds", "out/specular.dds"}));
  write("out/other.dds", std::string("the user's own"));
  succeed(std::string(kSmall));
  EXPECT_THAT(files(),
              ElementsAre("out/", "out/brdf.ktx2", "out/irradiance.ktx2", "out/lobe_rows.json", "out/lobe_rows.ktx2",
                          "out/manifest.json", "out/other.dds", "out/sh.h", "out/sh.json", "out/specular.ktx2"));
}

TEST_F(BakeChoicesTest, AnEnvironmentThatAnOlderSetHadMadeStays) {
  succeed(std::string(kSmall) + "--extension dds");
  succeed("bake out/specular.dds -o out --size 8 --irradiance-size 4 --brdf-size 2");
  EXPECT_THAT(files(), IsSupersetOf({"out/specular.dds", "out/specular.ktx2"}));
  EXPECT_THAT(files(), Not(Contains("out/irradiance.dds")));
}

// Only what a manifest names is known to be ours, and only in its own folder.
TEST_F(BakeChoicesTest, FilesThatNoManifestNamesStay) {
  succeed(std::string(kSmall));
  write("out/specular.dds", std::string("the user's own"));
  write("irradiance.dds", std::string("the user's own"));
  for (const std::string manifest :
       {R"({"specular": {"file": "specular.ktx2"}, "irradiance": {"file": "../irradiance.dds"}})", "[1, 2]",
        R"({"specular": 3, "brdf": {"file": 4}})", "no JSON"}) {
    write("out/manifest.json", manifest);
    succeed(std::string(kSmall));
    EXPECT_THAT(files(), IsSupersetOf({"irradiance.dds", "out/specular.dds", "out/specular.ktx2"})) << manifest;
  }
}

}  // namespace
}  // namespace mirrorball::testing
