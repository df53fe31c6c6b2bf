// Bumps that are smaller than a pixel widen what it reflects, and do not sparkle.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {
namespace {

class BumpFilterTest : public testing::HeadlessTest {
 protected:
  static Image radianceOf(const MaterialChanges& materials, const FrameSettings& settings) {
    const Environment evening = *builtinEnvironment("sky:elevation=8");
    Scene scene = *loadModel("sphere");
    EXPECT_TRUE(changeMaterials(scene, materials));
    EXPECT_TRUE(prepareRelief(scene, settings.relief));
    auto renderer = testing::rendererOf(std::move(scene), evening, *testing::prepareOnce(evening));
    EXPECT_TRUE(renderer);
    auto image = renderer->renderRadiance(settings);
    EXPECT_TRUE(image);
    return std::move(*image);
  }
};

// Seen from far away, against so many samples that each sees less than a pore.
TEST_F(BumpFilterTest, AnOrangeUnderALowSunDoesNotSparkle) {
  FrameSettings settings{.size = {32, 32}, .background = BackgroundKind::transparent, .samples = 8};
  for (const char* frequency : {"height_frequency=12", "height_frequency=60"}) {
    const std::string height =
        frequency == std::string("height_frequency=12") ? "height_scale=0.01" : "height_scale=0.004";
    const MaterialChanges orange{.material = "orange", .set = {frequency, height}};
    settings.samples = 8;
    const Image seen = radianceOf(orange, settings);
    settings.samples = 256;
    const Image truth = radianceOf(orange, settings);
    int sparkles = 0;
    int inside = 0;
    float most = 0.0f;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x) {
        if (rgbaAt(truth, x, y).w < 1.0f) continue;
        ++inside;
        const float expected = rgbAt(truth, x, y).y;
        most = std::max(most, rgbAt(seen, x, y).y / expected);
        if (rgbAt(seen, x, y).y > 1.5f * expected) ++sparkles;
      }
    EXPECT_GT(inside, 200);
    EXPECT_EQ(sparkles, 0) << frequency << ": " << most;
  }
}

}  // namespace
}  // namespace mirrorball
