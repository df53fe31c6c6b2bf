// What changes on a stage, and what that costs. That pictures are those of a new device, examples/live_stage tests.

#include "mirrorball/render/stage/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/render/stage/stage_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;
using testing::litFromAbove;
using testing::pictureOf;
using testing::smallFrame;

/// Two balls, each of a material of its own.
Scene pairOfBalls() {
  Scene scene;
  for (const float x : {-0.6f, 0.6f}) testing::addBall(scene, {x, 0.0f, 0.0f}, 0.5f, Material(), 12);
  return scene;
}

class StageTest : public ::testing::TestWithParam<gl::Api> {
 protected:
  void SetUp() override {
    auto context = gl::Context::createHeadless(GetParam());
    if (!context) MIRRORBALL_END_WITHOUT_GL(context.error().message);
    stage_.emplace(*Device::on(std::move(*context)));
    const Environment light = litFromAbove();
    ASSERT_TRUE(stage().setEnvironment(light, *testing::prepareOnce(light)));
    ASSERT_TRUE(stage().setScene(pairOfBalls()));
  }

  Stage& stage() { return *stage_; }
  /// Of the stage, that frames with those settings show.
  std::shared_ptr<StagedScene> formFor(const FrameSettings& settings) { return *stage().state().formFor(settings); }

 private:
  std::optional<Stage> stage_;
};

MIRRORBALL_WITH_BOTH_APIS(StageTest);

TEST_P(StageTest, ANumberOfAMaterialSendsOneBlock) {
  View view(stage());
  std::vector<float> picture = pictureOf(view, smallFrame());
  SceneBlocks& blocks = formFor(smallFrame())->buffers().blocks();
  const auto sentFor = [&](const std::vector<std::size_t>& changed) {
    const std::size_t before = blocks.bytesSent();
    for (const std::size_t index : changed) {
      Material material = stage().scene().materials[index];
      material.base_color.y *= 0.5f;
      EXPECT_TRUE(stage().setMaterial(index, material));
    }
    EXPECT_NE(std::exchange(picture, pictureOf(view, smallFrame())) == picture, !changed.empty());
    return blocks.bytesSent() - before;
  };
  EXPECT_EQ(sentFor({}), 0u);
  const std::size_t of_one = sentFor({1});
  EXPECT_GT(of_one, 0u);
  EXPECT_EQ(sentFor({0}), of_one);
  EXPECT_EQ(sentFor({0, 1}), 2 * of_one);
  RecordProperty("bytes", static_cast<int>(of_one));
}

// Each kind of light is sorted, drawn or captured anew only by what it depends on.
TEST_P(StageTest, AColorSortsNoTriangles) {
  const auto form = formFor(smallFrame());
  const auto change = [&](auto&& set) {
    Material material = stage().scene().materials[0];
    set(material);
    ASSERT_TRUE(stage().setMaterial(0, material));
  };
  const std::uint64_t shapes = form->version(StagePart::shapes), materials = form->version(StagePart::materials);
  change([](Material& m) { m.base_color.x = 0.3f; });
  change([](Material& m) { m.perceptual_roughness = 0.3f; });
  EXPECT_EQ(form->version(StagePart::shapes), shapes);
  EXPECT_NE(form->version(StagePart::materials), materials);
  change([](Material& m) { m.transmission = 1.0f; });
  const std::uint64_t of_glass = form->version(StagePart::shapes);
  EXPECT_NE(of_glass, shapes);
  change([](Material& m) { m.double_sided = true; });
  EXPECT_NE(form->version(StagePart::shapes), of_glass);
}

// A view of one device may be made and end while another's context is current.
TEST_P(StageTest, AViewTouchesNothingOfAnotherDevice) {
  View shown(stage());
  const std::vector<float> picture = pictureOf(shown, smallFrame());
  {
    const auto other = gl::Context::createHeadless(GetParam());
    ASSERT_TRUE(other);
    std::vector<View> views;
    for (int i = 0; i < 8; ++i) views.emplace_back(stage());
  }
  EXPECT_EQ(pictureOf(shown, smallFrame()), picture);
}

TEST_P(StageTest, AFrameThatCannotBeginShowsNothing) {
  View view(stage());
  EXPECT_FALSE(view.drawSample()) << "no frame has been asked for";
  EXPECT_FALSE(view.picture());
  EXPECT_FALSE(view.pick({1.0f, 1.0f}));
  EXPECT_FALSE(view.show(0));
  const std::vector<float> picture = pictureOf(view, smallFrame());
  EXPECT_TRUE(view.isDone());
  FrameSettings huge = smallFrame();
  huge.size = {1 << 20, 1 << 20};
  ASSERT_FALSE(view.begin(huge));
  EXPECT_FALSE(view.isDone());
  EXPECT_FALSE(view.radiance());
  EXPECT_FALSE(view.pick({1.0f, 1.0f}));
  EXPECT_FALSE(view.drawSample()) << "it begins again, and cannot";
  EXPECT_EQ(pictureOf(view, smallFrame()), picture);
  EXPECT_FALSE(View(Stage(stage().device())).draw(smallFrame())) << "it has no light";
}

// What the caller has found is renewed once the scene has changed, and completed where it lacks something.
TEST_P(StageTest, OcclusionThatWasGivenIsNotKeptTooLong) {
  Scene known = pairOfBalls();
  ASSERT_TRUE(findOcclusionOnce(known, {.rays = 16}, {}));
  ASSERT_TRUE(stage().setScene(known));
  FrameSettings hidden = smallFrame();
  hidden.occlusion = OcclusionKind::vertex;
  EXPECT_EQ(formFor(hidden), formFor(smallFrame())) << "it is known";
  FrameSettings mirrored = hidden;
  mirrored.self_reflection = true;
  EXPECT_FALSE(formFor(mirrored)->scene().instances[0].vertex_materials.empty());
  hidden.relief = ReliefKind::geometry;
  EXPECT_TRUE(stage().prepare(hidden, {}));
  hidden.relief = ReliefKind::bump;
  ASSERT_TRUE(stage().setTransform(0, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 3.0f, 0.0f))));
  EXPECT_NE(formFor(hidden), formFor(smallFrame())) << "it is found again";
  EXPECT_TRUE(formFor(smallFrame())->scene().instances[0].occlusion.empty());
}

// Five panes of a window, each with a form of its own, which no other takes away.
TEST_P(StageTest, FormsThatAreShownAreKept) {
  Scene scene = pairOfBalls();
  scene.materials[1].height = HeightKind::brick;
  ASSERT_TRUE(stage().setScene(scene));
  std::vector<FrameSettings> looks(5, smallFrame());
  testing::set(looks[0], "relief", "bump");
  testing::set(looks[1], "relief", "steep");
  testing::set(looks[2], "relief", "cone");
  testing::set(looks[3], "relief", "geometry");
  testing::set(looks[4], "occlusion", "vertex");
  std::vector<std::shared_ptr<StagedScene>> held;
  for (const FrameSettings& look : looks) held.push_back(formFor(look));
  for (std::size_t i = 0; i < looks.size(); ++i) EXPECT_EQ(formFor(looks[i]), held[i]) << i;
}

TEST_P(StageTest, AChangeBeginsAViewAgain) {
  View view(stage());
  ASSERT_TRUE(view.begin(smallFrame(4)));
  EXPECT_EQ(*view.drawSample(), 1);
  EXPECT_EQ(*view.drawSample(), 2);
  ASSERT_TRUE(stage().setTransform(0, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.4f, 0.0f))));
  EXPECT_EQ(*view.drawSample(), 1);
  EXPECT_EQ(*view.drawSample(), 2);
  ASSERT_TRUE(stage().setTransform(0, stage().scene().instances[0].world_from_object));
  EXPECT_EQ(*view.drawSample(), 3) << "it is where it was";
}

TEST_P(StageTest, ViewsWithTheirOwnTechniquesDrawInTurnsWhatEachDrawsAlone) {
  Scene scene = pairOfBalls();
  scene.textures.push_back({.image = Image8(8, 8, 4, 200), .srgb = true});
  for (int x = 0; x < 8; ++x) scene.textures[0].image.edit().texel(x, 3)[0] = 10;
  scene.materials[0].base_color_map.texture = 0;
  scene.materials[1].height = HeightKind::brick;
  ASSERT_TRUE(stage().setScene(scene));
  std::vector<FrameSettings> looks(5, smallFrame(2));
  testing::set(looks[0], "texture-filter", "nearest");
  testing::set(looks[1], "relief", "cone");
  testing::set(looks[2], "occlusion", "vertex");
  testing::set(looks[3], "proxy", "ground");
  testing::set(looks[4], "probes", "1");
  std::vector<std::vector<float>> alone;
  std::vector<View> views;
  for (const FrameSettings& look : looks) {
    View view(stage());
    alone.push_back(pictureOf(view, look));
    views.emplace_back(stage());
  }
  for (std::size_t i = 0; i < looks.size(); ++i) ASSERT_TRUE(views[i].begin(looks[i]));
  for (int sample = 1; sample <= 2; ++sample)
    for (View& view : views) ASSERT_EQ(*view.drawSample(), sample);
  for (std::size_t i = 0; i < looks.size(); ++i)
    EXPECT_TRUE(std::ranges::equal(views[i].radiance()->samples(), alone[i])) << "view " << i;
}

TEST_P(StageTest, FormsShareTheirTextures) {
  Scene scene = pairOfBalls();
  scene.textures.push_back({.image = Image8(8, 8, 4, 200)});
  scene.materials[0].base_color_map.texture = 0;
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings hidden = smallFrame();
  hidden.occlusion = OcclusionKind::vertex;
  const auto as_given = formFor(smallFrame()), with_occlusion = formFor(hidden);
  ASSERT_NE(as_given, with_occlusion);
  EXPECT_EQ(as_given->scene().textures[0].image.samples().data(),
            with_occlusion->scene().textures[0].image.samples().data());
  EXPECT_EQ(as_given->buffers().textureName(0), with_occlusion->buffers().textureName(0));
  EXPECT_FALSE(with_occlusion->scene().instances[0].occlusion.empty());
  EXPECT_EQ(formFor(hidden), with_occlusion) << "it is kept";
  ASSERT_TRUE(stage().setTransform(0, glm::mat4(1.0f)));
  EXPECT_NE(formFor(hidden), with_occlusion) << "what was hidden is no more";
  EXPECT_EQ(formFor(smallFrame()), as_given);
}

TEST_P(StageTest, ALostContextLosesNothingButTime) {
  View view(stage());
  FrameSettings look = smallFrame(2);
  testing::set(look, "probes", "1");
  const std::vector<float> picture = pictureOf(view, look);
  ASSERT_TRUE(view.begin(look));
  ASSERT_EQ(*view.drawSample(), 1);
  {
    // A host takes its context away, with all that was on it.
    auto host = gl::Context::createHeadless(GetParam());
    ASSERT_TRUE(stage().moveTo(*Device::on(*gl::Context::adoptCurrent())));
    const auto samples = view.drawSample();
    ASSERT_TRUE(samples) << samples.error().message;
    EXPECT_EQ(*samples, 1) << "it begins again";
    EXPECT_EQ(pictureOf(view, look), picture);
  }
  EXPECT_FALSE(view.drawSample());
  ASSERT_TRUE(stage().moveTo(*Device::on(*gl::Context::createHeadless(GetParam()))));
  EXPECT_EQ(pictureOf(view, look), picture);
}

TEST_P(StageTest, WhatIsNotThereIsTold) {
  const auto failure = [](const Result<void>& result) { return result ? "" : result.error().message; };
  EXPECT_THAT(failure(stage().setMaterial(7, {})), HasSubstr("material 7 of a scene of 2 materials"));
  Material painted;
  painted.normal_map.texture = 3;
  EXPECT_THAT(failure(stage().setMaterial(0, painted)), HasSubstr("normal_map: texture 3 of a scene of 0 textures"));
  Material deep;
  deep.height_texture = 5;
  EXPECT_THAT(failure(stage().setMaterial(0, deep)), HasSubstr("height_texture: 5 of a scene of 0 textures"));
  EXPECT_THAT(failure(stage().setTransform(0, glm::scale(glm::mat4(1.0f), {-1, 1, 1}))), HasSubstr("mirrored"));
  EXPECT_THAT(failure(stage().setTransform(0, glm::mat4(NAN))), HasSubstr("not finite"));
  EXPECT_THAT(failure(stage().setTransform(2, glm::mat4(1.0f))), HasSubstr("instance 2 of a scene of 2 instances"));
  EXPECT_THAT(failure(stage().setLights(std::vector<ModelLight>(33))), HasSubstr("33 lights"));
  EXPECT_THAT(failure(stage().moveInstances({{}})), HasSubstr("not those of the scene"));
}

TEST(Derived, IsMadeAgainOnceItsPartsChange) {
  StageVersions versions;
  Derived<int> made(StagePart::meshes | StagePart::lights);
  int count = 0;
  const auto make = [&] { return ++count; };
  EXPECT_EQ(made.get(versions, make), 1);
  EXPECT_EQ(made.get(versions, make), 1);
  versions.change(StagePart::materials);
  EXPECT_EQ(made.get(versions, make), 1);
  versions.change(StagePart::lights);
  EXPECT_EQ(made.get(versions, make), 2);
  versions.change(StagePart::scene);
  EXPECT_FALSE(made.tryGet(versions, [] { return Result<int>(fail(ErrorCode::too_large, "no")); }));
  EXPECT_EQ(**made.tryGet(versions, [&]() -> Result<int> { return make(); }), 3);
}

}  // namespace
}  // namespace mirrorball
