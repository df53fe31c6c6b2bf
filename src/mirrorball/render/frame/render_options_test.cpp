#include "mirrorball/render/frame/render_options.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

std::string errorOf(const RenderOptions& options) {
  const auto settings = frameSettings(options);
  return settings ? "" : settings.error().message;
}

TEST(RenderOptions, DefaultsAreWhatTheProjectPromises) {
  const FrameSettings settings = *frameSettings({});
  EXPECT_EQ(settings.size, glm::ivec2(1280, 720));
  EXPECT_EQ(settings.camera.azimuth_deg, 30.0f);
  EXPECT_EQ(settings.camera.elevation_deg, 15.0f);
  EXPECT_EQ(settings.display.exposure(), 1.0f);
  EXPECT_EQ(settings.background, BackgroundKind::environment);
}

TEST(RenderOptions, EveryRowHasANameOfItsOwnAndHelp) {
  std::set<std::string_view> names;
  for (const auto& option : renderOptions()) {
    EXPECT_TRUE(names.insert(option.text.name).second) << option.text.name;
    EXPECT_FALSE(option.text.help.empty()) << option.text.name;
  }
}

TEST(RenderOptions, SizesAreChecked) {
  RenderOptions options;
  options.size = "640x480";
  EXPECT_EQ(frameSettings(options)->size, glm::ivec2(640, 480));
  for (const char* wrong : {"", "640", "640x", "0x480", "640x480x3", "640.5x480", "-1x5", "99999x1", "axb"}) {
    options.size = wrong;
    EXPECT_THAT(errorOf(options), HasSubstr("--size takes WIDTHxHEIGHT")) << wrong;
  }
}

TEST(RenderOptions, BackgroundsAreParsed) {
  RenderOptions options;
  options.background = "#ff8000";
  FrameSettings settings = *frameSettings(options);
  EXPECT_EQ(settings.background, BackgroundKind::display_color);
  EXPECT_NEAR(settings.background_color.x, 1.0f, 1e-6f);
  EXPECT_NEAR(settings.background_color.y, 0.2158605f, 1e-5f) << "sRGB 128";
  options.background = "0.5,2,0";
  EXPECT_EQ(frameSettings(options)->background, BackgroundKind::radiance);
  EXPECT_EQ(frameSettings(options)->background_color, glm::vec3(0.5f, 2.0f, 0.0f));
  options.background = "transparent";
  EXPECT_EQ(frameSettings(options)->background, BackgroundKind::transparent);
  for (const char* wrong : {"#ff80", "#gg8000", "red", "1,2"}) {
    options.background = wrong;
    EXPECT_THAT(errorOf(options), HasSubstr("--background takes env, blur")) << wrong;
  }
}

TEST(RenderOptions, LightsAreParsedAndLimited) {
  RenderOptions options;
  options.lights = {"1,2,3,4,5,6"};
  EXPECT_EQ(frameSettings(options)->lights[0].color, glm::vec3(4, 5, 6));
  options.lights = {"1,2,3"};
  EXPECT_THAT(errorOf(options), HasSubstr("--light takes 6 numbers"));
  options.lights.assign(9, "1,2,3,4,5,6");
  EXPECT_THAT(errorOf(options), HasSubstr("8 times at most"));
}

TEST(RenderOptions, CamerasAreChecked) {
  RenderOptions options;
  options.camera = {10, 20, 3};
  EXPECT_EQ(frameSettings(options)->camera.distance, 3.0f);
  options.camera = {10, 91};
  EXPECT_THAT(errorOf(options), HasSubstr("elevation from -90 to 90"));
  options.camera = {10, 20, 0};
  EXPECT_THAT(errorOf(options), HasSubstr("distance above 0"));
}

TEST(RenderOptions, MaterialOptionsReachEverySurface) {
  Scene scene;
  scene.materials.resize(2);
  scene.meshes.resize(2);
  scene.meshes[1].material = 1;
  scene.meshes[1].vertices.resize(1);
  scene.meshes[1].vertices[0].color = glm::vec4(0.5f);
  RenderOptions options;
  options.set = {"metallic=0.25"};
  ASSERT_TRUE(applyMaterialOptions(options, scene));
  EXPECT_EQ(scene.materials[1].metallic, 0.25f);

  options.material = "gold";
  options.fresnel = FresnelOverride::empirical;
  ASSERT_TRUE(applyMaterialOptions(options, scene));
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].fresnel, formula::kFresnelEmpirical);
  EXPECT_EQ(scene.meshes[1].material, 0);
  EXPECT_EQ(scene.meshes[1].vertices[0].color, glm::vec4(1.0f));

  options.material = "godl";
  EXPECT_THAT(applyMaterialOptions(options, scene).error().message, HasSubstr("did you mean 'gold'"));
}

}  // namespace
}  // namespace mirrorball
