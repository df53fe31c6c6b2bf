// Materials by name, and their parameters.

#include "mirrorball/scene/material/material.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

class MaterialCliTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    if (!IsSkipped()) succeed("convert studio --to equirect --size 64 -o studio.exr");
  }

  /// Draws 48 × 48 pixels in the studio, nothing behind the model.
  Image draw(const std::string& options) const {
    succeed("render " + options + " -e studio.exr --size 48x48 --background transparent -o picture.exr");
    return image("picture.exr");
  }
};

// But for those that are another one by a second name.
TEST_F(MaterialCliTest, EveryMaterialLooksLikeNoOther) {
  const std::set<std::string> second_names = {"chrome", "glass"};
  std::map<std::string, Image> pictures;
  for (const std::string_view name : materialNames()) {
    if (second_names.contains(std::string(name))) continue;
    const Image picture = draw("sphere --material " + std::string(name));
    EXPECT_GT(contentsOf(picture).texels, 1000) << name;
    EXPECT_GT(contentsOf(picture).mean, 0.05) << name;
    for (const auto& [other, its_picture] : pictures)
      EXPECT_GT(meanDifference(picture, its_picture), 3e-4) << name << " and " << other;
    pictures[std::string(name)] = picture;
  }
  EXPECT_EQ(meanDifference(draw("sphere --material chrome"), pictures.at("chromium")), 0.0);
  EXPECT_EQ(meanDifference(draw("sphere --material glass"), pictures.at("bk7")), 0.0);
}

TEST_F(MaterialCliTest, SetTakesEveryParameterOfTheTable) {
  const Material defaults;
  std::vector<std::string> line{"render", "sphere", "-e", "studio.exr", "--size", "48x48", "-o", "set.exr"};
  for (const Option<Material>& parameter : materialParameters()) {
    line.push_back("--set");
    line.push_back(std::string(parameter.text.name) + "=" + written(parameter, defaults));
  }
  succeed(line);
  succeed("render sphere -e studio.exr --size 48x48 -o plain.exr");
  EXPECT_TRUE(bytes("set.exr") == bytes("plain.exr")) << "every parameter was set to what it is anyway";
}

/// Sweeps that start the program for each parameter: with N, for each N-th. All of them take a minute, and are left to
/// ./test --long.
class MaterialSweepTest : public MaterialCliTest, public ::testing::WithParamInterface<std::size_t> {};

TEST_P(MaterialSweepTest, ParametersThatASphereHasChangeThePicture) {
  struct Change {
    const char* base;
    const char* assignment;
  };
  std::map<std::string, Image> bases;
  std::size_t number = 0;
  for (const Change& change : {Change{"", "base_color=0.1,0.5,0.9"},
                               Change{"", "metallic=1"},
                               Change{"", "perceptual_roughness=0"},
                               Change{"", "specular=0"},
                               Change{"", "ior=2.4"},
                               Change{"--material glass", "dispersion=3"},
                               Change{"", "transmission=1"},
                               Change{"--material gold", "conductor_n=2"},
                               Change{"--material gold", "conductor_k=1,2,3"},
                               Change{"", "emission=0.5,0.25,0"},
                               Change{"--material water", "fresnel=empirical"},
                               Change{"--material water --fresnel empirical", "fresnel_offset=0.3"},
                               Change{"--material water --fresnel empirical", "fresnel_scale=0.5"},
                               Change{"--material water --fresnel empirical", "fresnel_power=2"},
                               Change{"--material gold --fresnel f82", "f82_tint=0.5"},
                               Change{"", "bump=orange"},
                               Change{"--material orange", "bump_height=0.02"},
                               Change{"--material orange", "bump_frequency=8"},
                               Change{"", "clearcoat=1"},
                               Change{"--material car-paint", "clearcoat_roughness=0.5"},
                               Change{"", "sheen_color=0.5,0.2,0.1"},
                               Change{"--material velvet", "sheen_roughness=1"},
                               Change{"--material rough-metal", "anisotropy=0.8"},
                               Change{"--material brushed-metal", "anisotropy_rotation=1"},
                               Change{"", "iridescence=1"},
                               Change{"--material soap-bubble", "iridescence_ior=1.6"},
                               Change{"--material soap-bubble", "iridescence_thickness=300"}}) {
    if (number++ % GetParam() != 0) continue;
    const std::string base = std::string("sphere ") + change.base;
    if (!bases.contains(base)) bases[base] = draw(base);
    EXPECT_GT(meanDifference(draw(base + " --set " + change.assignment), bases[base]), 3e-4)
        << change.base << " with " << change.assignment;
  }
}

TEST_P(MaterialSweepTest, MapsThatAreSetChangeThePicture) {
  Image8 pattern(2, 2, 4);
  for (std::size_t i = 0; i < pattern.samples().size(); ++i)
    pattern.samples()[i] = static_cast<std::uint8_t>(40 + 13 * i);
  ASSERT_TRUE(savePicture(path("pattern.png"), pattern));
  const std::string base =
      "sphere --set metallic=0.5 --set emission=0.5 --set transmission=0.5 --set clearcoat=1 --set "
      "clearcoat_roughness=0.5 "
      "--set sheen_color=0.5 --set sheen_roughness=0.7 --set anisotropy=0.8 --set iridescence=1";
  const Image plain = draw(base);
  std::string all = base;
  std::size_t number = 0;
  for (const MaterialMap& map : materialMaps()) {
    const std::string setting = " --set " + std::string(map.name) + "=pattern.png";
    all += setting;
    if (number++ % GetParam() != 0) continue;
    EXPECT_GT(meanDifference(draw(base + setting), plain), 3e-4) << map.name;
  }
  draw(all);
}

INSTANTIATE_TEST_SUITE_P(Every, MaterialSweepTest, ::testing::Values(1));
INSTANTIATE_TEST_SUITE_P(Some, MaterialSweepTest, ::testing::Values(4));

TEST_F(MaterialCliTest, ALaterSetWinsAndOneNumberSetsThreeChannels) {
  draw("sphere --set metallic=1 --set base_color=0.2 --set base_color=0.5");
  const Bytes last = bytes("picture.exr");
  draw("sphere --set metallic=1 --set base_color=0.5,0.5,0.5");
  EXPECT_TRUE(bytes("picture.exr") == last);
}

TEST_F(MaterialCliTest, OpacityIsTheCoverage) {
  const Image picture = draw("sphere --set opacity=0.25");
  EXPECT_NEAR(rgbaAt(picture, 24, 24).w, 0.25f, 1e-3f);
}

}  // namespace
}  // namespace mirrorball::testing
