// --animation of render, capture and export: a glTF file's animations from outside, in both renderers.

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/scene/gltf/gltf_animation_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class AnimationCliTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("dark.exr", Image(8, 4, 3, 0.0f));
    AnimationMaker walk(file_.maker), grow(file_.maker);
    walk.move(R"("node":0,"path":"translation")", {0, 2}, {0, 0, 0, 8, 0, 0}, "VEC3")
        .move(R"("node":1,"path":"translation")", {0, 2}, {0, 0, 9, 0, 8, 9}, "VEC3");
    grow.point("/materials/0/emissiveFactor", {0, 1}, {1, 1, 1, 0, 0.5, 1}, "VEC3");
    animations_ = R"(,"animations":[)" + walk.json("Walk") + "," + grow.json("Grow") + "]";
    writeAt("walk.gltf", "0,0,0", animations_);
  }

  /// A triangle that glows, with a camera before it.
  void writeAt(const std::string& name, const std::string& place, const std::string& more = "") const {
    write(name, file_.json(R"("cameras":[{"type":"perspective","name":"eye","perspective":{"yfov":0.8,"znear":0.1}}],)"
                           R"("nodes":[{"mesh":0,"translation":[)" +
                               place +
                               R"(]},{"camera":0,"translation":[0,0,9]}],)"
                               R"("materials":[{"emissiveFactor":[1,1,1]}])" +
                               more,
                           "", ",\"material\":0"));
  }

  /// A picture with a camera that does not follow the model.
  Image drawn(const std::string& model, const std::string& how = "") const {
    run("render " + model + " -e dark.exr --camera 0,0 --target 2,0,0 --orthographic 20 --size 96x48 -o a.exr " + how);
    return image("a.exr");
  }

  TriangleFile file_;
  std::string animations_;
};

/// How many pixels glow, and where in the picture they are in the mean.
struct Glow {
  int pixels = 0;
  double x = 0.0;
  double y = 0.0;
};

Glow glowOf(const Image& picture) {
  Glow glow;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!(picture.texel(x, y)[2] > 0.5f)) continue;
      ++glow.pixels;
      glow.x += x;
      glow.y += y;
    }
  }
  glow.x /= std::max(glow.pixels, 1);
  glow.y /= std::max(glow.pixels, 1);
  return glow;
}

TEST_F(AnimationCliTest, ATimeIsAsTheModelWouldStandThere) {
  writeAt("there.gltf", "4,0,0");
  writeAt("end.gltf", "8,0,0");
  for (const char* renderer : {"", " --reference --samples 16 --bounces 1"}) {
    const Image wanted = drawn("there.gltf", renderer);
    EXPECT_GT(glowOf(wanted).pixels, 5);
    EXPECT_LT(maxDifference(drawn("walk.gltf", std::string("--animation Walk@1") + renderer), wanted), 1e-5)
        << renderer;
    EXPECT_LT(maxDifference(drawn("walk.gltf", std::string("--animation 1@1") + renderer), wanted), 1e-5) << renderer;
    EXPECT_LT(
        maxDifference(drawn("walk.gltf", std::string("--animation walk@99") + renderer), drawn("end.gltf", renderer)),
        1e-5)
        << renderer << "behind the end";
    EXPECT_LT(
        maxDifference(drawn("walk.gltf", std::string("--animation Walk") + renderer), drawn("walk.gltf", renderer)),
        1e-5)
        << renderer << "without a time it is the start";
    EXPECT_GT(maxDifference(drawn("walk.gltf", renderer), wanted), 0.5) << renderer;
  }
}

TEST_F(AnimationCliTest, MaterialsAndCamerasMoveToo) {
  const Image half = drawn("walk.gltf", "--animation Grow@0.5");
  glm::vec3 color(0.0f);
  for (int y = 0; y < half.height(); ++y)
    for (int x = 0; x < half.width(); ++x)
      for (int channel = 0; channel < 3; ++channel)
        color[channel] = std::max(color[channel], half.texel(x, y)[channel]);
  EXPECT_NEAR(color.x, 0.5f, 0.01f);
  EXPECT_NEAR(color.y, 0.75f, 0.01f);
  EXPECT_NEAR(color.z, 1.0f, 0.01f);
  // The camera goes up, and so the model down.
  succeed("render walk.gltf -e dark.exr --animation Walk@0 --camera eye --size 64x64 -o low.exr");
  succeed("render walk.gltf -e dark.exr --animation Walk@0.25 --camera eye --size 64x64 -o high.exr");
  EXPECT_GT(glowOf(image("high.exr")).y, glowOf(image("low.exr")).y + 3.0);
  succeed("render walk.gltf -e dark.exr --animation Walk --frames 8 --camera eye --size 64x64 -o eye.exr");
  EXPECT_EQ(maxDifference(image("eye_000.exr"), image("low.exr")), 0.0);
  EXPECT_EQ(maxDifference(image("eye_001.exr"), image("high.exr")), 0.0);
}

TEST_F(AnimationCliTest, FramesGoOverItsLengthBeforeACameraThatStandsStill) {
  succeed("render walk.gltf -e dark.exr --animation Walk --frames 4 --size 192x48 --camera 0,0 -o walk.exr");
  std::vector<Glow> glows;
  for (const char* name : {"walk_000.exr", "walk_001.exr", "walk_002.exr", "walk_003.exr"})
    glows.push_back(glowOf(image(name)));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(glows[i].pixels, 20);
    EXPECT_NEAR(glows[i].pixels, glows[0].pixels, 0.2 * glows[0].pixels) << "all of it is seen at any time";
    EXPECT_NEAR(glows[i].y, glows[0].y, 1.0);
  }
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(glows[i].x - glows[i - 1].x, glows[1].x - glows[0].x, 1.5);
  EXPECT_GT(glows[1].x - glows[0].x, 20.0);
  // From end to end they fill the picture.
  EXPECT_LT(glows[0].x, 192 * 0.15);
  EXPECT_GT(glows[3].x, 192 * 0.85);
}

TEST_F(AnimationCliTest, TurnsIfThatIsAskedFor) {
  const std::string shot = "render walk.gltf -e dark.exr --size 96x96 --set double_sided=yes ";
  succeed("render walk.gltf -e dark.exr --size 96x96 --set double_sided=yes --frames 3 -o rest.exr");
  succeed(shot + "--animation Walk@0 --frames 3 -o turned.exr");
  for (const std::string number : {"_000.exr", "_001.exr", "_002.exr"})
    EXPECT_EQ(maxDifference(image("turned" + number), image("rest" + number)), 0.0) << "with a time it is a turntable";
  EXPECT_GT(maxDifference(image("turned_000.exr"), image("turned_001.exr")), 0.5);
  succeed(shot + "--animation Grow --frames 2 --turn camera --camera 60,0 -o both.exr");
  succeed(shot + "--animation Grow --frames 2 --camera 60,0 -o still.exr");
  EXPECT_EQ(glowOf(image("still_000.exr")).pixels, glowOf(image("still_001.exr")).pixels);
  EXPECT_NE(glowOf(image("both_000.exr")).x, glowOf(image("both_001.exr")).x);
}

TEST_F(AnimationCliTest, AWrongOneIsToldWhatThereIs) {
  const std::string line = "render walk.gltf -e dark.exr --size 8x8 -o a.png --animation ";
  EXPECT_THAT(refuse(2, line + "Wlk"), AllOf(HasSubstr("no animation is named 'Wlk'"), HasSubstr("Walk, Grow")));
  EXPECT_THAT(refuse(2, line + "3"), HasSubstr("Walk, Grow"));
  EXPECT_THAT(refuse(2, line + "Walk@-1"), HasSubstr("seconds from 0 on"));
  EXPECT_THAT(refuse(2, line + "Walk --frames 3 --turn 1"), HasSubstr("give --animation a time, as in Walk@0"));
  EXPECT_THAT(refuse(2, line + "Walk --frames 3 --turn camera --camera eye"), HasSubstr("stands still"));
  writeAt("still.gltf", "0,0,0");
  EXPECT_THAT(refuse(2, "render still.gltf -e dark.exr --size 8x8 -o a.png --animation Walk"),
              HasSubstr("the model has no animations"));
  EXPECT_THAT(refuse(2, "render sphere -e dark.exr --size 8x8 -o a.png --animation Walk"),
              HasSubstr("the model has no animations"));
}

TEST_F(AnimationCliTest, InfoListsThem) {
  EXPECT_THAT(succeed("info walk.gltf"), HasSubstr("Walk (2 s), Grow (1 s)"));
  const auto json = nlohmann::json::parse(succeed("info walk.gltf --json"));
  EXPECT_EQ(json.at("animations").at(0).at("name"), "Walk");
  EXPECT_EQ(json.at("animations").at(1).at("seconds"), 1.0);
}

// The triangle is at X = 4 halfway: what is captured there is another light than at rest, and so is what is exported.
TEST_F(AnimationCliTest, IsCapturedAndExported) {
  const auto meanOf = [&](const std::string& how) {
    run("capture walk.gltf -e dark.exr --at 4,0.3,1 --size 32 -o a.exr " + how);
    const Image map = image("a.exr");
    return std::accumulate(map.samples().begin(), map.samples().end(), 0.0);
  };
  EXPECT_GT(meanOf("--animation Walk@1"), 1.5 * meanOf(""));
  run("export walk.gltf --animation Walk@1 -o moved.glb");
  const Glow moved = glowOf(drawn("moved.glb")), expected = glowOf(drawn("walk.gltf", "--animation Walk@1"));
  EXPECT_EQ(moved.pixels, expected.pixels);
  EXPECT_EQ(moved.x, expected.x);
}

}  // namespace
}  // namespace mirrorball::testing
