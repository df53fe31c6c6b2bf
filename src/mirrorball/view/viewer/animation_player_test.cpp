// Models that move by themselves.

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/gltf/gltf_animation_testing.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::differing;
using testing::finish;
using testing::kViewerSize;

class AnimationPlayerTest : public testing::ViewerTest {
 protected:
  /// Two triangles that glow, of which the right one walks away and back in 2 s.
  static Workspace walking() {
    testing::TriangleFile file;
    testing::AnimationMaker walk(file.maker);
    walk.move(R"("node":1,"path":"translation")", {0, 1, 2}, {2, 0, 0, 2, 0, -6, 2, 0, 0}, "VEC3");
    Workspace workspace;
    workspace.model = ::testing::TempDir() + "walk.gltf";
    std::ofstream(workspace.model) << file.json(
        R"("nodes":[{"mesh":0},{"mesh":0,"translation":[2,0,0]}],"materials":[{"emissiveFactor":[1,1,1]}],)"
        R"("animations":[)" +
            walk.json("Walk") + "]",
        "", ",\"material\":0");
    workspace.frame = {{"quality", {"draft"}}, {"background", {"#000000"}}, {"camera", {"0,0"}}, {"samples", {"1"}}};
    return workspace;
  }

  /// Lets so much time go on in small steps.
  static void advance(Viewer& viewer, double seconds) {
    constexpr double kStep_s = 0.05;
    for (double gone_s = 0.0; gone_s < seconds; gone_s += kStep_s) {
      const auto drawn = viewer.advance(kStep_s);
      ASSERT_TRUE(drawn) << drawn.error().message;
    }
  }

  /// How far the still triangle reaches from the left, as shares of the picture's width.
  static glm::vec2 stillTriangle(const Viewer& viewer) {
    const Image8 picture = *viewer.picture();
    const int row = picture.height() / 2;
    const auto is_lit = [&](int x) { return picture.texel(x, row)[0] > 40; };
    int begin = 0;
    while (begin < picture.width() && !is_lit(begin)) ++begin;
    int end = begin;
    while (end < picture.width() && is_lit(end)) ++end;
    return glm::vec2(begin, end) / static_cast<float>(picture.width());
  }
};

TEST_F(AnimationPlayerTest, PlaysAndStopsByAKey) {
  const Workspace start = walking();
  Viewer viewer(device(), start, kViewerSize);
  finish(viewer);
  const Image8 before = *viewer.picture();
  EXPECT_EQ(viewer.status().animation.names, std::vector<std::string>{"Walk"});
  EXPECT_FALSE(viewer.status().animation.shown);
  viewer.handle(KeyPressed{"Space"});
  advance(viewer, 0.8);
  EXPECT_FALSE(viewer.isDone()) << "it goes on";
  viewer.handle(KeyPressed{"Space"});
  finish(viewer);
  const AnimationStatus stopped = viewer.status().animation;
  EXPECT_GT(stopped.seconds, 0.4f);
  EXPECT_LT(stopped.seconds, 0.9f);
  EXPECT_FLOAT_EQ(stopped.length_s, 2.0f);
  EXPECT_GT(differing(*viewer.picture(), before, 0, kViewerSize.x), 10);
  Viewer other(device(), viewer.workspace(), kViewerSize);
  finish(other);
  EXPECT_EQ(differing(*viewer.picture(), *other.picture(), 0, kViewerSize.x), 0) << "its workspace says all";
  while (viewer.history().undo()) {
  }
  finish(viewer);
  EXPECT_EQ(viewer.workspace(), start);
  EXPECT_EQ(differing(*viewer.picture(), before, 0, kViewerSize.x), 0);
}

TEST_F(AnimationPlayerTest, TheCameraStaysWhereItIs) {
  Viewer viewer(device(), walking(), kViewerSize);
  finish(viewer);
  const glm::vec2 before = stillTriangle(viewer);
  viewer.handle(KeyPressed{"Space"});
  for (int i = 0; i < 4; ++i) {
    advance(viewer, 0.3);
    EXPECT_LT(glm::distance(stillTriangle(viewer), before), 0.05f) << i;
  }
  viewer.handle(KeyPressed{"Space"});
  finish(viewer);
  EXPECT_LT(glm::distance(stillTriangle(viewer), before), 0.02f) << "when it has stopped, too";
}

TEST_F(AnimationPlayerTest, AHandMovesTheCameraMeanwhile) {
  Viewer viewer(device(), walking(), kViewerSize);
  finish(viewer);
  viewer.handle(KeyPressed{"Space"});
  advance(viewer, 0.3);
  viewer.handle(PointerPressed{PointerButton::left, {20, 20}});
  viewer.handle(PointerMoved{{40, 20}});
  advance(viewer, 0.3);
  viewer.handle(PointerReleased{PointerButton::left});
  EXPECT_NE(frameOf(viewer.workspace(), 0)->camera.azimuth_deg, 0.0f);
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_TRUE(viewer.workspace().plays) << "the hand was one step";
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_EQ(viewer.workspace(), walking());
}

TEST_F(AnimationPlayerTest, OneUndoLeadsBackToBeforeItPlayed) {
  const Workspace start = walking();
  Viewer viewer(device(), start, kViewerSize);
  finish(viewer);
  viewer.handle(KeyPressed{"Space"});
  advance(viewer, 0.3);
  viewer.handle(KeyPressed{"Space"});
  finish(viewer);
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_EQ(viewer.workspace(), start);
}

TEST_F(AnimationPlayerTest, WhatIsKeptMeanwhileIsWhatIsSeen) {
  Viewer viewer(device(), walking(), kViewerSize);
  finish(viewer);
  const glm::vec2 seen = stillTriangle(viewer);
  viewer.handle(KeyPressed{"Space"});
  advance(viewer, 0.6);
  const Workspace kept = viewer.stillWorkspace();
  EXPECT_FALSE(kept.plays);
  Viewer other(device(), kept, kViewerSize);
  finish(other);
  EXPECT_LT(glm::distance(stillTriangle(other), seen), 0.02f);
}

TEST_F(AnimationPlayerTest, StandsStillWhileTheMapAloneIsSeen) {
  Viewer viewer(device(), walking(), kViewerSize);
  finish(viewer);
  viewer.handle(KeyPressed{"Space"});
  advance(viewer, 0.3);
  viewer.handle(KeyPressed{"M"});
  finish(viewer);
  const Workspace still = viewer.workspace();
  advance(viewer, 0.3);
  EXPECT_EQ(viewer.workspace(), still);
  viewer.handle(KeyPressed{"M"});
  advance(viewer, 0.3);
  EXPECT_NE(viewer.workspace().stance, still.stance) << "it goes on";
}

TEST_F(AnimationPlayerTest, AModelWithoutAnimationsStands) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.frame = {{"samples", {"1"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  viewer.handle(KeyPressed{"Space"});
  finish(viewer);
  EXPECT_TRUE(viewer.workspace().stance.empty());
}

TEST_F(AnimationPlayerTest, AMomentThatThereIsNotIsTold) {
  Workspace workspace = walking();
  workspace.stance = {{"animation", {"Run"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, ::testing::HasSubstr("Walk"));
}

TEST_F(AnimationPlayerTest, PicturesGoOverItsLength) {
  Workspace workspace = walking();
  workspace.stance = {{"animation", {"Walk"}}};
  const std::string folder = ::testing::TempDir();
  const auto made = makePicture(
      workspace, {.path = folder + "walk_%d.png", .size_px = kViewerSize, .frames = 2, .plays = true}, true, {}, {});
  ASSERT_TRUE(made) << made.error().message;
  const Image8 first = pictureFromLinear(readImage(folder + "walk_0.png")->image, 3);
  const Image8 second = pictureFromLinear(readImage(folder + "walk_1.png")->image, 3);
  EXPECT_GT(differing(first, second, kViewerSize.x / 2, kViewerSize.x), 10);
  EXPECT_EQ(differing(first, second, 0, kViewerSize.x / 12), 0) << "the camera stands still";
}

}  // namespace
}  // namespace mirrorball
