// Animations and morph targets that are damaged, or ask for too much.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/scene/gltf/gltf_animation_testing.h"

namespace mirrorball {
namespace {

using testing::AnimationMaker;
using testing::decodedScene;
using testing::decodedText;
using testing::GltfMaker;
using ::testing::HasSubstr;
using testing::TriangleFile;

/// The model is shown without what is wrong with its animation.
void expectAnimationTold(const TriangleFile& file, const std::string& animation, const std::string& part) {
  testing::expectTold(decodedText(file.json("\"animations\":[" + animation + "]")), part);
}

/// An animation with one channel.
std::string channel(const std::string& target, const std::string& sampler) {
  return R"({"samplers":[{)" + sampler + R"(}],"channels":[{"sampler":0,"target":{)" + target + "}}]}";
}

std::string pointing(const std::string& pointer) {
  return R"("path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":")" + pointer + "\"}}";
}

TEST(GltfAnimationDamage, NamesTheKeyOfAWrongIndex) {
  TriangleFile file;
  file.maker.accessor(std::vector<float>{0, 1, 2}, "SCALAR");  // 2
  const std::string moved = R"("node":0,"path":"translation")", sampler = R"("input":2,"output":0)";
  EXPECT_TRUE(decodedText(file.json("\"animations\":[" + channel(moved, sampler) + "]")));
  expectAnimationTold(file, "{}", "animations[0].samplers is missing");
  expectAnimationTold(file, R"({"samplers":[]})", "animations[0].channels is missing");
  expectAnimationTold(file, channel(R"("node":0)", sampler), "channels[0].target.path is missing");
  expectAnimationTold(file, channel(moved, "\"input\":2"), "animations[0].samplers[0].output is missing");
  expectAnimationTold(file, channel(moved, R"("input":9,"output":0)"),
                      "animations[0].samplers[0].input is 9, but there are 3 accessors");
  expectAnimationTold(file, channel(moved, R"("input":2,"output":9)"),
                      "animations[0].samplers[0].output is 9, but there are 3 accessors");
  expectAnimationTold(file, channel(moved, sampler + R"(,"interpolation":"CUBIC")"),
                      "animations[0].samplers[0].interpolation is 'CUBIC', and none of STEP, LINEAR and CUBICSPLINE");
  expectAnimationTold(file, R"({"samplers":[],"channels":[{"sampler":0,"target":{)" + moved + "}}]}",
                      "animations[0].channels[0].sampler is 0, but there are 0 samplers");
  expectAnimationTold(file, channel(R"("node":7,"path":"scale")", sampler),
                      "animations[0].channels[0].target.node leads to node 7, but there is 1 node");
  const std::string pointer_key = "animations[0].channels[0].target.extensions.KHR_animation_pointer.pointer";
  expectAnimationTold(file, channel(R"("path":"pointer")", sampler), pointer_key + " is missing");
  for (const char* pointer : {"/materials/0/alphaCutoff", "/cameras/5/perspective/yfov", "/nodes/99999999999999/scale",
                              "/extensions/KHR_lights_punctual/lights/3/color"})
    expectAnimationTold(file, channel(pointing(pointer), sampler), pointer_key + " leads to ");
}

TEST(GltfAnimationDamage, NamesTheKeyOfWrongNumbers) {
  TriangleFile file;
  const auto floats = [&](std::vector<float> numbers) {
    return std::to_string(file.maker.accessor(numbers, "SCALAR"));
  };
  const std::string moved = R"("node":0,"path":"translation")", turned = R"("node":0,"path":"rotation")";
  const auto sampler = [](const std::string& input, const std::string& output, const std::string& more = "") {
    return "\"input\":" + input + ",\"output\":" + output + more;
  };
  const auto reported = [&](const std::string& keys, const std::string& part) {
    expectAnimationTold(file, channel(moved, keys), part);
  };
  reported(sampler(floats({0, 2, 1}), "0"),
           "samplers[0].input has the time 1 in element 2, which is not after the one");
  reported(sampler(floats({0, 1, 1}), "0"),
           "samplers[0].input has the time 1 in element 2, which is not after the one");
  reported(sampler(floats({-1, 1, 2}), "0"), "samplers[0].input has the time -1 in element 0, before the start");
  reported(sampler(floats({0, std::nanf(""), 2}), "0"), "holds NaN or infinity in element 1");
  reported(sampler(floats({}), floats({})), "samplers[0].input has no times");
  reported(sampler("0", "0"), "samplers[0].input is no list of times");
  const std::string times = floats({0, 1, 2});
  reported(sampler(times, floats({1, 2})), "samplers[0].output has 2 numbers, but 3 times of 3 components take 9");
  reported(sampler(times, "0", R"(,"interpolation":"CUBICSPLINE")"),
           "samplers[0].output has 9 numbers, but 3 times of 3 components and their slopes take 27");
  expectAnimationTold(file, channel(turned, sampler(times, "0")), "3 times of 4 components take 12");
  reported(sampler(times, floats({0, 0, 0, 0, INFINITY, 0, 0, 0, 0})), "holds NaN or infinity in element 4");
  const int matrix = file.maker.accessor(std::vector<float>(16, 0.0f), "MAT4");
  reported(sampler(times, std::to_string(matrix)), "samplers[0].output has a type that samplers cannot have");
}

// Programs that join animations write a time twice where they meet.
TEST(GltfAnimationDamage, KeysWhoseTimesDoNotGrowAreLeftOut) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"translation")", {0, 1, 1, 2}, {0, 0, 0, 2, 0, 0, 9, 9, 9, 4, 0, 0}, "VEC3");
  const Result<Scene> scene = decodedText(file.json("\"animations\":[" + walk.json() + "]"));
  testing::expectTold(scene,
                      "samplers[0].input has the time 1 in element 2, which is not after the one before it; "
                      "the key is left out");
  testing::expectPlace(testing::placeOf(testing::decodedPose(*scene, 1.0), 0, 0), {2, 0, 0});
  testing::expectPlace(testing::placeOf(testing::decodedPose(*scene, 1.5), 0, 0), {3, 0, 0});
}

TEST(GltfAnimationDamage, OfAnAnimationTheOtherChannelsMove) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"rotation")", {0, 1}, {0, 0, 0, 1, NAN, 0, 0, 1}, "VEC4")
      .move(R"("node":0,"path":"translation")", {0, 1}, {0, 0, 0, 2, 0, 0}, "VEC3");
  const Result<Scene> scene = decodedText(file.json("\"animations\":[" + walk.json() + "]"));
  testing::expectTold(scene, "holds NaN or infinity in element 1; the animation's channel is left out");
  testing::expectPlace(testing::placeOf(testing::decodedPose(*scene, 1.0), 0, 0), {2, 0, 0});
}

TEST(GltfAnimationDamage, APoseThatIsTooLargeIsRefused) {
  TriangleFile file;
  AnimationMaker walk(file.maker);
  walk.move(R"("node":0,"path":"scale")", {0, 1}, {1, 1, 1, 3e38f, 1, 1}, "VEC3");
  const Scene rest = decodedScene(file.json("\"animations\":[" + walk.json() + "]"));
  EXPECT_TRUE(posed(rest, 0, 0.0));
  const Result<Scene> refused = posed(rest, 0, 1.0);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("transform that is too large"));
}

TEST(GltfMorphDamage, NamesTheKeyOfAWrongTarget) {
  TriangleFile file;
  const int two = file.maker.accessor(std::vector<float>(6, 0.0f), "VEC3");
  const int flat = file.maker.accessor(std::vector<float>(6, 0.0f), "VEC2");
  const int broken = file.maker.accessor(std::vector<float>{0, 0, 0, 0, std::nanf(""), 0, 0, 0, 0}, "VEC3");
  const auto reported = [&](const std::string& target, const std::string& part) {
    testing::expectTold(decodedText(file.json(R"("nodes":[{"mesh":0,"weights":[1]}])", target)), part);
  };
  const std::string key = "meshes[0].primitives[0].targets[0].";
  reported(R"({"POSITION":77})", key + "POSITION is 77, but there are");
  reported(file.targets(two), key + "POSITION has 2 elements, but POSITION has 3");
  reported(R"({"NORMAL":)" + std::to_string(flat) + "}", key + "NORMAL has 2 components");
  reported(file.targets(broken), "holds NaN or infinity in element 1");
  reported("3", "targets[0] is no object");
}

TEST(GltfMorphDamage, TargetsThatTakeTooMuchMemoryAreRefused) {
  TriangleFile file;
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{1} << 20);
  std::string targets = file.targets(0);
  for (int i = 0; i < 20000; ++i) targets += "," + file.targets(0);
  const Result<Scene> scene = decodedText(file.json(R"("nodes":[{"mesh":0,"weights":[1]}])", targets));
  setMemoryLimit(usual);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::too_large);
  EXPECT_THAT(scene.error().message, HasSubstr("1 MB may be used"));
}

TEST(GltfMorphDamage, ManyPartsOfManyNodesAreRefused) {
  TriangleFile file;
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(std::uint64_t{16} << 20);
  std::string primitives = R"({"attributes":{"POSITION":0}})", nodes = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < 1000; ++i) {
    primitives += R"(,{"attributes":{"POSITION":0}})";
    nodes += R"(,{"mesh":0})";
  }
  const Result<Scene> scene = decodedText(file.maker.gltf(primitives, nodes + "]"));
  setMemoryLimit(usual);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::too_large);
}

TEST(GltfAnimationDamage, ManyChannelsOfTheSameAreReadAtOnce) {
  TriangleFile file;
  std::vector<float> times, values;
  for (int i = 0; i < 20000; ++i) {
    times.push_back(static_cast<float>(i));
    values.insert(values.end(), {0, 0, 0});
  }
  const std::string input = std::to_string(file.maker.accessor(times, "SCALAR"));
  const std::string output = std::to_string(file.maker.accessor(values, "VEC3"));
  AnimationMaker walk(file.maker);
  for (int i = 0; i < 2000; ++i)
    walk.sample(R"("node":0,"path":"translation")", "\"input\":" + input + ",\"output\":" + output);
  const Scene rest = decodedScene(file.json("\"animations\":[" + walk.json() + "]"));
  EXPECT_EQ(rest.rig.animations.at(0).channels.size(), 1u);
}

TEST(GltfAnimationDamage, ABinaryFileSurvivesRandomDamage) {
  TriangleFile file;
  const std::string on = std::to_string(file.maker.accessor(std::vector<std::uint8_t>(12, 0), "VEC4"));
  const std::string by = std::to_string(file.maker.accessor(std::vector<float>(12, 0.25f), "VEC4"));
  AnimationMaker walk(file.maker);
  walk.move(R"("node":1,"path":"rotation")", {0, 1}, {0, 0, 0, 1, 0, 1, 0, 0}, "VEC4")
      .move(R"("node":0,"path":"weights")", {0, 1}, {0, 0, 0, 0, 1, 0}, "SCALAR", "CUBICSPLINE")
      .point("/nodes/1/scale", {0, 1}, {1, 1, 1, -1, 0, 2}, "VEC3");
  const Bytes whole = file.maker.glb(
      R"({"attributes":{"POSITION":0,"NORMAL":1,"JOINTS_0":)" + on + R"(,"WEIGHTS_0":)" + by + "},\"targets\":[" +
          file.targets(file.raised(1)) + "]}",
      R"("nodes":[{"mesh":0,"skin":0},{"mesh":0}],"skins":[{"joints":[1]}],"animations":[)" + walk.json() + "]");
  ASSERT_TRUE(decodeGltf(whole, "model.glb"));
  const std::size_t binary = 28 + whole[12] + std::size_t{256} * whole[13];
  std::mt19937 random(7);
  int posed_scenes = 0;
  for (int round = 0; round < 3000; ++round) {
    Bytes bytes = whole;
    // Mostly numbers: damaged JSON seldom goes far.
    const std::size_t first = round % 4 == 0 ? 0 : binary;
    for (int i = 0; i < 3; ++i) bytes[first + random() % (bytes.size() - first)] = static_cast<std::uint8_t>(random());
    const Result<Scene> scene = decodeGltf(bytes, "model.glb");
    if (!scene || scene->rig.animations.empty()) continue;
    for (const double seconds : {0.0, 0.5, 1.0})
      if (const Result<Scene> moment = posed(*scene, 0, seconds)) testing::expectSafe(*moment);
    ++posed_scenes;
  }
  EXPECT_GT(posed_scenes, 100);
}

}  // namespace
}  // namespace mirrorball
