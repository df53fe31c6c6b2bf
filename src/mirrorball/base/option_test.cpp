#include "mirrorball/base/option.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

enum class Lens { wide, tele };
struct Camera {
  float fov_deg = 45;
  glm::vec3 target{1, 2, 3};
  std::vector<float> orbit{30, 15};
  Lens lens = Lens::tele;
  int samples = 4;
  bool on = false;
  std::vector<std::string> lights;
  std::optional<int> step;
};

const Option<Camera> kFov{{.name = "fov", .unit = "degrees", .minimum = 1, .maximum = 170}, &Camera::fov_deg};
const Option<Camera> kTarget{{.name = "target"}, &Camera::target};
const Option<Camera> kOrbit{{.name = "orbit", .min_count = 2, .max_count = 3}, &Camera::orbit};
const Option<Camera> kLens{{.name = "lens", .choices = "wide|tele"}, choiceField<&Camera::lens>};
const Option<Camera> kSamples{{.name = "samples", .minimum = 1, .maximum = 64}, &Camera::samples};
const Option<Camera> kOn{{.name = "on"}, &Camera::on};
const Option<Camera> kStep{{.name = "step", .minimum = 0}, &Camera::step};
const Option<Camera> kLight{{.name = "light"}, &Camera::lights};

TEST(Option, DefaultIsTheFieldsInitialiser) {
  EXPECT_EQ(written(kFov, Camera{}), "45");
  EXPECT_EQ(written(kTarget, Camera{}), "1,2,3");
  EXPECT_EQ(written(kOrbit, Camera{}), "30,15");
  EXPECT_EQ(written(kLens, Camera{}), "tele");
  EXPECT_EQ(written(kSamples, Camera{}), "4");
  EXPECT_EQ(written(kOn, Camera{}), "no");
  EXPECT_EQ(written(kStep, Camera{}), "");
}

TEST(Option, AssignSetsTheField) {
  Camera camera;
  EXPECT_TRUE(assign(kFov, camera, "60.5"));
  EXPECT_TRUE(assign(kTarget, camera, "0,-1,+2"));
  EXPECT_TRUE(assign(kOrbit, camera, "1,2,3"));
  EXPECT_TRUE(assign(kLens, camera, "wide"));
  EXPECT_TRUE(assign(kOn, camera, "yes"));
  EXPECT_TRUE(assign(kStep, camera, "0"));
  EXPECT_FALSE(assign(kStep, camera, "-1"));
  EXPECT_TRUE(assign(kLight, camera, "a"));
  EXPECT_TRUE(assign(kLight, camera, "b"));
  EXPECT_EQ(camera.fov_deg, 60.5f);
  EXPECT_EQ(camera.target, glm::vec3(0, -1, 2));
  EXPECT_THAT(camera.orbit, ElementsAre(1, 2, 3));
  EXPECT_EQ(camera.lens, Lens::wide);
  EXPECT_TRUE(camera.on);
  EXPECT_EQ(camera.step, 0);
  EXPECT_EQ(written(kStep, camera), "0");
  EXPECT_THAT(camera.lights, ElementsAre("a", "b"));
}

TEST(Option, AChoiceMayBeWrittenInCapitalsOrByAnAlias) {
  const Option<Camera> lens{{.name = "lens", .choices = "wide|tele", .aliases = "broad=wide|telephoto=tele"},
                            choiceField<&Camera::lens>};
  Camera camera;
  EXPECT_TRUE(assign(lens, camera, "Wide"));
  EXPECT_EQ(camera.lens, Lens::wide);
  EXPECT_TRUE(assign(lens, camera, "TELEPHOTO"));
  EXPECT_EQ(camera.lens, Lens::tele);
  EXPECT_FALSE(assign(lens, camera, "broader"));
}

TEST(Option, WrongValuesAreNamedWithUnitAndRange) {
  Camera camera;
  for (const char* wrong : {"", "wide", "0", "171", "nan", "inf", "45 ", "45,46"}) {
    const auto result = assign(kFov, camera, wrong);
    ASSERT_FALSE(result) << wrong;
    EXPECT_EQ(result.error().code, ErrorCode::usage);
    EXPECT_THAT(result.error().message, HasSubstr("fov takes a number in degrees (1 … 170)"));
  }
  EXPECT_EQ(camera.fov_deg, 45.0f);
  EXPECT_FALSE(assign(kTarget, camera, "1,2"));
  EXPECT_FALSE(assign(kTarget, camera, "1,2,3,4"));
  ASSERT_TRUE(assign(kTarget, camera, "7"));
  EXPECT_EQ(camera.target, glm::vec3(7));
  EXPECT_FALSE(assign(kOrbit, camera, "1,2,3,4"));
  EXPECT_FALSE(assign(kSamples, camera, "2.5"));
  EXPECT_FALSE(assign(kSamples, camera, "65"));
  EXPECT_FALSE(assign(kOn, camera, "maybe"));
}

TEST(Option, ANumberBeyondALimitIsToldWithBothLimits) {
  Camera camera;
  const Option<Camera> distance{{.name = "distance", .unit = "metres", .minimum = 0}, &Camera::fov_deg};
  EXPECT_EQ(rangeText(distance.text), "at least 0");
  EXPECT_THAT(assign(distance, camera, "1e31").error().message, HasSubstr("in metres (0 … 1e+30)"));
  EXPECT_THAT(assign(distance, camera, "far").error().message, HasSubstr("(at least 0)"));
  EXPECT_EQ(rangeText(kTarget.text), "");
  EXPECT_THAT(assign(kTarget, camera, "0,-1e31,0").error().message, HasSubstr("(-1e+30 … 1e+30)"));
  const Option<Camera> light{{.name = "light", .minimum = 1e-30, .maximum = 1e38}, &Camera::fov_deg};
  EXPECT_EQ(rangeText(light.text), "1e-30 … 1e+38");
  EXPECT_TRUE(assign(light, camera, "1e38"));
  const Option<Camera> count{{.name = "count"}, &Camera::samples};
  EXPECT_THAT(assign(count, camera, "3e9").error().message, HasSubstr("2147483"));
  EXPECT_TRUE(assign(count, camera, "-2147483647"));
}

TEST(Option, WrongChoiceListsTheRightOnes) {
  Camera camera;
  const auto result = assign(kLens, camera, "tela");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("did you mean 'tele'"));
  EXPECT_THAT(result.error().message, HasSubstr("wide, tele"));
}

// What is given may come from a file.
TEST(Option, ARefusalShowsWhatWasGivenAsALine) {
  const auto refused = parseNumbers({.name = "fov"}, "4\n0\x1b[31m" + std::string(5000, 'x'));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message.find_first_of("\n\x1b"), std::string::npos) << refused.error().message;
  EXPECT_LT(refused.error().message.size(), 300u);
}

}  // namespace
}  // namespace mirrorball
