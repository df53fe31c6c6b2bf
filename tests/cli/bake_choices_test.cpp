// What bake's files hold when asked for otherwise than by default.

#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;

class BakeChoicesTest : public CliTest {
 protected:
  nlohmann::json json(const std::string& name) const {
    const Bytes text = bytes(name);
    return nlohmann::json::parse(text.begin(), text.end());
  }
};

constexpr const char* kSmall = "bake white -o out --size 8 --irradiance-size 4 --brdf-size 16 ";

TEST_F(BakeChoicesTest, ATableOfTwoChannelsHasNoThird) {
  succeed(std::string(kSmall));
  const Image three = texture("out/brdf.ktx2").at(0, 0);
  EXPECT_EQ(json("out/manifest.json")["brdf"]["format"], "r16g16b16a16 sfloat");
  for (const std::string extension : {"ktx2", "dds"}) {
    succeed(kSmall + std::string("--brdf-channels 2 --brdf-extension ") + extension);
    EXPECT_EQ(json("out/manifest.json")["brdf"]["format"], "r16g16 sfloat");
    EXPECT_EQ(json("out/manifest.json")["brdf"]["channels"].size(), 2u);
    EXPECT_THAT(succeed("info out/brdf." + extension), HasSubstr("r16g16 sfloat"));
    const Image two = texture("out/brdf." + extension).at(0, 0);
    for (int y = 0; y < 16; ++y)
      EXPECT_EQ(rgbAt(two, 5, y), glm::vec3(three.texel(5, y)[0], three.texel(5, y)[1], 0.0f)) << extension;
  }
}

TEST_F(BakeChoicesTest, TheTableIsStoredAsTheCubesAre) {
  succeed(kSmall + std::string("--brdf-channels 2 --format float32"));
  EXPECT_EQ(json("out/manifest.json")["brdf"]["format"], "r32g32 sfloat");
  EXPECT_EQ(bytes("out/brdf.ktx2")[12], 103) << "VK_FORMAT_R32G32_SFLOAT";
  // A table of 6 bits would be of no use.
  succeed(kSmall + std::string("--format b10g11r11"));
  EXPECT_EQ(json("out/manifest.json")["specular"]["format"], "b10g11r11 ufloat");
  EXPECT_EQ(json("out/manifest.json")["brdf"]["format"], "r16g16b16a16 sfloat");
  const std::size_t plain = bytes("out/brdf.ktx2").size();
  succeed(kSmall + std::string("--zstd 9"));
  EXPECT_LT(bytes("out/brdf.ktx2").size(), plain);
  EXPECT_EQ(texture("out/brdf.ktx2").at(0, 0).width(), 16);
}

TEST_F(BakeChoicesTest, APictureOfTheTableHasThreeChannels) {
  succeed(kSmall + std::string("--brdf-channels 2 --brdf-extension exr --distribution charlie"));
  const nlohmann::json brdf = json("out/manifest.json")["brdf"];
  EXPECT_EQ(brdf["format"], "three channels of 32-bit floats");
  EXPECT_EQ(brdf["distribution"], "charlie");
  const Image table = image("out/brdf.exr");
  EXPECT_EQ(table.channels(), 3);
  EXPECT_GT(table.texel(8, 8)[0], 0.0f);
  EXPECT_EQ(table.texel(8, 8)[2], 0.0f);
  succeed(kSmall + std::string("--brdf-extension exr --format half"));
  EXPECT_EQ(json("out/manifest.json")["brdf"]["format"], "three channels of half floats");
}

TEST_F(BakeChoicesTest, AnEngineHasItsOwnMipMapping) {
  const auto mappingOf = [&](const std::string& options) {
    succeed(std::string(kSmall) + options);
    return json("out/manifest.json")["specular"]["mip_mapping"].get<std::string>();
  };
  EXPECT_EQ(mappingOf(""), "filament");
  EXPECT_EQ(mappingOf("--for unity"), "unity");
  EXPECT_EQ(mappingOf("--for unreal"), "unreal");
  EXPECT_EQ(mappingOf("--for godot"), "frostbite");
  EXPECT_EQ(mappingOf("--for directx"), "filament");
  EXPECT_EQ(mappingOf("--for unity --mip-mapping filament"), "filament");
  EXPECT_EQ(mappingOf("--mip-mapping linear --for unreal"), "linear");
}

TEST_F(BakeChoicesTest, TheLevelsHaveTheRoughnessThatTheEngineLooksUp) {
  succeed("bake white -o out --size 32 --irradiance-size 4 --brdf-size 2 --for unity");
  const nlohmann::json levels = json("out/manifest.json")["specular"]["levels"];
  ASSERT_EQ(levels.size(), 4u);
  for (int level = 1; level < 4; ++level) {
    const double roughness = levels[std::size_t(level)]["perceptual_roughness"];
    EXPECT_NEAR(3.0 * roughness * (1.7 - 0.7 * roughness), level, 1e-5);
  }
}

}  // namespace
}  // namespace mirrorball::testing
