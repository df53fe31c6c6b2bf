#include "mirrorball/render/settings/quality.h"

#include <algorithm>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/base/range.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// A scene that needs all that there is.
constexpr SceneTraits kNeedsAll{
    .lets_light_through = true, .is_polished = true, .has_objects = true, .hides_itself = true, .can_trace_rays = true};

FrameSettings filledIn(Quality quality, const SceneTraits& traits, const std::set<std::string_view>& given = {},
                       FrameSettings settings = {}) {
  fillIn(quality, traits, given, settings);
  return settings;
}

TEST(Quality, EachChoiceIsAnOptionWithThoseValues) {
  for (const QualityChoice& choice : qualityChoices()) {
    const auto option = std::find_if(frameOptions().begin(), frameOptions().end(),
                                     [&](const auto& each) { return each.text.name == choice.option; });
    ASSERT_NE(option, frameOptions().end()) << choice.option;
    FrameSettings settings;
    for (const std::string_view value : choice.values) {
      EXPECT_TRUE(value.empty() || assign(*option, settings, value)) << choice.option << " " << value;
    }
    for (const std::string_view name : choice.left_to)
      EXPECT_TRUE(std::any_of(frameOptions().begin(), frameOptions().end(), [&](const auto& each) {
        return each.text.name == name;
      })) << name;
  }
}

TEST(Quality, ADraftIsWhatTheSettingsAre) { EXPECT_EQ(filledIn(Quality::draft, kNeedsAll), FrameSettings()); }

TEST(Quality, GoodFillsInWhatTheSceneNeeds) {
  FrameSettings expected;
  EXPECT_EQ(filledIn(Quality::good, {.can_trace_rays = true}), expected) << "nothing, of a matt ball";
  expected.refraction = RefractionKind::automatic;
  expected.behind = BehindKind::screen;
  EXPECT_EQ(filledIn(Quality::good, {.lets_light_through = true, .can_trace_rays = true}), expected);
  expected = {};
  expected.occlusion = OcclusionKind::vertex;
  EXPECT_EQ(filledIn(Quality::good, {.hides_itself = true, .can_trace_rays = true}), expected);
  expected.self_reflection = true;
  EXPECT_EQ(filledIn(Quality::good, {.is_polished = true, .hides_itself = true, .can_trace_rays = true}), expected);
  expected = {};
  expected.probes = FrameSettings::kAutoProbes;
  EXPECT_EQ(filledIn(Quality::good, {.is_polished = true, .has_objects = true}), expected) << "without rays";
}

TEST(Quality, AStrongSunThrowsShadows) {
  const SceneTraits sunny{.has_strong_sun = true};
  EXPECT_EQ(filledIn(Quality::good, sunny).sun, SunKind::split);
  EXPECT_EQ(filledIn(Quality::good, {}).sun, SunKind::map);
  EXPECT_EQ(filledIn(Quality::draft, sunny).sun, SunKind::map);
  FrameSettings near;
  near.proxy.kind = ProxyKind::sphere;
  EXPECT_EQ(filledIn(Quality::good, sunny, {"proxy"}, near).sun, SunKind::map);
  near.proxy.kind = ProxyKind::ground;
  EXPECT_EQ(filledIn(Quality::good, sunny, {"proxy"}, near).sun, SunKind::split);
  FrameSettings mapped;
  mapped.mapping = Mapping::normal;
  EXPECT_EQ(filledIn(Quality::good, sunny, {"mapping"}, mapped).sun, SunKind::map);
  EXPECT_TRUE(dependsOnSun(Quality::good, {}, {}));
  EXPECT_FALSE(dependsOnSun(Quality::good, {"sun"}, {}));
  EXPECT_FALSE(dependsOnSun(Quality::draft, {}, {}));
}

TEST(Quality, NothingIsLookedForInAHugeSceneUnasked) {
  SceneTraits huge = kNeedsAll;
  huge.is_huge = true;
  const FrameSettings filled = filledIn(Quality::good, huge);
  EXPECT_EQ(filled.occlusion, OcclusionKind::none);
  EXPECT_FALSE(filled.self_reflection);
  EXPECT_EQ(filled.behind, BehindKind::screen);
}

// Rays are spent only where their answer matters.
TEST(Quality, KnowsWhereWhatHidesMatters) {
  EXPECT_TRUE(dependsOnHiding(Quality::good, kNeedsAll, {}, {}));
  EXPECT_FALSE(dependsOnHiding(Quality::draft, kNeedsAll, {}, {}));
  for (const std::string_view said : {"occlusion", "self-reflection", "probes"}) {
    FrameSettings settings;
    settings.self_reflection = said == "self-reflection";
    settings.probes = said == "probes" ? FrameSettings::kAutoProbes : 0;
    EXPECT_FALSE(dependsOnHiding(Quality::good, kNeedsAll, {said}, settings)) << said;
  }
}

TEST(Quality, BestTakesMore) {
  const FrameSettings best = filledIn(Quality::best, kNeedsAll);
  EXPECT_EQ(best.samples, 16);
  EXPECT_EQ(best.refraction, RefractionKind::traced);
  EXPECT_EQ(best.inner_bounces, 8);
  EXPECT_EQ(filledIn(Quality::best, kNeedsAll, {"refraction"}).inner_bounces, 4);
  EXPECT_TRUE(best.self_reflection);
}

TEST(Quality, WhatIsGivenStays) {
  FrameSettings given;
  given.refraction = RefractionKind::image_space;
  given.samples = 1;
  const FrameSettings filled = filledIn(Quality::best, kNeedsAll, {"refraction", "samples"}, given);
  EXPECT_EQ(filled.refraction, RefractionKind::image_space);
  EXPECT_EQ(filled.samples, 1);
  EXPECT_EQ(filled.behind, BehindKind::screen);
  // A technique that is asked for is not hidden by another one.
  FrameSettings with_probes;
  with_probes.probes = FrameSettings::kAutoProbes;
  for (const std::string_view technique : {"probes", "occlusion"})
    EXPECT_FALSE(filledIn(Quality::good, kNeedsAll, {technique}, with_probes).self_reflection) << technique;
  EXPECT_TRUE(filledIn(Quality::good, kNeedsAll, {"probes"}).self_reflection) << "--probes 0";
  SceneTraits without_rays = kNeedsAll;
  without_rays.can_trace_rays = false;
  EXPECT_EQ(filledIn(Quality::best, without_rays, {"probes"}).probe_bounces, FrameSettings().probe_bounces);
}

// The lectures' techniques reflect the environment alone, on rough surfaces too, unless more is asked for.
TEST(Quality, ClassicTechniquesReflectTheEnvironmentAlone) {
  for (const auto& [name, value] : std::initializer_list<std::pair<std::string_view, std::string_view>>{
           {"mapping", "sphere"},
           {"reflect-at", "triangle"},
           {"texgen", "reflection"},
           {"texture-matrix", "2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"},
           {"lookup", "flat"},
           {"blur", "mip"}}) {
    const auto option = findBy(frameOptions(), name, [](const auto& each) { return each.text.name; });
    ASSERT_NE(option, frameOptions().end()) << name;
    FrameSettings asked;
    ASSERT_TRUE(assign(*option, asked, value)) << name << " " << value;
    const FrameSettings filled = filledIn(Quality::good, kNeedsAll, {name}, asked);
    EXPECT_EQ(filled.occlusion, OcclusionKind::none) << name;
    EXPECT_FALSE(filled.self_reflection) << name;
    const FrameSettings usual = filledIn(Quality::good, kNeedsAll, {name});
    EXPECT_EQ(usual, filledIn(Quality::good, kNeedsAll)) << name << " at its default asks for nothing";
    asked.occlusion = OcclusionKind::vertex;
    EXPECT_EQ(filledIn(Quality::good, kNeedsAll, {name, "occlusion"}, asked).occlusion, OcclusionKind::vertex) << name;
  }
}

TEST(Quality, SaysWhatItChose) {
  FrameSettings settings;
  EXPECT_EQ(fillIn(Quality::good, kNeedsAll, {"behind"}, settings),
            "{option:refraction} auto {option:occlusion} vertex {option:self-reflection}");
  EXPECT_EQ(fillIn(Quality::good, {}, {}, settings), "");
}

TEST(Quality, TraitsAreTheModels) {
  EXPECT_TRUE(traitsOf(*loadModel("tumbler-water")).lets_light_through);
  EXPECT_TRUE(traitsOf(*loadModel("spheres")).has_objects);
  Scene matt = meshScene(sphereMesh(8, 16));
  matt.materials[0].perceptual_roughness = 0.7f;
  EXPECT_FALSE(traitsOf(matt).is_polished);
  matt.materials[0].clearcoat = 1.0f;
  EXPECT_TRUE(traitsOf(matt).is_polished);
  EXPECT_FALSE(traitsOf(Scene()).has_objects);
}

}  // namespace
}  // namespace mirrorball
