#include "mirrorball/render/stage/technique_choice.h"

#include <gtest/gtest.h>

#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

Scene showcase() { return *loadModel("showcase"); }

bool knowsOcclusion(const Scene& scene) { return !scene.instances.front().occlusion.empty(); }

TEST(TechniqueChoice, OfADraftIsNothing) {
  Scene scene = showcase();
  FrameSettings settings;
  EXPECT_EQ(chooseTechniques(scene, {.quality = Quality::draft}, settings).value(), "");
  EXPECT_FALSE(settings.self_reflection);
  EXPECT_FALSE(knowsOcclusion(scene));
}

TEST(TechniqueChoice, OfGoodFindsWhatVerticesAreToKnow) {
  Scene scene = showcase();
  FrameSettings settings;
  const auto chosen = chooseTechniques(scene, {.quality = Quality::good}, settings);
  ASSERT_TRUE(chosen);
  EXPECT_NE(chosen->find("{option:self-reflection}"), std::string::npos) << *chosen;
  EXPECT_EQ(settings.occlusion, OcclusionKind::vertex);
  EXPECT_TRUE(knowsOcclusion(scene));
}

TEST(TechniqueChoice, LeavesWhatWasGiven) {
  Scene scene = showcase();
  FrameSettings settings;
  const auto chosen = chooseTechniques(scene, {Quality::good, {"occlusion", "self-reflection", "probes"}}, settings);
  ASSERT_TRUE(chosen);
  EXPECT_FALSE(settings.self_reflection);
  EXPECT_EQ(settings.occlusion, OcclusionKind::none);
  EXPECT_FALSE(knowsOcclusion(scene));
}

TEST(TechniqueChoice, TracesNoRaysWhereObjectsMove) {
  Scene scene = showcase();
  FrameSettings settings;
  const auto chosen = chooseTechniques(scene, {.quality = Quality::good, .objects_move = true}, settings);
  ASSERT_TRUE(chosen);
  EXPECT_FALSE(settings.self_reflection) << *chosen;
}

}  // namespace
}  // namespace mirrorball
