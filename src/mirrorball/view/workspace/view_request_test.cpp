#include "mirrorball/view/workspace/view_request.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Result<ViewRequest> request(const std::vector<std::string>& words) { return viewRequestOf(words); }

TEST(ViewRequest, HasTheWindowsOptionsAndThoseOfRender) {
  const auto asked = request({"teapot", "--frame-time", "40", "--fov=50", "--vsync=no", "--theme", "light"});
  ASSERT_TRUE(asked) << asked.error().message;
  EXPECT_EQ(asked->window.frame_ms, 40.0f);
  EXPECT_FALSE(asked->window.waits_for_screen);
  EXPECT_EQ(asked->window.theme, Theme::light);
  EXPECT_EQ(asked->workspace.model, "teapot");
  EXPECT_EQ(frameOf(asked->workspace, 0)->camera.fov_deg, 50.0f);
  EXPECT_THAT(request({"--pointer", "30,40"})->window.pointer, ElementsAre(30.0f, 40.0f));
  EXPECT_TRUE(request({"--vsync", "teapot"})->window.waits_for_screen) << "a flag takes no other word";
}

TEST(ViewRequest, RefusesWhatItCannotTake) {
  EXPECT_THAT(request({"--frame-time"}).error().message, HasSubstr("--frame-time"));
  EXPECT_THAT(request({"--frame-time=0"}).error().message, HasSubstr("frame-time"));
  EXPECT_THAT(request({"--theme=pink"}).error().message, HasSubstr("theme"));
  EXPECT_THAT(request({"nowhere.glb"}).error().message, HasSubstr("nowhere.glb"));
}

TEST(ViewRequest, HelpNamesAllOptionsOfTheWindow) {
  EXPECT_TRUE(request({"nowhere.glb", "--help"})->wants_help) << "whatever else there is";
  for (const Option<WindowOptions>& option : windowOptions())
    EXPECT_THAT(viewHelp(), HasSubstr("--" + std::string(option.text.name)));
}

}  // namespace
}  // namespace mirrorball
