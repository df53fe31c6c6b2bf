#include "mirrorball/view/viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

using testing::finish;
using testing::ViewerTest;

constexpr glm::ivec2 kSize = testing::kViewerSize;

/// A small panorama in a file, brighter towards one side.
std::string mapNamed(const char* name, glm::vec3 color) {
  Image image(32, 16, 3);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.texel(x, y)[channel] = color[channel] * (0.25f + static_cast<float>(x) / 16.0f);
  const std::string path = ::testing::TempDir() + name;
  EXPECT_TRUE(writeImage(path, image));
  return path;
}

Workspace teapot() {
  Workspace workspace;
  workspace.model = "teapot";
  workspace.maps = {mapNamed("viewer_blue.hdr", {0.2f, 0.4f, 0.9f}), mapNamed("viewer_red.hdr", {0.9f, 0.3f, 0.1f})};
  workspace.frame = {{"samples", {"4"}}, {"quality", {"draft"}}};
  return workspace;
}

std::vector<std::uint8_t> bytesOf(const Image8& picture) {
  return {picture.samples().begin(), picture.samples().end()};
}

std::vector<std::uint8_t> pictureOf(const Viewer& viewer) {
  const auto picture = viewer.picture();
  EXPECT_TRUE(picture);
  return picture ? bytesOf(*picture) : std::vector<std::uint8_t>();
}

TEST_F(ViewerTest, ShowsWhatARendererDraws) {
  Viewer viewer(device(), teapot(), kSize);
  EXPECT_FALSE(viewer.hasPicture());
  finish(viewer);
  Renderer renderer = *Renderer::on(*gl::Context::adoptCurrent());
  ASSERT_TRUE(renderer.setEnvironment(loadEnvironment(teapot().maps[0])->environment));
  ASSERT_TRUE(renderer.setScene(*loadModel("teapot")));
  FrameSettings settings = *frameOf(teapot(), 0);
  settings.size = kSize;
  EXPECT_EQ(pictureOf(viewer), bytesOf(*renderer.render(settings)));
  EXPECT_EQ(viewer.status().sides[0].samples, 4);
  EXPECT_TRUE(viewer.status().problem.empty());
}

TEST_F(ViewerTest, AHandTurnsTheModelAndUndoTurnsItBack) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  viewer.handle(PointerPressed{PointerButton::left, {20, 20}});
  for (int step = 1; step <= 5; ++step) {
    viewer.handle(PointerMoved{{20.0f + 5.0f * float(step), 20}});
    ASSERT_TRUE(viewer.advance(0.01));
    EXPECT_EQ(viewer.status().sides[0].samples, 1) << "while it moves";
    EXPECT_FALSE(viewer.isDone());
  }
  viewer.handle(PointerReleased{PointerButton::left});
  finish(viewer);
  EXPECT_EQ(viewer.status().sides[0].samples, 4);
  EXPECT_NE(pictureOf(viewer), before);
  EXPECT_EQ(viewer.history().undoName(), "Turn");
  viewer.handle(KeyPressed{"Z", {.control = true}});
  EXPECT_TRUE(viewer.history().undoName().empty()) << "one step";
  finish(viewer);
  EXPECT_EQ(pictureOf(viewer), before);
}

TEST_F(ViewerTest, ChangesOfMaterialsAndMapsAreSeen) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  viewer.history().change("Material", *withOption(viewer.workspace(), OptionTable::material, "material", "gold"));
  finish(viewer);
  const auto gold = pictureOf(viewer);
  EXPECT_NE(gold, before);
  viewer.handle(KeyPressed{"]"});
  finish(viewer);
  EXPECT_NE(pictureOf(viewer), gold);
  viewer.history().undo();
  viewer.history().undo();
  finish(viewer);
  EXPECT_EQ(pictureOf(viewer), before);
}

TEST_F(ViewerTest, WhatCannotBeLoadedIsToldAndThePictureStays) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  Workspace next = viewer.workspace();
  next.model = "nowhere.glb";
  viewer.history().change("Open", next);
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, HasSubstr("nowhere.glb"));
  EXPECT_EQ(pictureOf(viewer), before);
  viewer.history().undo();
  finish(viewer);
  EXPECT_TRUE(viewer.status().problem.empty());
  EXPECT_EQ(pictureOf(viewer), before);
}

// What vertices know of a scene takes a while: the picture before stays, and turns with the hand.
TEST_F(ViewerTest, ATechniqueIsPreparedBesideIt) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  viewer.history().change("Occlusion", *withOption(viewer.workspace(), OptionTable::frame, "occlusion", "vertex"));
  ASSERT_TRUE(viewer.advance(0.01));
  EXPECT_FALSE(viewer.status().loading.empty());
  EXPECT_EQ(pictureOf(viewer), before);
  viewer.handle(Scrolled{3.0f, {10, 10}});
  ASSERT_TRUE(viewer.advance(0.01));
  finish(viewer);
  EXPECT_TRUE(viewer.status().loading.empty());
  viewer.history().undo();
  viewer.history().redo();
  EXPECT_EQ(frameOf(viewer.workspace(), 0)->occlusion, OcclusionKind::vertex);
  Renderer renderer = *Renderer::on(*gl::Context::adoptCurrent());
  ASSERT_TRUE(renderer.setEnvironment(loadEnvironment(teapot().maps[0])->environment));
  ASSERT_TRUE(renderer.setScene(*loadModel("teapot")));
  FrameSettings settings = *frameOf(viewer.workspace(), 0);
  settings.size = kSize;
  EXPECT_EQ(pictureOf(viewer), bytesOf(*renderer.render(settings)));
}

TEST_F(ViewerTest, FollowsTheSizeOfItsWindow) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(33, 70), glm::ivec2(0, 0), kSize}) {
    viewer.handle(Resized{size});
    finish(viewer);
    EXPECT_EQ(viewer.status().sides[0].size_px, glm::max(size, glm::ivec2(1)));
  }
}

TEST_F(ViewerTest, WhatIsMendedIsDrawnAgain) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  viewer.history().change("Camera", *withOption(viewer.workspace(), OptionTable::frame, "camera", "door"));
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, HasSubstr("door"));
  EXPECT_EQ(pictureOf(viewer), before);
  viewer.history().undo();
  EXPECT_FALSE(viewer.isDone());
  finish(viewer);
  EXPECT_TRUE(viewer.status().problem.empty());
  EXPECT_EQ(pictureOf(viewer), before);
}

TEST_F(ViewerTest, AFirstLoadThatFailsIsToldAndMended) {
  for (const bool is_model : {true, false}) {
    Workspace wrong = *withOption(teapot(), OptionTable::material, "material", "gold");
    if (is_model)
      wrong.model = "nowhere.glb";
    else
      wrong.maps[0] = "nowhere.hdr";
    Viewer viewer(device(), wrong, kSize);
    viewer.handle(Scrolled{1.0f, {5, 5}});
    EXPECT_EQ(viewer.workspace(), wrong) << "nothing is there to come nearer to";
    finish(viewer);
    EXPECT_THAT(viewer.status().problem, HasSubstr("nowhere."));
    EXPECT_FALSE(viewer.hasPicture());
    EXPECT_FALSE(viewer.picture());
    viewer.history().change("Open", teapot());
    finish(viewer);
    EXPECT_TRUE(viewer.hasPicture());
    EXPECT_TRUE(viewer.status().problem.empty());
  }
}

TEST_F(ViewerTest, AHandThatHoldsStillSeesTheWholePicture) {
  constexpr glm::ivec2 kWide{1400, 20};
  Viewer viewer(device(), teapot(), kWide, {.frame_s = 1e-9});
  finish(viewer);
  EXPECT_EQ(viewer.status().sides[0].size_px, kWide);
  viewer.handle(PointerPressed{PointerButton::left, {20, 10}});
  viewer.handle(PointerMoved{{25, 10}});
  ASSERT_TRUE(viewer.advance(10.0)) << "the host has slept";
  EXPECT_EQ(viewer.status().sides[0].samples, 1);
  finish(viewer);
  EXPECT_EQ(viewer.status().sides[0].samples, 4);
  EXPECT_EQ(viewer.status().sides[0].size_px, kWide);
}

TEST_F(ViewerTest, AKeyFliesNoFartherThanTimeWentOn) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  viewer.handle(KeyPressed{"W"});
  ASSERT_TRUE(viewer.advance(100.0));
  const CameraOptions flown = frameOf(viewer.workspace(), 0)->camera;
  ASSERT_TRUE(flown.target);
  EXPECT_LT(glm::length(*flown.target), 1.0f);
  viewer.handle(KeyReleased{"W"});
  viewer.handle(KeyPressed{"W"});
  ASSERT_TRUE(viewer.advance(0.05));
  viewer.handle(FocusLost{});
  finish(viewer);
  EXPECT_TRUE(viewer.history().undo());
  EXPECT_EQ(frameOf(viewer.workspace(), 0)->camera, flown) << "the key was let go between";
}

TEST_F(ViewerTest, ShowsItsPictureInAPartOfAnyFramebuffer) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const Image8 picture = *viewer.picture();
  for (const gl::Format format : {gl::Format::rgba8, gl::Format::srgb8_alpha8}) {
    auto window = gl::Framebuffer::make(format, kSize.x + 7, kSize.y + 5);
    ASSERT_TRUE(window);
    ASSERT_TRUE(viewer.show(window->name(), {7, 5}, kSize));
    const Image8 shown = window->readBytes();
    for (int y = 0; y < kSize.y; ++y)
      ASSERT_TRUE(std::equal(picture.texel(0, y), picture.texel(0, y) + 4 * kSize.x, shown.texel(7, y))) << "row " << y;
    ASSERT_TRUE(viewer.show(window->name(), {0, 0}, kSize / 2));
  }
}

TEST_F(ViewerTest, AFileThatWasWrittenAgainIsShown) {
  Viewer viewer(device(), teapot(), kSize);
  finish(viewer);
  const auto before = pictureOf(viewer);
  const std::string path = teapot().maps[0];
  const auto time = std::filesystem::last_write_time(path);
  mapNamed("viewer_blue.hdr", {0.1f, 0.9f, 0.1f});
  std::filesystem::last_write_time(path, time + std::chrono::seconds(2));
  for (int second = 0; second < 3; ++second) ASSERT_TRUE(viewer.advance(1.1));
  finish(viewer);
  EXPECT_NE(pictureOf(viewer), before);
  std::ofstream(path, std::ios::binary) << "no picture";
  std::filesystem::last_write_time(path, time + std::chrono::seconds(4));
  const auto green = pictureOf(viewer);
  for (int second = 0; second < 3; ++second) ASSERT_TRUE(viewer.advance(1.1));
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, HasSubstr("viewer_blue.hdr"));
  EXPECT_EQ(pictureOf(viewer), green);
}

TEST_F(ViewerTest, PanoramasAreSeenInSmall) {
  Workspace workspace = teapot();
  workspace.maps = {"white"};
  Viewer viewer(device(), workspace, kSize);
  finish(viewer);
  EXPECT_TRUE(viewer.thumbnails().empty()) << "there is nothing to choose";
  viewer.history().change("Open", withMap(withMap(workspace, "uv"), "nowhere.hdr"));
  viewer.history().change("Choose", withMapShown(viewer.workspace(), 1));
  finish(viewer);
  const auto thumbnails = viewer.thumbnails();
  ASSERT_EQ(thumbnails.size(), 3u);
  EXPECT_EQ(thumbnails[1].name, "uv");
  EXPECT_TRUE(thumbnails[1].is_shown && !thumbnails[0].is_shown);
  EXPECT_TRUE(thumbnails[0].texture != 0 && thumbnails[1].texture != 0);
  EXPECT_NE(thumbnails[0].texture, thumbnails[1].texture);
  EXPECT_EQ(thumbnails[1].size_px, glm::ivec2(96, 48));
  EXPECT_EQ(thumbnails[2].texture, 0u) << "it cannot be loaded";
}

TEST_F(ViewerTest, AMapInSmallIsMadeAgainOnceItsFileIsThere) {
  const std::string later = ::testing::TempDir() + "comes_later.hdr";
  std::filesystem::remove(later);
  Workspace workspace = teapot();
  workspace.maps = {"white", later};
  Viewer viewer(device(), workspace, kSize);
  finish(viewer);
  ASSERT_EQ(viewer.thumbnails().at(1).texture, 0u);
  ASSERT_TRUE(writeImage(later, Image(8, 4, 3, 1.0f)));
  for (int second = 0; second < 4; ++second) ASSERT_TRUE(viewer.advance(1.0));
  finish(viewer);
  EXPECT_NE(viewer.thumbnails().at(1).texture, 0u);
}

TEST_F(ViewerTest, EndsWhileItLoads) {
  for (int steps = 0; steps < 4; ++steps) {
    Workspace big = teapot();
    big.maps = {"sunset"};
    Viewer viewer(device(), big, kSize);
    for (int step = 0; step < steps; ++step) ASSERT_TRUE(viewer.advance(0.01));
    EXPECT_FALSE(viewer.isDone());
    EXPECT_EQ(viewer.isWaiting(), steps > 0);
  }
}

}  // namespace
}  // namespace mirrorball
