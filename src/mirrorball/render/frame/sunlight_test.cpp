// Pictures under a sun that is far brighter than a half float holds.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

namespace mirrorball {
namespace {

class SunlightTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless();
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }

  /// A sphere of a material; what fails becomes a test failure and an empty image.
  static Image radianceOf(const Environment& environment, const MaterialChanges& materials, BlurKind blur) {
    const auto draw = [&]() -> Result<Image> {
      MIRRORBALL_TRY(scene, loadModel("sphere"));
      MIRRORBALL_TRY_VOID(changeMaterials(scene, materials));
      MIRRORBALL_TRY(prepared, testing::prepareOnce(environment));
      MIRRORBALL_TRY(renderer, testing::rendererOf(std::move(scene), environment, prepared));
      FrameSettings frame;
      frame.size = {96, 64};
      frame.samples = 1;
      frame.background = BackgroundKind::blur;
      frame.blur = blur;
      return renderer.renderRadiance(frame);
    };
    auto image = draw();
    if (image) return std::move(*image);
    ADD_FAILURE() << image.error().message;
    return {};
  }

 private:
  std::optional<gl::Context> context_;
};

// A mirror shows what lies in its mirror direction, however bright the sun is elsewhere: nothing of it is missing that
// the light from all sides would have to make up for. The background, blurred, has the sun all over.
TEST_F(SunlightTest, AMirrorSeesNothingOfTheSunFarFromIt) {
  Image panorama(64, 32, 3);
  for (float& sample : panorama.samples()) sample = 1.0f;
  std::fill_n(panorama.texel(20, 12), 3, 1e8f);
  const Environment sunny(EnvironmentMap(Projection::equirect, ImageSet(std::move(panorama))));
  for (const char* material : {"mirror", "glass"}) {
    const Image image = radianceOf(sunny, {.material = material}, BlurKind::exact);
    int in_middle = 0;
    int far_from_sun = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const glm::vec3 light = rgbAt(image, x, y);
        for (int c = 0; c < 3; ++c) ASSERT_GE(light[c], 0.0f) << material;
        if (glm::distance(glm::vec2(x, y), glm::vec2(47.5f, 31.5f)) > 25.0f) continue;  // beside the sphere
        ++in_middle;
        far_from_sun += std::abs(light.y - 1.0f) < 1e-3f ? 1 : 0;
      }
    EXPECT_GT(far_from_sun, 8 * in_middle / 10) << material;
  }
}

// Light above 65504 is kept in 32-bit floats, whose chain has to be filtered like one of halves.
TEST_F(SunlightTest, TheGpuBlursItLikeTheExactChain) {
  EnvironmentMap cube = *convert(Environment([](glm::vec3 d) { return 0.2f + 0.1f * d; }, 64), Projection::cube, 128);
  std::fill_n(cube.face(4).texel(80, 50), 3, 1e5f);
  const Environment sunny(cube);
  for (const char* roughness : {"0.25", "0.5", "1"}) {
    const MaterialChanges rough{.material = "mirror", .set = {std::string("perceptual_roughness=") + roughness}};
    const Image exact = radianceOf(sunny, rough, BlurKind::exact);
    const Image made = radianceOf(sunny, rough, BlurKind::gpu);
    for (int y = 0; y < exact.height(); ++y)
      for (int x = 0; x < exact.width(); ++x)
        ASSERT_NEAR(rgbAt(made, x, y).y / rgbAt(exact, x, y).y, 1.0f, 0.03f) << roughness << ": " << x << ", " << y;
  }
}

}  // namespace
}  // namespace mirrorball
