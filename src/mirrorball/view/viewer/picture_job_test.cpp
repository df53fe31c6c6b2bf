// Pictures that a viewer writes.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::differing;
using testing::finish;
using ::testing::HasSubstr;
using testing::kViewerSize;

class PictureJobTest : public testing::ViewerTest {};

Workspace ball() {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.frame = {{"samples", {"2"}}};
  return workspace;
}

std::string written(const Workspace& workspace, const PictureRequest& request) {
  const auto made = makePicture(workspace, request, true, {}, {});
  return made ? *made : made.error().message;
}

/// Lets time go on until a picture file is there, or is not.
void finishSaving(Viewer& viewer) {
  for (int step = 0; step < 3000 && !viewer.status().saving.empty(); ++step) {
    ASSERT_TRUE(viewer.advance(0.01));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

TEST_F(PictureJobTest, IsThePictureThatIsSeen) {
  const std::string path = ::testing::TempDir() + "job.png";
  Workspace workspace = ball();
  for (const bool is_traced : {false, true}) {
    if (is_traced) workspace = withTruth(workspace);
    workspace.edited_side = is_traced ? 1 : 0;
    Viewer viewer(device(), workspace, kViewerSize);
    finish(viewer);
    const Image8 seen = *viewer.picture();
    viewer.savePicture({.path = path, .size_px = kViewerSize, .side = workspace.edited_side});
    EXPECT_EQ(viewer.status().saving, path);
    finishSaving(viewer);
    EXPECT_EQ(viewer.status().saved_last, "wrote " + path);
    const Image8 saved = pictureFromLinear(readImage(path)->image, 3);
    ASSERT_EQ(saved.width(), kViewerSize.x);
    EXPECT_EQ(differing(saved, seen, 0, kViewerSize.x), 0);
  }
}

/// In the low sun of a sky.
Workspace standing() {
  Workspace workspace = ball();
  workspace.model = "teapot";
  workspace.maps = {"sky:elevation=15"};
  workspace.frame["stand"] = {"yes"};
  return workspace;
}

TEST_F(PictureJobTest, OfAModelThatStandsIsThePictureThatIsSeen) {
  const std::string path = ::testing::TempDir() + "stands.png";
  Viewer viewer(device(), standing(), kViewerSize);
  finish(viewer);
  const Image8 seen = *viewer.picture();
  EXPECT_FALSE(viewer.stillWorkspace().frame.contains("camera"));
  ASSERT_TRUE(viewer.renderedWorkspace().frame.contains("camera")) << "which `render` reads";
  for (const Workspace& workspace : {viewer.stillWorkspace(), viewer.renderedWorkspace()}) {
    ASSERT_EQ(written(workspace, {.path = path, .size_px = kViewerSize}), path);
    EXPECT_EQ(differing(pictureFromLinear(readImage(path)->image, 3), seen, 0, kViewerSize.x), 0);
  }
}

TEST_F(PictureJobTest, ALightThatTurnsLeavesTheCameraWhereItIs) {
  Viewer viewer(device(), standing(), kViewerSize);
  finish(viewer);
  const auto camera = [&] { return frameOf(viewer.renderedWorkspace().frame)->camera; };
  const CameraOptions before = camera();
  for (const float azimuth_deg : {40.0f, 110.0f, 250.0f}) {
    viewer.history().change("Turn the light", withLightTurned(viewer.workspace(), {azimuth_deg, 0, 0}));
    finish(viewer);
    EXPECT_NEAR(*camera().distance, *before.distance, 1e-4f) << azimuth_deg;
    EXPECT_LT(glm::distance(*camera().target, *before.target), 1e-4f) << azimuth_deg;
  }
}

TEST_F(PictureJobTest, OfATurnAreNumbered) {
  const std::string path = ::testing::TempDir() + "turn.png";
  const std::string made = written(ball(), {.path = path, .size_px = {32, 32}, .frames = 3});
  EXPECT_THAT(made, HasSubstr("turn_002.png"));
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(std::filesystem::exists(::testing::TempDir() + "turn_00" + std::to_string(i) + ".png"));
}

TEST_F(PictureJobTest, OfAMapAloneIsWhatIsSeen) {
  const std::string path = ::testing::TempDir() + "map_alone.png";
  Workspace workspace = ball();
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  ASSERT_EQ(written(workspace, {.path = path, .size_px = kViewerSize}), path);
  const Image8 seen = *viewer.picture();
  const Image8 saved = pictureFromLinear(readImage(path)->image, 3);
  EXPECT_EQ(differing(saved, seen, 0, kViewerSize.x), 0);
}

TEST_F(PictureJobTest, SaysWhatItCannotWrite) {
  EXPECT_THAT(written(ball(), {.path = "a.xyz"}), HasSubstr("a.xyz"));
  EXPECT_THAT(written(ball(), {.path = "nowhere/a.png", .size_px = {8, 8}}), HasSubstr("nowhere"));
  Workspace clear = ball();
  clear.frame["background"] = {"transparent"};
  EXPECT_THAT(written(clear, {.path = "a.jpg"}), HasSubstr("transparency"));
  EXPECT_THAT(written(withTruth(ball()), {.path = "a.png", .frames = 3, .side = 1}), HasSubstr("one picture"));
}

TEST_F(PictureJobTest, CanBeStopped) {
  const std::string path = ::testing::TempDir() + "stopped.png";
  std::filesystem::remove(path);
  Workspace workspace = ball();
  workspace.frame["samples"] = {"1000"};
  Viewer viewer(device(), workspace, kViewerSize);
  viewer.savePicture({.path = path, .size_px = {640, 360}});
  for (int step = 0; step < 20; ++step) ASSERT_TRUE(viewer.advance(0.01));
  viewer.cancelSaving();
  EXPECT_TRUE(viewer.status().saving.empty());
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace mirrorball
