// Each quality of `render` beside the path-traced reference, of scenes made here. Nothing is stored: all pictures
// are made.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "golden/made_picture.h"
#include "mirrorball/gl/gl_testing.h"
#include "quality/scenes.h"

namespace mirrorball::quality {
namespace {

class QualityBesideTruth : public ::testing::TestWithParam<SampleScene> {};

TEST_P(QualityBesideTruth, GoodIsNearerThanDraft) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  const SampleScene& scene = GetParam();
  const auto file = writeScene(scene, ::testing::TempDir());
  ASSERT_TRUE(file) << file.error().message;
  const auto made = [&](const std::string& how) {
    return golden::imageMadeBy("render " + file->string() + " " + shownBy(scene, how));
  };
  const auto traced = made("--reference --samples " + std::to_string(kPaths));
  const auto draft = made("--quality draft");
  const auto good = made("--quality good");
  for (const auto* picture : {&traced, &draft, &good}) ASSERT_TRUE(*picture) << picture->error().message;
  const double draft_db = golden::psnrOf_db(*draft, *traced);
  const double good_db = golden::psnrOf_db(*good, *traced);
  // Half a decibel is what another driver's filtering may take.
  EXPECT_NEAR(draft_db, scene.draft_db, 0.5);
  EXPECT_GT(good_db, scene.good_db - 0.5);
  EXPECT_GT(good_db, draft_db + 1.0);
}
INSTANTIATE_TEST_SUITE_P(Scenes, QualityBesideTruth, ::testing::ValuesIn(sampleScenes()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace mirrorball::quality
