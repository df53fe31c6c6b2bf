// What glTF's extensions lay on a surface, as the renderer draws it.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

class LayersTest : public testing::HeadlessTest {
 protected:
  /// A built-in model, all of a material that is set so.
  static Image radiance(const char* model, const std::vector<std::string>& set, const Environment& environment,
                        const FrameSettings& settings) {
    Scene scene = *loadModel(model);
    EXPECT_TRUE(changeMaterials(scene, {.material = "plastic", .set = set}));
    auto renderer = testing::rendererOf(std::move(scene), environment, *testing::prepareOnce(environment));
    EXPECT_TRUE(renderer);
    auto image = renderer->renderRadiance(settings);
    EXPECT_TRUE(image);
    return std::move(*image);
  }
};

// They reflect, or let through what they do not: of white layers over white all light comes back.
TEST_F(LayersTest, WhiteOnesLoseNothing) {
  const std::vector<std::vector<std::string>> cases = {
      {"clearcoat=0.7"},
      {"metallic=1", "clearcoat=0.7", "clearcoat_roughness=0.6"},
      {"sheen_color=1", "sheen_roughness=0.5"},
      {"sheen_color=0.5", "sheen_roughness=1", "clearcoat=1", "clearcoat_roughness=0.6"},
      {"metallic=1", "perceptual_roughness=0.2", "anisotropy=0.8", "anisotropy_rotation=0.5"},
      {"iridescence=1", "perceptual_roughness=0"},
      {"iridescence=0.5", "transmission=1", "thin_walled=yes", "perceptual_roughness=0.3"}};
  FrameSettings settings{.size = {72, 48}, .background = BackgroundKind::transparent};
  for (const std::vector<std::string>& layers : cases) {
    std::vector<std::string> set = {"base_color=1"};
    set.insert(set.end(), layers.begin(), layers.end());
    testing::expectFurnaceWhite(radiance("torus", set, *builtinEnvironment("white"), settings), layers.back(), 2e-3f);
  }
}

// A lamp is as sharp in a smooth coat over rough black as in a mirror, at Fresnel's strength.
TEST_F(LayersTest, AClearCoatMirrorsALampOverRoughPaint) {
  const Environment lamp([](glm::vec3 d) { return glm::vec3(d.z > 0.98f ? 100.0f : 0.0f); }, 256);
  FrameSettings settings{.size = {33, 33}};
  testing::aim(settings, 0, 0);
  settings.camera.orthographic_height = 0.2f;  // the middle of a sphere
  const std::vector<std::string> paint = {"base_color=0", "specular=0", "perceptual_roughness=1"};
  EXPECT_LT(rgbAt(radiance("sphere", paint, lamp, settings), 16, 16).y, 0.01f);
  std::vector<std::string> coated = paint;
  coated.emplace_back("clearcoat=1");
  EXPECT_NEAR(rgbAt(radiance("sphere", coated, lamp, settings), 16, 16).y, 4.0f, 0.05f)
      << "((1.5 - 1) / (1.5 + 1))² of the lamp";
}

// Brushed along the sphere's circles of latitude, a lamp behind the eye is drawn out to the left and the right; turned
// by a quarter, upwards and downwards.
TEST_F(LayersTest, AnisotropyDrawsHighlightsOutAlongTheTangent) {
  const Environment lamp([](glm::vec3 d) { return glm::vec3(d.z > 0.995f ? 100.0f : 0.0f); }, 256);
  FrameSettings settings{.size = {65, 65}};
  testing::aim(settings, 0, 0);
  settings.camera.orthographic_height = 2.0f;
  for (const bool is_turned : {false, true}) {
    const Image image = radiance("sphere",
                                 {"metallic=1", "base_color=1", "perceptual_roughness=0.25", "anisotropy=0.7",
                                  is_turned ? "anisotropy_rotation=1.5708" : "anisotropy_rotation=0"},
                                 lamp, settings);
    const float beside = rgbAt(image, 32 + 12, 32).y, above = rgbAt(image, 32, 32 - 12).y;
    EXPECT_GT(is_turned ? above : beside, 4.0f * (is_turned ? beside : above));
  }
}

}  // namespace
}  // namespace mirrorball
