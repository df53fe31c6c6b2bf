#include "mirrorball/bake/bake.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

Environment light() { return Environment(testing::smoothRadiance, 64); }

TEST(Bake, MakesWhatTheSettingsAskFor) {
  const BakedMaps all = *bake(light(), {.size = 16, .irradiance_size = 4, .skybox_size = 8});
  EXPECT_EQ(all.specular.levels(), 3) << "16, 8 and 4 texels a face";
  EXPECT_EQ(all.levels.back().perceptual_roughness, 1.0f);
  EXPECT_EQ(all.irradiance.size(), 4);
  EXPECT_EQ(all.skybox.size(), 8);
  EXPECT_EQ(all.radiance.size(), 9u);
  const BakedMaps chain = *bake(light(), {.size = 16, .levels = 5, .irradiance_size = 0, .harmonics_degree = 0});
  EXPECT_EQ(chain.specular.levels(), 5);
  EXPECT_EQ(chain.irradiance.faces(), 0);
  EXPECT_TRUE(chain.radiance.empty());
  EXPECT_THAT(chain.specular.at(1, 3).samples(), ::testing::Not(ElementsAre()));
}

// Band 0 of the harmonics is the mean light, and so is every map of even light.
TEST(Bake, EvenLightStaysEven) {
  const BakedMaps maps =
      *bake(Environment([](glm::vec3) { return glm::vec3(2.0f); }, 16), {.size = 8, .irradiance_size = 4});
  for (const float sample : maps.specular.at(1, 0).samples()) EXPECT_NEAR(sample, 2.0f, 1e-5f);
  for (const float sample : maps.irradiance.face(2).samples()) EXPECT_NEAR(sample, 2.0f, 1e-5f);
  EXPECT_NEAR(maps.radiance[0].x, 2.0f * std::sqrt(4.0f * 3.14159265f), 1e-4f);
}

TEST(Bake, TellsItsStagesAndStopsWhenItIsTold) {
  std::vector<std::string> stages;
  std::vector<std::string> ended;
  Observer observer;
  observer.timing = [&](std::string_view stage) -> std::function<void()> {
    return [&ended, name = std::string(stage)] { ended.push_back(name); };
  };
  observer.progress = [&](std::string_view stage) -> ProgressFunction {
    stages.emplace_back(stage);
    return [](std::size_t, std::size_t) { return true; };
  };
  ASSERT_TRUE(bake(light(), {.size = 16}, observer));
  EXPECT_THAT(stages, ElementsAre("analyse light", "prefilter", "irradiance"));
  EXPECT_THAT(ended, Contains("specular: prefilter"));
  observer.progress = [](std::string_view) -> ProgressFunction {
    return [](std::size_t, std::size_t) { return false; };
  };
  const auto stopped = bake(light(), {.size = 16}, observer);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace mirrorball
