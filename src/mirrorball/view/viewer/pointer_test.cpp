// What a viewer tells of the place under the pointer, and the map without a model.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::finish;
using ::testing::IsEmpty;
using testing::kViewerSize;
using ::testing::Not;
using ::testing::SizeIs;

class ViewerPointerTest : public testing::ViewerTest {};

Workspace matteBall() {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.frame = {{"quality", {"draft"}}, {"samples", {"1"}}};
  return workspace;
}

std::string valueOf(const UnderPointer& under, const std::string& name) {
  const auto found =
      std::find_if(under.rows.begin(), under.rows.end(), [&](const InspectionRow& row) { return row.name == name; });
  return found == under.rows.end() ? "" : found->value;
}

TEST_F(ViewerPointerTest, InspectsWhatIsUnderThePointer) {
  Viewer viewer(device(), matteBall(), kViewerSize);
  finish(viewer);
  viewer.handle(PointerMoved{glm::vec2(kViewerSize) / 2.0f});
  ASSERT_TRUE(viewer.advance(0.01));
  EXPECT_THAT(viewer.underPointer().rows, IsEmpty()) << "nobody asked";
  viewer.handle(KeyPressed{"I"});
  finish(viewer);
  ASSERT_TRUE(viewer.advance(0.01));
  const UnderPointer there = viewer.underPointer();
  EXPECT_THAT(there.rows, Not(IsEmpty()));
  EXPECT_THAT(there.plots, SizeIs(1));
  EXPECT_THAT(there.lines, Not(IsEmpty())) << "the ray that is reflected";
  ASSERT_THAT(there.maps, SizeIs(3));
  for (const MarkedPicture& map : there.maps) {
    EXPECT_NE(map.texture, 0u) << map.title;
    ASSERT_THAT(map.dots, SizeIs(1)) << map.title;
    const glm::vec2 dot = map.dots[0].places[0];
    EXPECT_TRUE(dot.x >= 0.0f && dot.x <= float(map.size_px.x) && dot.y >= 0.0f && dot.y <= float(map.size_px.y));
  }
  viewer.handle(PointerMoved{{1, 1}});
  ASSERT_TRUE(viewer.advance(0.01));
  EXPECT_THAT(viewer.underPointer().lines, IsEmpty()) << "the background";
  EXPECT_THAT(viewer.underPointer().maps, SizeIs(3));
  viewer.handle(PointerMoved{{-50, 1}});
  ASSERT_TRUE(viewer.advance(0.01));
  EXPECT_THAT(viewer.underPointer().rows, IsEmpty()) << "beside the picture";
}

TEST_F(ViewerPointerTest, ShowsTheMapAlone) {
  Workspace workspace = matteBall();
  workspace.maps = {"uv"};
  Viewer viewer(device(), workspace, {320, 180});
  finish(viewer);
  const Image8 model = *viewer.picture();
  viewer.handle(KeyPressed{"M"});
  finish(viewer);
  ASSERT_TRUE(viewer.advance(0.01));
  const Image8 map = *viewer.picture();
  ASSERT_EQ(map.width(), 320);
  EXPECT_FALSE(std::equal(map.samples().begin(), map.samples().end(), model.samples().begin()));
  EXPECT_THAT(viewer.underPointer().texts, Not(IsEmpty())) << "names of the projections";

  // From inside, a hand looks around, and what was under it stays there.
  viewer.history().change("Inside", *withOption(viewer.workspace(), OptionTable::map_view, "picture", "inside"));
  finish(viewer);
  viewer.handle(PointerMoved{{100, 90}});
  const std::string before = valueOf(viewer.underPointer(), "longitude");
  viewer.handle(PointerPressed{PointerButton::left, {100, 90}});
  viewer.handle(PointerMoved{{160, 90}});
  viewer.handle(PointerReleased{PointerButton::left});
  finish(viewer);
  ASSERT_FALSE(before.empty());
  EXPECT_NEAR(std::stof(valueOf(viewer.underPointer(), "longitude")), std::stof(before), 0.02f);
  EXPECT_NE(mapViewOf(viewer.workspace())->yaw_deg, 0.0f);
  EXPECT_EQ(viewer.history().undoName(), "Look around in the map");
  viewer.handle(KeyPressed{"="});
  EXPECT_GT(mapViewOf(viewer.workspace())->display.exposure(), 1.0f);
  viewer.handle(KeyPressed{"M"});
  finish(viewer);
  const Image8 again = *viewer.picture();
  EXPECT_TRUE(std::equal(again.samples().begin(), again.samples().end(), model.samples().begin()));
}

TEST_F(ViewerPointerTest, AMapThatCannotBeLoadedIsTold) {
  Workspace workspace = matteBall();
  workspace.maps = {"nowhere.hdr"};
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, kViewerSize);
  finish(viewer);
  EXPECT_THAT(viewer.status().problem, ::testing::HasSubstr("nowhere.hdr"));
  EXPECT_FALSE(viewer.hasPicture());
}

TEST_F(ViewerPointerTest, EndsWhileItDrawsAMap) {
  Workspace workspace = matteBall();
  workspace.shows_map = true;
  Viewer viewer(device(), workspace, {640, 360});
  for (int step = 0; step < 5; ++step) ASSERT_TRUE(viewer.advance(0.01));
}

}  // namespace
}  // namespace mirrorball
