#include "mirrorball/render/light/environment_light.h"

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"

namespace mirrorball {
namespace {

class EnvironmentLightTest : public gl::GlTest {};

MIRRORBALL_WITH_BOTH_APIS(EnvironmentLightTest);

// OpenGL ES interpolates 32-bit floats only by an extension:
// without it a sun keeps its light in halves of a larger unit.
TEST_P(EnvironmentLightTest, KeepsASunInHalvesOfALargerUnit) {
  const Environment sunny([](glm::vec3 d) { return glm::vec3(d.x > 0.9f ? 1e6f : 0.5f, 2.0f, 3.0f); }, 32);
  const auto prepared = prepareEnvironment(sunny);
  ASSERT_TRUE(prepared);
  ASSERT_TRUE(prepared->needs_floats);
  for (const bool filters_floats : {false, true}) {
    auto light = EnvironmentLight::make(*prepared, filters_floats);
    ASSERT_TRUE(light) << light.error().message;
    EXPECT_EQ(light->cube().format(), filters_floats ? gl::Format::rgba32f : gl::Format::rgba16f);
    EXPECT_EQ(light->unit(), filters_floats ? 1.0f : 16.0f);
    const Image face = light->cube().read(0, 0);
    const int middle = face.width() / 2;
    EXPECT_NEAR(light->unit() * face.texel(middle, middle)[0], 1e6f, 500.0f) << "a half's 11 bits";
    EXPECT_NEAR(light->unit() * face.texel(middle, middle)[1], 2.0f, 1e-3f);
  }
}

TEST_P(EnvironmentLightTest, HalvesHoldOrdinaryLightAsItIs) {
  const auto prepared = prepareEnvironment(Environment([](glm::vec3) { return glm::vec3(7.0f); }, 16));
  ASSERT_TRUE(prepared);
  const auto light = EnvironmentLight::make(*prepared, false);
  ASSERT_TRUE(light);
  EXPECT_EQ(light->unit(), 1.0f);
  EXPECT_EQ(light->cube().format(), gl::Format::rgba16f);
}

}  // namespace
}  // namespace mirrorball
