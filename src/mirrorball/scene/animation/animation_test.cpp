#include "mirrorball/scene/animation/animation.h"

#include <cmath>
#include <memory>

#include <glm/gtc/quaternion.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/animation/animation_choice.h"
#include "mirrorball/scene/model_stance.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

AnimationSampler keys(std::vector<float> times, std::vector<float> values, KeyInterpolation interpolation) {
  return {std::make_shared<const std::vector<float>>(std::move(times)),
          std::make_shared<const std::vector<float>>(std::move(values)), interpolation};
}

std::vector<double> at(const AnimationSampler& sampler, double seconds, bool is_rotation = false) {
  std::vector<double> value;
  sample(sampler, seconds, is_rotation, value);
  return value;
}

TEST(AnimationSampler, GoesStraightFromKeyToKey) {
  const AnimationSampler line = keys({1, 2, 4}, {0, 10, 2, 20, 8, 0}, KeyInterpolation::linear);
  EXPECT_THAT(at(line, 0.0), ElementsAre(0.0, 10.0)) << "before the first key as there";
  EXPECT_THAT(at(line, 1.0), ElementsAre(0.0, 10.0));
  EXPECT_THAT(at(line, 1.25), ElementsAre(0.5, 12.5));
  EXPECT_THAT(at(line, 2.0), ElementsAre(2.0, 20.0));
  EXPECT_THAT(at(line, 3.0), ElementsAre(5.0, 10.0));
  EXPECT_THAT(at(line, 4.0), ElementsAre(8.0, 0.0));
  EXPECT_THAT(at(line, 99.0), ElementsAre(8.0, 0.0)) << "behind the last as there";
}

TEST(AnimationSampler, AStepHoldsUntilTheNextKey) {
  const AnimationSampler steps = keys({0, 1, 2}, {5, 6, 7}, KeyInterpolation::step);
  EXPECT_THAT(at(steps, 0.999), ElementsAre(5.0));
  EXPECT_THAT(at(steps, 1.0), ElementsAre(6.0));
  EXPECT_THAT(at(steps, 1.5), ElementsAre(6.0));
  EXPECT_THAT(at(steps, 2.0), ElementsAre(7.0));
}

TEST(AnimationSampler, ACubicSplineFollowsItsSlopes) {
  // From 1, leaving with a slope of 3, to 5, arriving with −1, in two seconds. By hand, at a quarter of the way:
  // 0.84375 · 1 + 0.140625 · 2 · 3 + 0.15625 · 5 − 0.046875 · 2 · (−1).
  const AnimationSampler spline = keys({1, 3}, {100, 1, 3, -1, 5, 200}, KeyInterpolation::cubic_spline);
  EXPECT_EQ(spline.components(), 1u);
  EXPECT_THAT(at(spline, 0.0), ElementsAre(1.0));
  EXPECT_THAT(at(spline, 1.5), ElementsAre(DoubleNear(2.5625, 1e-12)));
  EXPECT_THAT(at(spline, 2.0), ElementsAre(DoubleNear(0.5 + 0.125 * 6 + 2.5 + 0.125 * 2, 1e-12)));
  EXPECT_THAT(at(spline, 3.0), ElementsAre(5.0));
  EXPECT_THAT(at(spline, 9.0), ElementsAre(5.0));
}

/// A turn about +Y.
std::vector<float> turn(float degrees, float sign = 1.0f) {
  const float half = glm::radians(degrees) / 2.0f;
  return {0.0f, sign * std::sin(half), 0.0f, sign * std::cos(half)};
}

std::vector<float> joined(std::vector<float> first, const std::vector<float>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

void expectTurn(const std::vector<double>& quaternion, float degrees) {
  const std::vector<float> wanted = turn(degrees);
  ASSERT_EQ(quaternion.size(), 4u);
  double same = 0.0;
  for (std::size_t i = 0; i < 4; ++i) same += quaternion[i] * double(wanted[i]);
  EXPECT_NEAR(std::abs(same), 1.0, 1e-6) << degrees;
}

TEST(AnimationSampler, TurnsTheShortWayAtOneSpeed) {
  // The same rotation has two quaternions; the second key has the one that is farther away.
  const AnimationSampler turning = keys({0, 1}, joined(turn(10), turn(130, -1)), KeyInterpolation::linear);
  expectTurn(at(turning, 0.0, true), 10);
  expectTurn(at(turning, 0.25, true), 40);
  expectTurn(at(turning, 0.5, true), 70);
  expectTurn(at(turning, 1.0, true), 130);
  const AnimationSampler across = keys({0, 1}, joined(turn(-20), turn(300)), KeyInterpolation::linear);
  expectTurn(at(across, 0.5, true), -40);
}

TEST(AnimationSampler, SplinesOfRotationsStayRotations) {
  const std::vector<float> none(4, 0.0f);
  const std::vector<float> values = joined(joined(joined(none, turn(0)), none), joined(joined(none, turn(90)), none));
  const AnimationSampler spline = keys({0, 1}, values, KeyInterpolation::cubic_spline);
  expectTurn(at(spline, 0.5, true), 45);
  // A rotation without a length is none.
  EXPECT_THAT(at(keys({0}, none, KeyInterpolation::step), 0.0, true), ElementsAre(0.0, 0.0, 0.0, 1.0));
}

// --- which one is shown

Result<AnimationChoice> choice(const std::string& text) {
  ModelStance stance;
  const Result<void> assigned = assign(stanceOptions().back(), stance, text);
  if (!assigned) return tl::unexpected<Error>(assigned.error());
  return stance.animation;
}

TEST(AnimationChoice, IsANameAndATime) {
  EXPECT_EQ(*choice("Walk"), (AnimationChoice{"Walk", {}}));
  EXPECT_EQ(*choice("Walk@1.5"), (AnimationChoice{"Walk", 1.5f}));
  EXPECT_EQ(*choice("2@0"), (AnimationChoice{"2", 0.0f}));
  EXPECT_EQ(*choice("Hero@Run"), (AnimationChoice{"Hero@Run", {}})) << "a name may have an @";
  EXPECT_EQ(*choice("Hero@Run@3"), (AnimationChoice{"Hero@Run", 3.0f}));
  for (const char* wrong : {"", "@1", "Walk@-1", "Walk@", "Walk@1e30"}) {
    ASSERT_FALSE(choice(wrong)) << wrong;
    EXPECT_EQ(choice(wrong).error().code, ErrorCode::usage);
    EXPECT_THAT(choice(wrong).error().message, HasSubstr("seconds from 0 on"));
  }
  EXPECT_EQ(written(stanceOptions().back(), ModelStance{.animation = *choice("Walk@1.5")}), "Walk@1.5");
}

TEST(AnimationChoice, IsFoundByNameOrNumber) {
  Scene scene;
  EXPECT_THAT(chosenAnimation(scene, {"Walk", {}}).error().message, HasSubstr("has no animations"));
  for (const char* name : {"Walk", "Run", "3"}) scene.rig.animations.emplace_back().name = name;
  EXPECT_EQ(*chosenAnimation(scene, {"walk", {}}), 0u);
  EXPECT_EQ(*chosenAnimation(scene, {"2", {}}), 1u);
  EXPECT_EQ(*chosenAnimation(scene, {"3", {}}), 2u);
  for (const char* wrong : {"Wlk", "0", "4", "1.5", "-1"}) {
    ASSERT_FALSE(chosenAnimation(scene, {wrong, {}})) << wrong;
    EXPECT_EQ(chosenAnimation(scene, {wrong, {}}).error().code, ErrorCode::usage);
    EXPECT_THAT(chosenAnimation(scene, {wrong, {}}).error().message, HasSubstr("Walk, Run, 3"));
  }
}

}  // namespace
}  // namespace mirrorball
