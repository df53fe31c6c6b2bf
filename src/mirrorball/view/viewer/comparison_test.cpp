// Two halves beside each other.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/display.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/metric/image_error.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/stage/technique_choice.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::differing;
using testing::finish;
using testing::kViewerSize;

class ViewerComparisonTest : public testing::ViewerTest {};

/// A grey ball and, in a comparison, a golden half.
Workspace comparison(CompareBy by) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.maps = {"white", "studio"};
  workspace.frame = {{"samples", {"2"}}, {"quality", {"draft"}}};
  workspace.compare_by = by;
  workspace.sides[1].frame = {{"exposure", {"-2"}}};
  return workspace;
}

/// One half alone.
Image8 halfOf(const Device& device, Workspace workspace, std::size_t side) {
  workspace.frame = givenFrame(workspace, side);
  workspace.maps = {mapOf(workspace, side)};
  workspace.shown_map = 0;
  workspace.compare_by = CompareBy::none;
  Viewer viewer(device, workspace, kViewerSize);
  finish(viewer);
  return *viewer.picture();
}

TEST_F(ViewerComparisonTest, ALineDividesBothHalves) {
  for (const bool has_other_map : {false, true}) {
    Workspace workspace = comparison(CompareBy::slider);
    if (has_other_map) workspace.sides[1].map = 1;
    const Image8 first = halfOf(device(), workspace, 0), second = halfOf(device(), workspace, 1);
    Viewer viewer(device(), workspace, kViewerSize);
    finish(viewer);
    ASSERT_EQ(viewer.status().sides.size(), 2u);
    const int middle = kViewerSize.x / 2;
    EXPECT_EQ(differing(*viewer.picture(), first, 0, middle - 1), 0);
    EXPECT_EQ(differing(*viewer.picture(), second, middle + 1, kViewerSize.x), 0);
    // A hand moves the line.
    viewer.handle(PointerPressed{PointerButton::left, {middle + 2, 30}});
    viewer.handle(PointerMoved{{10, 30}});
    viewer.handle(PointerReleased{PointerButton::left});
    finish(viewer);
    EXPECT_EQ(differing(*viewer.picture(), first, 0, 9), 0);
    EXPECT_EQ(differing(*viewer.picture(), second, 11, kViewerSize.x), 0);
    EXPECT_EQ(viewer.history().undoName(), "Move the line");
  }
}

TEST_F(ViewerComparisonTest, AHalfThatGetsAPanoramaOfItsOwnShowsIt) {
  Viewer viewer(device(), comparison(CompareBy::flip), kViewerSize);
  finish(viewer);
  viewer.history().change("Edit", withEditedSide(viewer.workspace(), 1));
  finish(viewer);
  const Image8 before = *viewer.picture();
  viewer.history().change("Choose", withMapShown(viewer.workspace(), 1));
  finish(viewer);
  EXPECT_GT(differing(*viewer.picture(), before, 0, kViewerSize.x), 100);
}

TEST_F(ViewerComparisonTest, AKeyFlipsBetweenBothHalves) {
  Workspace workspace = comparison(CompareBy::flip);
  const Image8 first = halfOf(device(), workspace, 0), second = halfOf(device(), workspace, 1);
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_EQ(differing(*viewer.picture(), first, 0, kViewerSize.x), 0);
  viewer.handle(KeyPressed{"Tab"});
  EXPECT_EQ(differing(*viewer.picture(), second, 0, kViewerSize.x), 0) << "at once, without another draw";
}

std::string psnrOf(const Viewer& viewer) {
  for (const ErrorText& error : viewer.status().errors)
    if (error.label == "PSNR") return error.value;
  return {};
}

TEST_F(ViewerComparisonTest, TellsByWhatTheyDiffer) {
  Workspace workspace = comparison(CompareBy::difference);
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_THAT(psnrOf(viewer), ::testing::EndsWith(" dB"));
  const Image8 difference = *viewer.picture();
  viewer.handle(KeyPressed{"D", {.control = true, .shift = true}});
  finish(viewer);
  EXPECT_GT(differing(*viewer.picture(), difference, 0, kViewerSize.x), 1000) << "FLIP's map";
  // Equal halves do not differ.
  viewer.history().change("Exposure", withoutOptions(viewer.workspace()));
  finish(viewer);
  EXPECT_EQ(psnrOf(viewer), "infinite");
}

TEST_F(ViewerComparisonTest, TheTruthIsThePathTracersPicture) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.frame = {{"samples", {"16"}}, {"quality", {"draft"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  const Image8 drawn = *viewer.picture();
  viewer.handle(KeyPressed{"T"});
  finish(viewer);
  EXPECT_EQ(differing(*viewer.picture(), drawn, 0, kViewerSize.x), 0);
  ASSERT_TRUE(viewer.status().sides[1].is_traced);
  EXPECT_EQ(viewer.status().sides[1].samples, 16);
  viewer.handle(KeyPressed{"T"});

  FrameSettings frame = *frameOf(workspace, 0);
  frame.size = kViewerSize;
  Scene scene = *loadModel("sphere");
  const Camera camera = *framedCamera(scene, boundingSphere(scene), frame.camera, frame.size);
  const auto tracer = PathTracer::make(scene, loadEnvironment("studio")->environment);
  ASSERT_TRUE(tracer);
  const auto traced = tracer->render(camera, tracedFrame(frame, {.samples = 16}));
  ASSERT_TRUE(traced);
  EXPECT_EQ(differing(*viewer.picture(), displayedPicture(frame.display, traced->radiance), 0, kViewerSize.x), 0);

  // While something moves, what is seen moves.
  viewer.handle(Scrolled{3.0f, {40, 30}});
  ASSERT_TRUE(viewer.advance(0.01));
  EXPECT_FALSE(viewer.status().sides[1].is_traced);
  finish(viewer);
  EXPECT_TRUE(viewer.status().sides[1].is_traced);
  viewer.handle(KeyPressed{"T"});
  EXPECT_FALSE(viewer.status().sides[0].is_traced);
}

TEST_F(ViewerComparisonTest, NothingGoesOnOnceTheTruthIsThere) {
  Workspace workspace = withTruth({.model = "knot"});
  workspace.compare_by = CompareBy::slider;
  workspace.frame = {{"samples", {"1"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_EQ(viewer.status().loading, "") << "the renderer's part of that half is not waited for";
}

TEST_F(ViewerComparisonTest, EndsWhileItTraces) {
  Workspace workspace = comparison(CompareBy::flip);
  workspace.sides[1].is_traced = true;
  workspace.frame["samples"] = {"1000"};
  Viewer viewer(device(), workspace, kViewerSize);
  for (int step = 0; step < 1000 && !viewer.hasPicture(); ++step) {
    ASSERT_TRUE(viewer.advance(0.2));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(viewer.hasPicture());
  EXPECT_FALSE(viewer.isDone());
}

TEST_F(ViewerComparisonTest, AQualityFillsInWhatRenderDoes) {
  Workspace workspace;
  workspace.model = "showcase";
  workspace.frame = {{"samples", {"1"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_THAT(viewer.status().sides[0].chosen, ::testing::HasSubstr("occlusion"));
  Scene scene = *loadModel("showcase");
  FrameSettings frame = *frameOf(workspace, 0);
  ASSERT_TRUE(chooseTechniques(scene, {.quality = Quality::good, .given = {"samples"}}, frame));
  frame.size = kViewerSize;
  Renderer renderer = *Renderer::on(*gl::Context::adoptCurrent());
  ASSERT_TRUE(renderer.setEnvironment(loadEnvironment("studio")->environment));
  ASSERT_TRUE(renderer.setScene(std::move(scene)));
  EXPECT_EQ(differing(*viewer.picture(), *renderer.render(frame), 0, kViewerSize.x), 0);
}

TEST_F(ViewerComparisonTest, AClickSelectsAMaterial) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.frame = {{"quality", {"draft"}}, {"samples", {"1"}}};
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  const auto click = [&](glm::vec2 place_px) {
    viewer.handle(PointerPressed{PointerButton::left, place_px});
    viewer.handle(PointerMoved{place_px + 1.0f});
    viewer.handle(PointerReleased{PointerButton::left});
    finish(viewer);
  };
  click(glm::vec2(kViewerSize) / 2.0f);
  EXPECT_EQ(viewer.workspace().selected_material, 0u);
  EXPECT_TRUE(viewer.selectedMaterial());
  EXPECT_EQ(viewer.history().undoName(), "Select a material") << "and nothing was turned";
  click({1, 1});
  EXPECT_FALSE(viewer.workspace().selected_material);
}

}  // namespace
}  // namespace mirrorball
