// The library of any build: a sphere in the studio is drawn, whatever is left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

using ::testing::Contains;

TEST(Parts, ASphereInTheStudioIsDrawn) {
  auto renderer = Renderer::headless();
  if (!renderer) GTEST_SKIP() << renderer.error().message;
  auto sphere = loadModel("sphere");
  ASSERT_TRUE(sphere) << sphere.error().message;
  auto studio = builtinEnvironment("studio");
  ASSERT_TRUE(studio) << studio.error().message;
  ASSERT_TRUE(renderer->setScene(std::move(*sphere)));
  ASSERT_TRUE(renderer->setEnvironment(std::move(*studio)));
  const auto picture = renderer->render({.size = {64, 36}, .samples = 1});
  ASSERT_TRUE(picture) << picture.error().message;
  const auto [darkest, brightest] = std::ranges::minmax(picture->samples());
  EXPECT_GT(brightest, darkest + 50) << "the lamps of the studio show in it";
}

TEST(Parts, TheSunsetIsThereOrNamed) {
  const auto sunset = builtinEnvironment("sunset");
  EXPECT_EQ(sunset.has_value(), hasSunset());
  const auto names = builtinEnvironmentNames();
  EXPECT_EQ(std::ranges::find(names, "sunset") != names.end(), hasSunset());
  if (!sunset) {
    EXPECT_EQ(sunset.error().message,
              "this build has no sunset, which is an OpenEXR file; one with MIRRORBALL_EXR=ON does");
  }
  EXPECT_THAT(names, Contains("studio"));
}

}  // namespace
}  // namespace mirrorball
