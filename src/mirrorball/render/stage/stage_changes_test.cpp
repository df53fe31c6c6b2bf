// Whole scenes that are changed copies of each other, nodes, and work that is done apart from a stage.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/stage/scene_difference.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/render/stage/stage_testing.h"
#include "mirrorball/render/stage/stage_work_state.h"
#include "mirrorball/scene/animation/pose.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::litFromAbove;
using testing::pictureOf;
using testing::smallFrame;

Texture grey(std::uint8_t value) { return {.image = Image8(8, 8, 4, value)}; }

/// Two balls, each of a material with a texture of its own.
Scene paintedBalls() {
  Scene scene;
  scene.textures = {grey(200), grey(100)};
  for (int i = 0; i < 2; ++i) {
    Material material;
    material.base_color_map.texture = i;
    testing::addBall(scene, {i == 0 ? -0.6f : 0.6f, 0.0f, 0.0f}, 0.5f, material, 12);
  }
  addNodes(scene);
  return scene;
}

class StageChangesTest : public ::testing::TestWithParam<gl::Api> {
 protected:
  void SetUp() override {
    auto context = gl::Context::createHeadless(GetParam());
    if (!context) MIRRORBALL_END_WITHOUT_GL(context.error().message);
    stage_.emplace(made(Device::on(std::move(*context))));
    ASSERT_TRUE(stage().setScene(paintedBalls()));
  }

  static Stage made(Result<Device> device) {
    Stage stage(*device);
    const Environment light = litFromAbove();
    EXPECT_TRUE(stage.setEnvironment(light, *testing::prepareOnce(light)));
    return stage;
  }

  Stage& stage() { return *stage_; }
  SceneForms& forms() { return stage().state().scene; }
  std::shared_ptr<StagedScene> formFor(const FrameSettings& settings) { return *stage().state().formFor(settings); }

  std::vector<float> pictureOfNewDevice(const FrameSettings& settings) {
    Stage other = made(Device::on(*gl::Context::createHeadless(GetParam())));
    EXPECT_TRUE(other.setScene(stage().scene()));
    View view(other);
    return pictureOf(view, settings);
  }

 private:
  std::optional<Stage> stage_;
};

MIRRORBALL_WITH_BOTH_APIS(StageChangesTest);

TEST_P(StageChangesTest, AChangedCopyIsShownAndOnlyWhatChangedIsSentAgain) {
  View view(stage());
  std::vector<float> picture = pictureOf(view, smallFrame());
  const auto form = formFor(smallFrame());
  struct Names {
    unsigned first;
    unsigned second;
    bool operator==(const Names&) const = default;
  };
  const auto names = [&] { return Names{form->buffers().textureName(0), form->buffers().textureName(1)}; };
  const auto change = [&](const char* what, unsigned parts, auto&& how) {
    SCOPED_TRACE(what);
    Scene changed = stage().scene();
    how(changed);
    EXPECT_EQ(differingParts(stage().scene(), changed), parts);
    const std::uint64_t untouched = form->version(StagePart::scene & ~parts);
    ASSERT_TRUE(stage().setScene(std::move(changed)));
    EXPECT_EQ(form->version(StagePart::scene & ~parts), untouched);
    EXPECT_EQ(formFor(smallFrame()), form) << "it is the same on the GPU";
    std::vector<float> now = pictureOf(view, smallFrame());
    EXPECT_EQ(now == picture, parts == 0);
    EXPECT_EQ(now, pictureOfNewDevice(smallFrame()));
    picture = std::move(now);
  };
  const Names before = names();
  change("nothing", 0, [](Scene&) {});
  change("a light", StagePart::lights, [](Scene& scene) {
    scene.lights.emplace_back();
    scene.lights[0].position = {0.0f, 3.0f, 1.0f};
    scene.lights[0].color = glm::vec3(30.0f);
  });
  change("a color", StagePart::materials, [](Scene& scene) { scene.materials[1].base_color = {1.0f, 0.2f, 0.1f}; });
  change("a place", StagePart::transforms, [](Scene& scene) { scene.instances[0].world_from_object[3].y = 0.2f; });
  change("a mesh", StagePart::meshes, [](Scene& scene) {
    for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.position.y *= 0.5f;
  });
  EXPECT_EQ(names(), before);
  change("pixels", StagePart::materials | StagePart::shapes, [](Scene& scene) {
    for (std::uint8_t& sample : scene.textures[1].image.edit().samples()) sample = 250;
  });
  EXPECT_EQ(names().first, before.first);
  change("an instance that is hidden", StagePart::meshes | StagePart::transforms | StagePart::occlusion,
         [](Scene& scene) { scene.instances.pop_back(); });
  EXPECT_EQ(names().first, before.first);
}

// Triangles that are sorted for a form stay where only colours and lamps have changed.
TEST_P(StageChangesTest, AFormFollowsItsSceneAsFarAsItCan) {
  Scene scene = paintedBalls();
  scene.materials[0].height = HeightKind::brick;
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings steep = smallFrame();
  testing::set(steep, "relief", "steep");
  const auto form = formFor(steep);
  const auto become = [&](auto&& how) {
    Scene changed = stage().scene();
    how(changed);
    ASSERT_TRUE(stage().setScene(std::move(changed)));
    const std::vector<float> expected = pictureOfNewDevice(steep);
    View view(stage());  // after the new device: it leaves this stage's device current, which formFor() needs
    EXPECT_EQ(pictureOf(view, steep), expected);
  };
  become([](Scene& changed) { changed.textures[0] = grey(30); });
  EXPECT_EQ(formFor(steep), form);
  EXPECT_EQ(form->buffers().textureName(0), formFor(smallFrame())->buffers().textureName(0)) << "it is sent once";
  become([](Scene& changed) { changed.materials[0].height_scale *= 0.5f; });
  EXPECT_NE(formFor(steep), form) << "its heights are others";
}

// What the caller knew of the scene is of the mesh as it was before its relief became triangles.
TEST_P(StageChangesTest, ACutFormFollowsASceneWhoseOcclusionIsKnown) {
  Scene scene = paintedBalls();
  scene.materials[0].height = HeightKind::brick;
  ASSERT_TRUE(findOcclusionOnce(scene, {.rays = 16}, {}));
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings cut = smallFrame();
  testing::set(cut, "relief", "geometry");
  View view(stage());
  pictureOf(view, cut);
  Scene changed = stage().scene();
  changed.materials[1].base_color = {1.0f, 0.2f, 0.1f};
  ASSERT_TRUE(stage().setScene(std::move(changed)));
  EXPECT_EQ(pictureOf(view, cut), pictureOfNewDevice(cut));
}

// 20 textures are more than a material has units: some are layers of an array.
TEST_P(StageChangesTest, LayersAreKeptAsTexturesAre) {
  Scene scene = paintedBalls();
  std::uint8_t level = 0;
  for (const MaterialMap& map : materialMaps()) {
    (scene.materials[0].*map.slot).texture = static_cast<int>(scene.textures.size());
    scene.textures.push_back(grey(level += 9));
  }
  scene.materials[0].clearcoat = 0.5f;
  ASSERT_TRUE(stage().setScene(scene));
  View view(stage());
  pictureOf(view, smallFrame());
  Scene changed = stage().scene();
  changed.instances[0].world_from_object[3].y = 0.3f;
  ASSERT_TRUE(stage().setScene(changed));
  EXPECT_EQ(pictureOf(view, smallFrame()), pictureOfNewDevice(smallFrame()));
  changed.textures.back() = grey(250);
  ASSERT_TRUE(stage().setScene(std::move(changed)));
  EXPECT_EQ(pictureOf(view, smallFrame()), pictureOfNewDevice(smallFrame()));
}

TEST_P(StageChangesTest, NodesThatCameLaterAreKnownToForms) {
  Scene scene = paintedBalls();
  scene.rig = {};
  for (Instance& instance : scene.instances) instance.node = -1;
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings hidden = smallFrame();
  testing::set(hidden, "occlusion", "vertex");
  formFor(hidden);
  addNodes(scene);
  ASSERT_TRUE(stage().setScene(scene));
  EXPECT_EQ(formFor(hidden)->scene().instances[1].node, 1);
}

TEST_P(StageChangesTest, NodesMoveWhileLampsComeAndGo) {
  Scene scene = paintedBalls();
  scene.rig = {};
  scene.lights.resize(2);
  addNodes(scene);
  ASSERT_TRUE(stage().setScene(scene));
  ASSERT_TRUE(stage().setLights({ModelLight()}));
  ASSERT_TRUE(stage().setNode(0, {.translation = {0.0, 1.0, 0.0}}));
  EXPECT_EQ(stage().scene().lights[0].position, glm::vec3(0.0f)) << "it is of no node";
  EXPECT_EQ(glm::vec3(stage().scene().instances[0].world_from_object[3]), glm::vec3(0, 1, 0));
}

TEST_P(StageChangesTest, ANodeMovesWhatIsBelowIt) {
  Scene scene = paintedBalls();
  Rig& rig = scene.rig;
  rig.nodes = {{.name = "all"}, {.name = "left", .parent = 0}, {.name = "right", .parent = 0}};
  rig.parts = {{.node = 1, .mesh = 0}, {.node = 2, .mesh = 1}};
  rig.nodes[2].place.translation = {1.0, 0.0, 0.0};
  ASSERT_TRUE(poseAtRest(scene));
  ASSERT_TRUE(stage().setScene(scene));
  View view(stage());
  const std::vector<float> before = pictureOf(view, smallFrame());
  const auto place = [&](std::size_t instance) {
    return glm::vec3(stage().scene().instances.at(instance).world_from_object[3]);
  };
  EXPECT_EQ(place(1), glm::vec3(1, 0, 0));
  ASSERT_TRUE(stage().setNode(0, {.translation = {0.0, 2.0, 0.0}}));
  EXPECT_EQ(place(0), glm::vec3(0, 2, 0));
  EXPECT_EQ(place(1), glm::vec3(1, 2, 0));
  ASSERT_TRUE(stage().setNode(2, {.translation = {0.5, 0.0, 0.0}}));
  EXPECT_EQ(place(1), glm::vec3(0.5f, 2, 0));
  EXPECT_EQ(pictureOf(view, smallFrame()), pictureOfNewDevice(smallFrame()));
  ASSERT_TRUE(stage().setNode(1, {.scale = glm::dvec3(0.0)}));
  EXPECT_EQ(stage().scene().instances.size(), 1u) << "it is not shown";
  EXPECT_EQ(pictureOf(view, smallFrame()), pictureOfNewDevice(smallFrame()));
  ASSERT_TRUE(stage().setNode(1, {}));
  ASSERT_TRUE(stage().setNode(2, {.translation = {1.0, 0.0, 0.0}}));
  ASSERT_TRUE(stage().setNode(0, {}));
  EXPECT_EQ(pictureOf(view, smallFrame()), before);
  const auto failed = stage().setNode(3, {});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("node 3 of a scene of 3 nodes"));
}

FrameSettings costlyFrame() {
  FrameSettings settings = smallFrame();
  testing::set(settings, "occlusion", "vertex");
  testing::set(settings, "self-reflection", "yes");
  testing::set(settings, "refraction", "traced");
  return settings;
}

TEST_P(StageChangesTest, WorkIsDoneInAnotherThreadWhileAViewDraws) {
  Material glass = stage().scene().materials[1];
  glass.transmission = 1.0f;
  ASSERT_TRUE(stage().setMaterial(1, glass));
  const FrameSettings costly = costlyFrame();
  const std::vector<float> truth = pictureOfNewDevice(costly);
  Result<StageWork> work = stage().workFor(costly);
  ASSERT_TRUE(work);
  Result<void> done = fail(ErrorCode::interrupted, "not yet");
  std::vector<std::size_t> steps;
  std::size_t all = 0;
  std::thread other([&] {
    done = work->run([&](std::size_t step, std::size_t total) {
      steps.push_back(step);
      all = total;
      return true;
    });
  });
  View view(stage());
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(view.draw(smallFrame()));
  other.join();
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  EXPECT_EQ(steps.back(), all);
  EXPECT_EQ(forms().find(preparationFor(costly)), nullptr);
  const auto is_taken = stage().take(std::move(*work));
  ASSERT_TRUE(is_taken);
  EXPECT_TRUE(*is_taken);
  EXPECT_NE(forms().find(preparationFor(costly)), nullptr);
  EXPECT_EQ(pictureOf(view, costly), truth);
}

TEST_P(StageChangesTest, WorkMakesThePrismsOfARelief) {
  Scene scene = paintedBalls();
  for (Material& material : scene.materials) material.height = HeightKind::waves;
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings exact = smallFrame();
  testing::set(exact, "relief", "exact");
  const std::vector<float> truth = pictureOfNewDevice(exact);
  ASSERT_TRUE(stage().prepare(exact));
  View view(stage());
  EXPECT_EQ(pictureOf(view, exact), truth);
}

TEST_P(StageChangesTest, WorkMakesWhatAShadowAndPickingNeed) {
  FrameSettings on_ground = smallFrame();
  on_ground.proxy.kind = ProxyKind::ground;
  const std::vector<float> truth = pictureOfNewDevice(on_ground);
  StagedScene& form = *forms().find(preparationFor(on_ground));
  EXPECT_FALSE(form.rows().casters || form.rows().rays || stage().state().light.hasGroundSampler());
  Result<StageWork> work = stage().workFor(on_ground, true);
  ASSERT_TRUE(work);
  std::optional<Result<void>> done;
  std::thread([&] { done = work->run(); }).join();
  ASSERT_TRUE(*done);
  EXPECT_FALSE(form.rows().casters || form.rows().rays || stage().state().light.hasGroundSampler());
  ASSERT_TRUE(stage().take(std::move(*work)));
  EXPECT_TRUE(form.rows().casters && form.rows().rays && stage().state().light.hasGroundSampler());
  View view(stage());
  EXPECT_EQ(pictureOf(view, on_ground), truth);
  const auto picked = view.pick({8, 8});
  ASSERT_TRUE(picked) << picked.error().message;

  // What is there is not made again.
  Result<StageWork> again = stage().workFor(on_ground, true);
  ASSERT_TRUE(again);
  ASSERT_TRUE(again->run());
  EXPECT_FALSE(again->state().made.casters || again->state().made.rays || again->state().ground_sampler);
}

TEST_P(StageChangesTest, WorkMakesTheRaysThatGlassLightsAGroundBy) {
  Scene scene = paintedBalls();
  for (Material& material : scene.materials) material.transmission = 1.0f;
  ASSERT_TRUE(stage().setScene(scene));
  FrameSettings on_ground = smallFrame();
  on_ground.proxy.kind = ProxyKind::ground;
  const std::vector<float> truth = pictureOfNewDevice(on_ground);
  Result<StageWork> work = stage().workFor(on_ground);
  ASSERT_TRUE(work);
  ASSERT_TRUE(work->run());
  ASSERT_TRUE(stage().take(std::move(*work)));
  EXPECT_TRUE(forms().find(preparationFor(on_ground))->rows().rays);
  View view(stage());
  EXPECT_EQ(pictureOf(view, on_ground), truth);
}

TEST_P(StageChangesTest, WorkOfAnotherEnvironmentLeavesItsLight) {
  FrameSettings on_ground = smallFrame();
  on_ground.proxy.kind = ProxyKind::ground;
  Result<StageWork> work = stage().workFor(on_ground);
  ASSERT_TRUE(work);
  ASSERT_TRUE(work->run());
  ASSERT_TRUE(stage().setEnvironment(Environment(stage().state().light.environment())));
  ASSERT_TRUE(stage().take(std::move(*work)));
  EXPECT_FALSE(stage().state().light.hasGroundSampler());
}

TEST_P(StageChangesTest, WorkForASceneThatHasChangedIsOfNoUse) {
  Result<StageWork> work = stage().workFor(costlyFrame());
  ASSERT_TRUE(work);
  ASSERT_TRUE(stage().setTransform(0, glm::mat4(1.0f)));
  ASSERT_TRUE(work->run());
  const auto is_taken = stage().take(std::move(*work));
  ASSERT_TRUE(is_taken);
  EXPECT_FALSE(*is_taken);
  EXPECT_EQ(forms().find(preparationFor(costlyFrame())), nullptr);
}

TEST_P(StageChangesTest, WorkThatIsInterruptedLeavesTheStageAsItIs) {
  Result<StageWork> work = stage().workFor(costlyFrame());
  ASSERT_TRUE(work);
  const auto done = work->run([](std::size_t, std::size_t) { return false; });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::interrupted);
  const auto is_taken = stage().take(std::move(*work));
  ASSERT_TRUE(is_taken);
  EXPECT_FALSE(*is_taken);
  EXPECT_FALSE(stage().prepare(costlyFrame(), [](std::size_t, std::size_t) { return false; }));
}

TEST_P(StageChangesTest, LevelsOfTexturesMayBeMadeBefore) {
  Scene scene = paintedBalls();
  std::optional<Result<LevelsOfMaps>> levels;
  std::thread([&] { levels = makeMapLevels(scene); }).join();
  ASSERT_TRUE(*levels);
  EXPECT_EQ((*levels)->size(), 2u);
  ASSERT_TRUE(stage().setScene(scene, **levels));
  View view(stage());
  EXPECT_EQ(pictureOf(view, smallFrame()), pictureOfNewDevice(smallFrame()));
  EXPECT_FALSE(makeMapLevels(scene, [](std::size_t, std::size_t) { return false; }));
}

/// Those balls, which need a program each.
Scene differentBalls() {
  Scene scene = paintedBalls();
  scene.materials[1].clearcoat = 1.0f;
  scene.materials[1].alpha_mode = AlphaMode::blend;
  scene.materials[1].opacity = 0.5f;
  return scene;
}

TEST_P(StageChangesTest, ProgramsAreMadeOneAtATime) {
  ASSERT_TRUE(stage().setScene(differentBalls()));
  const std::vector<float> truth = pictureOfNewDevice(smallFrame());
  View view(stage());
  ASSERT_TRUE(view.begin(smallFrame()));
  std::vector<int> left;
  for (;;) {
    const auto now = view.makeProgram();
    ASSERT_TRUE(now) << now.error().message;
    left.push_back(*now);
    if (*now == 0) break;
  }
  EXPECT_THAT(left, ElementsAre(1, 0));
  EXPECT_EQ(*view.makeProgram(), 0);
  ASSERT_TRUE(view.drawSample());
  EXPECT_TRUE(std::ranges::equal(view.radiance()->samples(), truth));
}

TEST_P(StageChangesTest, ProgramsOfAFrameAreFoundWithoutTheDriver) {
  ASSERT_TRUE(stage().setScene(differentBalls()));
  View view(stage());
  ASSERT_TRUE(view.begin(smallFrame()));
  const SurfacePrograms::Programs& programs = stage().device().state().surfaces().programs();
  const std::size_t before = programs.size();
  const auto variants = view.surfaceVariants();
  ASSERT_TRUE(variants) << variants.error().message;
  EXPECT_EQ(programs.size(), before);
  ASSERT_TRUE(view.drawSample());
  std::vector<SurfaceVariant> drawn;
  for (const auto& [variant, program] : programs) drawn.push_back(variant);
  EXPECT_TRUE(std::ranges::is_permutation(*variants, drawn));
}

}  // namespace
}  // namespace mirrorball
