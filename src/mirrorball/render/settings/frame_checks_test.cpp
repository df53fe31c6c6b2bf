#include "mirrorball/render/settings/frame_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

struct Asked {
  FrameSettings settings = {};
  std::set<std::string_view> given = {};

  /// What is said against them; empty: nothing.
  std::string error() const {
    const auto checked = checkSettings(settings, given);
    return checked ? "" : checked.error().message;
  }
};

/// Settings as these options say.
Asked asked(const std::vector<std::pair<std::string_view, std::string_view>>& options) {
  Asked made;
  for (const auto& [name, value] : options) {
    testing::set(made.settings, name, value);
    made.given.insert(name);
  }
  return made;
}

TEST(FrameChecks, ContradictionsAreTold) {
  EXPECT_EQ(asked({}).error(), "");
  EXPECT_THAT(asked({{"stand", "yes"}, {"proxy", "sphere:0,0,0,2"}}).error(), StartsWith("{option:stand} is on a"));
  EXPECT_EQ(asked({{"stand", "yes"}, {"ground-roughness", "0.2"}}).error(), "") << "it stands on a ground";
  EXPECT_THAT(asked({{"ground-roughness", "0.2"}}).error(), HasSubstr("add {option:proxy} ground"));
  EXPECT_THAT(asked({{"captured-at", "0,1,0"}}).error(), HasSubstr("add {option:proxy}"));
  EXPECT_THAT(asked({{"self-reflection", "yes"}, {"occlusion", "none"}}).error(), HasSubstr("{option:occlusion} none"));
  EXPECT_THAT(asked({{"texgen", "light"}}).error(), HasSubstr("add {option:light}"));
  EXPECT_EQ(asked({{"texgen", "light"}, {"light", "0,3,0,9,9,9"}}).error(), "");
  EXPECT_THAT(asked({{"camera", "front"}, {"fov", "30"}}).error(), StartsWith("{option:fov}: the camera 'front'"));
}

TEST(FrameChecks, WhatTheProxyDoesNotHoldIsDoubtful) {
  const Scene ball = *loadModel("sphere");
  EXPECT_THAT(*checkFrame(asked({}).settings, ball), IsEmpty());
  EXPECT_THAT(*checkFrame(asked({{"proxy", "sphere:0,0,0,9"}}).settings, ball), IsEmpty());
  EXPECT_THAT(*checkFrame(asked({{"proxy", "sphere:0,0,0,2"}}).settings, ball),
              ElementsAre(HasSubstr("the camera is outside of the proxy")));
  EXPECT_THAT(*checkFrame(asked({{"proxy", "sphere:9,0,0,1"}}).settings, ball),
              ElementsAre(HasSubstr("the camera is outside"), HasSubstr("does not hold all of the model")));
  const auto below = checkFrame(asked({{"proxy", "ground"}, {"camera", "0,-60"}}).settings, ball);
  ASSERT_FALSE(below);
  EXPECT_THAT(below.error().message, HasSubstr("the camera is below the ground; raise it by {option:camera}"));
}

TEST(FrameChecks, TheShowcaseStandsAsFarAsNothingElseIsAskedFor) {
  std::string environment = "studio";
  FrameSettings settings;
  setShowcase({}, environment, settings);
  EXPECT_EQ(environment, hasSunset() ? "sunset" : "studio");
  EXPECT_EQ(settings.proxy.kind, hasSunset() ? ProxyKind::ground : ProxyKind::none);
  EXPECT_EQ(settings.proxy.ground_roughness < 1.0f, hasSunset());
  EXPECT_EQ(settings.camera.elevation_deg, 9.0f);
  FrameSettings asked;
  setShowcase({"proxy", "camera"}, environment, asked);
  EXPECT_EQ(asked.proxy, ProxyOptions());
  EXPECT_EQ(asked.camera, CameraOptions());
}

}  // namespace
}  // namespace mirrorball
