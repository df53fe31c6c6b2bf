#include "mirrorball/view/workspace/asked_map.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/view/panel/panel.h"
#include "mirrorball/view/workspace/arguments.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Workspace withBall() {
  Workspace workspace;
  workspace.maps = {"studio", "ball.jpg"};
  workspace.shown_map = 1;
  return withPhotograph(workspace, true);
}

TEST(AskedMap, SaysWhetherItIsAPhotograph) {
  const Workspace workspace = withBall();
  EXPECT_EQ(askedMap(workspace, 0), (AskedMap{"ball.jpg", GivenTexts()}));
  Workspace compared = workspace;
  compared.compare_by = CompareBy::slider;
  compared.sides[1].map = 0;
  EXPECT_EQ(askedMap(compared, 1), AskedMap{"studio"});
  EXPECT_EQ(withPhotograph(withEditedSide(compared, 1), true).photos, compared.photos) << "what is built in is none";
  Workspace plain = withPhotograph(workspace, false);
  EXPECT_EQ(askedMap(plain, 0), AskedMap{"ball.jpg"});
  EXPECT_EQ(withOnlyMap(workspace, "ball.jpg").photos, workspace.photos);
  EXPECT_TRUE(withOnlyMap(workspace, "studio").photos.empty());
}

TEST(AskedMap, TheCircleIsATextOfHundredthsOfPixels) {
  const Workspace workspace = withBallCircle(withBall(), {{10.126, 20.0}, 5.5});
  EXPECT_THAT(workspace.photos.at("ball.jpg").at("circle"), ElementsAre("10.13,20,5.5"));
  EXPECT_THAT(ballPhotoOf(workspace.photos.at("ball.jpg"))->circle, ElementsAre(10.13f, 20.0f, 5.5f));
  EXPECT_EQ(withBallCircle(Workspace(), {{1, 1}, 1}), Workspace());
  EXPECT_TRUE(withoutOptions(workspace).photos.at("ball.jpg").empty()) << "it stays a photograph";
}

TEST(AskedMap, RefusesWhatAPhotographRefuses) {
  const Workspace workspace = *withOption(withBall(), OptionTable::photo, "distance", "12");
  const auto both = withOption(workspace, OptionTable::photo, "fov", "40");
  ASSERT_FALSE(both);
  EXPECT_THAT(both.error().message, HasSubstr("distance and fov say the same"));
  EXPECT_FALSE(withOption(workspace, OptionTable::photo, "circle", "1,2"));
  EXPECT_FALSE(withOption(workspace, OptionTable::photo, "no-such", "1"));
  EXPECT_THAT(withOption({}, OptionTable::photo, "fov", "40").error().message, HasSubstr("no photograph"));
}

TEST(AskedMap, APhotographHasRows) {
  Workspace workspace = withBall();
  for (const bool shows_map : {false, true}) {
    workspace.shows_map = shows_map;
    const auto groups = *panelsOf(workspace);
    const auto found = std::find_if(groups.begin(), groups.end(), [](const PanelGroup& group) {
      return group.title == "Photograph of a mirror ball";
    });
    ASSERT_NE(found, groups.end());
    std::vector<std::string_view> names;
    for (const PanelRow& row : found->rows) names.push_back(row.name);
    EXPECT_THAT(names, ElementsAre("circle", "distance", "fov", "response", "layer"));
    const Workspace changed = *withValue(workspace, found->rows[1], std::vector<float>{4.0f});
    EXPECT_EQ(ballPhotoOf(*askedMap(changed, 0).photo)->distance, 4.0f);
    EXPECT_EQ(withoutGroup(changed, found->title), workspace);
  }
}

TEST(AskedMap, IsAPhotographIfItHasTheShapeOfNoMap) {
  const std::string path = ::testing::TempDir() + "asked_photograph.hdr";
  ASSERT_TRUE(writeImage(path, Image(90, 70, 3, 0.5f)));
  EXPECT_TRUE(withFile({}, path)->photos.contains(path));
  const std::string map = ::testing::TempDir() + "asked_panorama.hdr";
  ASSERT_TRUE(writeImage(map, Image(64, 32, 3, 0.5f)));
  EXPECT_TRUE(withFile({}, map)->photos.empty());
  const Workspace workspace = *workspaceOf(std::vector<std::string>{"sphere", path});
  EXPECT_THAT(workspace.maps, ElementsAre(path)) << "nobody has asked for another";
  EXPECT_EQ(askedMap(workspace, 0), (AskedMap{path, GivenTexts()}));
}

TEST(AskedMap, APhotographIsTwoCommands) {
  Workspace workspace = withBallCircle(withBall(), {{100, 90}, 50});
  workspace.maps[1] = "my ball.jpg";
  workspace.photos = {{"my ball.jpg", workspace.photos.at("ball.jpg")}};
  workspace.model = "sphere";
  EXPECT_EQ(
      *renderCommandLine(workspace, 0),
      "mirrorball photo 'my ball.jpg' --circle=100,90,50 -o 'my ball_unwrapped.exr' && mirrorball render sphere -e "
      "'my ball_unwrapped.exr'");
}

}  // namespace
}  // namespace mirrorball
