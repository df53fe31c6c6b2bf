#include "mirrorball/render/frame/screen_layers.h"

#include <gtest/gtest.h>

#include "mirrorball/render/light/probe_places.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/showcase.h"
#include "mirrorball/scene/shapes/tumbler.h"

namespace mirrorball {
namespace {

std::vector<ScreenLayer> layersOf(const Scene& scene, const char* behind, const char* refraction) {
  FrameSettings settings;
  testing::set(settings, "behind", behind);
  testing::set(settings, "refraction", refraction);
  std::vector<int> order;
  for (int i = 0; i < static_cast<int>(scene.instances.size()); ++i) order.push_back(i);
  return screenLayers(scene, boxesOf(scene), boundingSphere(scene).radius, order, settings);
}

TEST(ScreenLayers, WaterComesBeforeItsGlass) {
  const Scene scene = tumblerWaterScene();
  const std::vector<Box> boxes = boxesOf(scene);
  const std::vector<ScreenLayer> layers = layersOf(scene, "screen", "image-space");
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].instances, std::vector{1});
  EXPECT_TRUE(layers[0].shown.isEmpty());
  EXPECT_EQ(layers[1].instances, std::vector{0});
  // With room for a place before and one behind each surface.
  const glm::vec3 below = boxes[1].low - layers[1].shown.low;
  const glm::vec3 above = layers[1].shown.high - boxes[1].high;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(below[axis], 0.0f);
    EXPECT_GT(above[axis], 0.0f);
    EXPECT_LT(below[axis] + above[axis], 0.1f * boundingSphere(scene).radius);
  }
}

TEST(ScreenLayers, WhatIsTracedFindsWhatIsInItItself) {
  EXPECT_EQ(layersOf(tumblerWaterScene(), "screen", "traced").size(), 1u);
}

TEST(ScreenLayers, AreThoseOfWhatSeesTheScreen) {
  EXPECT_TRUE(layersOf(tumblerWaterScene(), "probes", "image-space").empty());
  const std::vector<ScreenLayer> layers = layersOf(showcaseScene(), "screen", "auto");
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].instances, std::vector{4});
  EXPECT_EQ(layers[1].instances, (std::vector{3, 6})) << "the tumbler and the brilliant";
}

}  // namespace
}  // namespace mirrorball
